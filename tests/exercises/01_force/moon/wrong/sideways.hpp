// caught by: What falls near the Moon's ground gains 1.62 m/s downward in every second
// message: it points sideways
#pragma once
#include <tumble/force.hpp>

template <class Real>
tumble::Vec3<Real> gravity() {
  return {0, Real(-1.62), 0};
}

template <class Real>
Real highest_point(Real, Real) {
  return 0;
}
