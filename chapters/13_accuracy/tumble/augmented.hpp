/// @file
/// A second-order rule that carries the momentum.
#pragma once

#include <tumble/turning_rules.hpp>

namespace tumble {

/// The turn of a whole step as one rotation vector. If ω were ω + t ω̇ in the world, with ω̇
/// constant, the vector would be h ω + ½h² ω̇ + h³/12 ω̇ × ω + …, where the last term is there
/// because turns don't commute. ω̇ = I⁻¹ (L × ω) is the same seen from the world or from the body,
/// since ω × ω = 0.
///
/// This is the "augmented second-order" rule of Buss (2000). L is carried along, as in
/// turn_carrying_momentum().
//! [turn_by_augmented_rule]
template <class Real>
void turn_by_augmented_rule(Top<Real>& top, Same<Real> time_step) {
  const Vec3<Real> w = time_step * angular_velocity_body(top);  // rad, and so is its change:
  const Vec3<Real> change =
      time_step * time_step * top.inverse_moments.cwiseProduct(gyroscopic_torque(top));
  const Vec3<Real> angle = w + change / 2 + change.cross(w) / 12;
  const Quaternion<Real> turn = quaternion_of_rotation_vector(angle);
  top.angular_momentum_body = rotate_back(turn, top.angular_momentum_body);
  top.orientation = renormalized(top.orientation * turn);
}
//! [turn_by_augmented_rule]

}  // namespace tumble
