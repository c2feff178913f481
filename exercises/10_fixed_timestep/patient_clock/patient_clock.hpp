/// @file
/// Exercise: a clock of two numbers, which adds up small steps for years.
#pragma once

#include <exercise/todo.hpp>

/// One tick. `time` (s) is what the clock shows; `owed` (s) is what it still has to be given, since
/// the sum was rounded: the true time is time + owed. A clock that is 0 owes 0.
template <class Real>
void tick(Real& time, Real& owed, Real time_step) {
  todo("add the step and what is owed, and find out what the sum has swallowed");
}

/// What a clock shows that began at `start` and owed nothing, after `ticks` ticks.
template <class Real>
Real shown_after(Real start, Real time_step, int ticks) {
  Real time = start, owed = 0;
  for (int n = 0; n < ticks; ++n) tick(time, owed, time_step);
  return time;
}
