// caught by: It grows at the rate that Euler's equations give
// message: Where do the moments come in?
#pragma once

#include <cmath>
#include <tumble/real.hpp>

template <class Real>
Real growth_rate(const tumble::Vec3<Real>& moments, int axis, Real spin) {
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  const bool is_middle = (moments[j] - moments[axis]) * (moments[axis] - moments[i]) > 0;
  return is_middle ? std::abs(spin) * std::sqrt(Real(0.5)) : 0;
}

template <class Real>
Real wobble_rate(const tumble::Vec3<Real>& moments, int axis, Real spin) {
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  const Real square =
      (moments[axis] - moments[i]) * (moments[axis] - moments[j]) / (moments[i] * moments[j]);
  return square > 0 ? std::abs(spin) * std::sqrt(square) : 0;
}
