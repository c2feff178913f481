/// @file
/// How an orientation changes with time: its rate, and two rules that step it.
#pragma once

#include <tumble/rotation_vector.hpp>

namespace tumble {

/// The rate of change of an orientation (1/s): q̇ = ½ ω q, with `angular_velocity_world` (rad/s) in
/// world axes, on the left.
//! [rate]
template <class Real>
Quaternion<Real> orientation_rate(const Quaternion<Real>& orientation,
                                  const Vec3<Same<Real>>& angular_velocity_world) {
  return pure<Real>(angular_velocity_world / 2) * orientation;
}

/// The same rate from the angular velocity (rad/s) in body axes, on the right: q̇ = ½ q ω.
template <class Real>
Quaternion<Real> orientation_rate_body(const Quaternion<Real>& orientation,
                                       const Vec3<Same<Real>>& angular_velocity_body) {
  return orientation * pure<Real>(angular_velocity_body / 2);
}
//! [rate]

/// The orientation after `time_step` seconds (h) by the first-order rule: q + h ½ ω q, normalised.
///
/// It turns about the right axis, by 2 atan(|ω|h/2) instead of |ω|h, as long as the square of |ω|h
/// is in the range of Real; beyond it the result is 0, which is no orientation: see require_turn().
/// `angular_velocity_world` in rad/s, world axes.
//! [first_order]
template <class Real>
Quaternion<Real> turn_first_order(const Quaternion<Real>& orientation,
                                  const Vec3<Same<Real>>& angular_velocity_world,
                                  Same<Real> time_step) {
  return renormalized(orientation +
                      time_step * orientation_rate(orientation, angular_velocity_world));
}
//! [first_order]

/// The same with the angular velocity (rad/s) in body axes.
template <class Real>
Quaternion<Real> turn_first_order_body(const Quaternion<Real>& orientation,
                                       const Vec3<Same<Real>>& angular_velocity_body,
                                       Same<Real> time_step) {
  return renormalized(orientation +
                      time_step * orientation_rate_body(orientation, angular_velocity_body));
}

/// The orientation after `time_step` seconds (h) by the exponential: e^(hω/2) q, the exact one if ω
/// stays the same meanwhile. `angular_velocity_world` in rad/s, world axes.
///
/// Turns of any size are right, up to the limit of quaternion_of_rotation_vector(), beyond which
/// the result is NaN; see require_turn().
//! [exponential]
template <class Real>
Quaternion<Real> turn_exponential(const Quaternion<Real>& orientation,
                                  const Vec3<Same<Real>>& angular_velocity_world,
                                  Same<Real> time_step) {
  const Vec3<Real> turn = time_step * angular_velocity_world;
  return renormalized(quaternion_of_rotation_vector(turn) * orientation);
}

/// The same with the angular velocity (rad/s) in body axes: q e^(hω/2).
template <class Real>
Quaternion<Real> turn_exponential_body(const Quaternion<Real>& orientation,
                                       const Vec3<Same<Real>>& angular_velocity_body,
                                       Same<Real> time_step) {
  const Vec3<Real> turn = time_step * angular_velocity_body;
  return renormalized(orientation * quaternion_of_rotation_vector(turn));
}
//! [exponential]

/// Checks where they enter that an angular velocity (rad/s) and a time step (s) make a turn that
/// turn_exponential() can answer.
/// @throws std::invalid_argument if either is not finite, or if the turn is larger than twice
/// SineCosineConstants::limit: 3072 rad in float, 3145728 rad in double.
//! [require_turn]
template <class Real>
void require_turn(const Vec3<Real>& angular_velocity, Same<Real> time_step) {
  require_finite("angular velocity", angular_velocity, "rad/s");
  require_finite("time step", time_step, "s");
  const Vec3<Real> turn = time_step * angular_velocity;
  const Real half_angle = (turn / 2).norm();  // rounded as in quaternion_of_rotation_vector()
  require_between("turn in one step", 2 * half_angle, "rad", 0,
                  2 * SineCosineConstants<Real>::limit);
}
//! [require_turn]

}  // namespace tumble
