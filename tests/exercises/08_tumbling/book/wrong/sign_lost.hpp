// caught by: A small wobble grows about the middle axis, and about no other
// message: Is a sign lost?
#pragma once

#include <cmath>
#include <tumble/real.hpp>

template <class Real>
Real growth_rate(const tumble::Vec3<Real>& moments, int axis, Real spin) {
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  const Real square =
      (moments[j] - moments[axis]) * (moments[axis] - moments[i]) / (moments[i] * moments[j]);
  return std::abs(spin) * std::sqrt(std::abs(square));
}

template <class Real>
Real wobble_rate(const tumble::Vec3<Real>& moments, int axis, Real spin) {
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  const Real square =
      (moments[axis] - moments[i]) * (moments[axis] - moments[j]) / (moments[i] * moments[j]);
  return std::abs(spin) * std::sqrt(std::abs(square));
}
