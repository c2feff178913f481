// caught by: What a tick adds is in the time and in what is owed, to the last bit
// message: A tick must move the clock
#pragma once

template <class Real>
void tick(Real&, Real& owed, Real time_step) {
  owed += time_step;
}

template <class Real>
Real shown_after(Real start, Real time_step, int ticks) {
  Real time = start, owed = 0;
  for (int n = 0; n < ticks; ++n) tick(time, owed, time_step);
  return time;
}
