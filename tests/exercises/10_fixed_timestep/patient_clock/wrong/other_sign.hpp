// caught by: What a tick adds is in the time and in what is owed, to the last bit
// message: right, but for the sign
#pragma once

template <class Real>
void tick(Real& time, Real& owed, Real time_step) {
  const Real due = time_step - owed;
  const Real before = time;
  time = before + due;
  owed = (time - before) - due;
}

template <class Real>
Real shown_after(Real start, Real time_step, int ticks) {
  Real time = start, owed = 0;
  for (int n = 0; n < ticks; ++n) tick(time, owed, time_step);
  return time;
}
