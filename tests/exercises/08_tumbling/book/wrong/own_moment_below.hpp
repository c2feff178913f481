// caught by: It grows at the rate that Euler's equations give
// message: the moment of the spin's own axis is in the denominator
#pragma once

#include <cmath>
#include <tumble/real.hpp>

template <class Real>
Real growth_rate(const tumble::Vec3<Real>& moments, int axis, Real spin) {
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  const Real square =
      (moments[j] - moments[axis]) * (moments[axis] - moments[i]) / (moments[i] * moments[axis]);
  return square > 0 ? std::abs(spin) * std::sqrt(square) : 0;
}

template <class Real>
Real wobble_rate(const tumble::Vec3<Real>& moments, int axis, Real spin) {
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  const Real square =
      (moments[axis] - moments[i]) * (moments[axis] - moments[j]) / (moments[i] * moments[axis]);
  return square > 0 ? std::abs(spin) * std::sqrt(square) : 0;
}
