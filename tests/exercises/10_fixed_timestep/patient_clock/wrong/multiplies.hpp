// caught by: A million ticks of a sixtieth are n h to a few roundings
// message: Leave shown_after as it was
#pragma once

template <class Real>
void tick(Real& time, Real& owed, Real time_step) {
  time += time_step;
  owed = 0;
}

template <class Real>
Real shown_after(Real start, Real time_step, int ticks) {
  return start + static_cast<Real>(ticks) * time_step;
}
