/// @file
/// Lab: how a film shows a wheel with spokes.
#pragma once

#include <cmath>
#include <exercise/todo.hpp>
#include <numbers>

/// By which angle (rad) a wheel seems to have turned from one picture to the next, that has turned
/// by `turn` (rad). It has `spokes` equal spokes, at equal angles. The eye takes the smallest turn
/// that leads from the one picture to the other; negative is backward.
template <class Real>
Real seen_turn(Real turn, int spokes) {
  todo("the smallest turn that leads from one picture to the next");
}

/// How fast (rad/s) a wheel seems to turn that turns at `rate` (rad/s), in a film with so many
/// pictures a second.
template <class Real>
Real seen_rate(Real rate, int spokes, Real pictures_per_second) {
  todo("what is seen from picture to picture, in a second");
}

/// The slowest rate (rad/s) above 0 at which the wheel seems to stand still.
template <class Real>
Real standing_rate(int spokes, Real pictures_per_second) {
  todo("the rate at which each spoke takes the place of the next");
}
