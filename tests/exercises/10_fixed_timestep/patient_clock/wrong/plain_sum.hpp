// caught by: A million ticks of a sixtieth are n h to a few roundings
// message: what a plain sum gives
#pragma once

template <class Real>
void tick(Real& time, Real& owed, Real time_step) {
  const Real due = time_step + owed;
  const Real before = time;
  time = before + due;
  owed = (before + due) - time;
}

template <class Real>
Real shown_after(Real start, Real time_step, int ticks) {
  Real time = start, owed = 0;
  for (int n = 0; n < ticks; ++n) tick(time, owed, time_step);
  return time;
}
