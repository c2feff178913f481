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
  todo("the rate of growth, where there is one");
}

/// The rate λ (rad/s) with which a tiny wobble goes round as cos(λt) in the body. 0 where it
/// doesn't.
template <class Real>
Real wobble_rate(const tumble::Vec3<Real>& moments, int axis, Real spin) {
  todo("the rate of the wobble, where there is one");
}
