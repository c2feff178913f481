/// @file
/// The splitting of a free top with turns that need no sine.
#pragma once

#include <tumble/splitting.hpp>

namespace tumble {

/// Turns by 2 atan(angle/2) about a body axis, and leaves the quaternion √(1 + (angle/2)²) too
/// long: with t for tan(a/2), it is 1 + t axis. No sine, no root.
//! [turn_about_axis_without_sine]
template <int axis, class Real>
void turn_about_axis_without_sine(Top<Real>& top, Same<Real> angle) {
  const Real t = angle / 2;
  turn_by_half<axis, Real>(top, 1, t, 2 * t / (1 + t * t));
}
//! [turn_about_axis_without_sine]

/// turn_by_splitting() with chapter 7's first-order turns: each is too small by angle³/12. It is a
/// turn all the same, and how far it goes depends on what it leaves alone. So L is exact, the
/// energy bounded and the step symmetric in time, as with sines.
template <class Real>
void turn_by_splitting_without_sine(Top<Real>& top, Same<Real> time_step) {
  const auto [a, b, c] =
      std::array{top.inverse_moments[0], top.inverse_moments[1], top.inverse_moments[2]};
  const Vec3<Real> before = top.angular_momentum_body;
  const Vec3<Real>& L = top.angular_momentum_body;
  turn_about_axis_without_sine<1>(top, time_step / 2 * ((b - a) * L[1]));
  turn_about_axis_without_sine<2>(top, time_step * ((c - a) * L[2]));
  turn_about_axis_without_sine<1>(top, time_step / 2 * ((b - a) * L[1]));
  top.angular_momentum_body = with_length_of(before, L);
  const Vec3<Real> t = time_step / 2 * a * L;
  top.orientation = normalized(top.orientation * Quaternion<Real>{1, t});
}

}  // namespace tumble
