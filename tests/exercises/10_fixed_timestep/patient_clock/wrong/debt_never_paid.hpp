// caught by: The clock never owes more than half of the spacing of its time
// message: A debt that can be paid must be
#pragma once

template <class Real>
void tick(Real& time, Real& owed, Real time_step) {
  const Real due = time_step;
  const Real before = time;
  time = before + due;
  owed += due - (time - before);
}

template <class Real>
Real shown_after(Real start, Real time_step, int ticks) {
  Real time = start, owed = 0;
  for (int n = 0; n < ticks; ++n) tick(time, owed, time_step);
  return time;
}
