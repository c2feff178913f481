// caught by: What falls near the Moon's ground gains 1.62 m/s downward in every second
// message: everything would fall upward
#pragma once
#include <tumble/force.hpp>

template <class Real>
tumble::Vec3<Real> gravity() {
  return {0, 0, Real(1.62)};
}

template <class Real>
Real highest_point(Real speed, Real time_step) {
  return speed * speed / Real(2 * 1.62) - time_step * speed / 2;
}
