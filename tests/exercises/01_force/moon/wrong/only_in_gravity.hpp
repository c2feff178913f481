// caught by: The same throw rises six times as high as on Earth
// message: that is how high it rises on Earth
#pragma once
#include <tumble/force.hpp>

template <class Real>
tumble::Vec3<Real> gravity() {
  return {0, 0, Real(-1.62)};
}

template <class Real>
Real highest_point(Real speed, Real time_step) {
  return speed * speed / Real(2 * 9.81) - time_step * speed / 2;
}
