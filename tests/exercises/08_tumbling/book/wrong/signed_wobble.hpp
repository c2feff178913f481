// caught by: About the outer axes it wobbles as predicted
// message: whichever way the body spins
#pragma once

#include <cmath>
#include <tumble/real.hpp>

template <class Real>
Real growth_rate(const tumble::Vec3<Real>& moments, int axis, Real spin) {
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  const Real square =
      (moments[j] - moments[axis]) * (moments[axis] - moments[i]) / (moments[i] * moments[j]);
  return square > 0 ? std::abs(spin) * std::sqrt(square) : 0;
}

template <class Real>
Real wobble_rate(const tumble::Vec3<Real>& moments, int axis, Real spin) {
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  const Real square =
      (moments[axis] - moments[i]) * (moments[axis] - moments[j]) / (moments[i] * moments[j]);
  return square > 0 ? spin * std::sqrt(square) : 0;
}
