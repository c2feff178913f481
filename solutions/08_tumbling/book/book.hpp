/// @file
/// Exercise: how a wobble grows, or goes round, about each axis of a body.
#pragma once

#include <cmath>
#include <exercise/todo.hpp>
#include <tumble/real.hpp>

/// The rate κ (1/s) with which a tiny wobble grows as e^(κt), for a body with these principal
/// `moments` (kg m²) that spins with `spin` rad/s about its `axis` 0, 1 or 2. 0 where none grows.
template <class Real>
Real growth_rate(const tumble::Vec3<Real>& moments, int axis, Real spin) {
  //! [solution] the rate of growth, where there is one
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  const Real square =
      (moments[j] - moments[axis]) * (moments[axis] - moments[i]) / (moments[i] * moments[j]);
  return square > 0 ? std::abs(spin) * std::sqrt(square) : 0;
  //! [end]
}

/// The rate λ (rad/s) with which a tiny wobble goes round as cos(λt) in the body. 0 where it
/// doesn't.
template <class Real>
Real wobble_rate(const tumble::Vec3<Real>& moments, int axis, Real spin) {
  //! [solution] the rate of the wobble, where there is one
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  const Real square =
      (moments[axis] - moments[i]) * (moments[axis] - moments[j]) / (moments[i] * moments[j]);
  return square > 0 ? std::abs(spin) * std::sqrt(square) : 0;
  //! [end]
}
