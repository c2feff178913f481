/// @file
/// What a top does between blows when it isn't round: Euler's equations, and when they have nothing
/// to say.
#pragma once

#include <tumble/orientation.hpp>
#include <tumble/top.hpp>

namespace tumble {

/// L × ω (N m, body axes): how fast the body sees its own angular momentum change while no torque
/// acts on it. The world's L stands still; the body turns beneath it.
//! [gyroscopic_torque]
template <class Real>
Vec3<Real> gyroscopic_torque(const Top<Real>& top) {
  return top.angular_momentum_body.cross(angular_velocity_body(top));
}
//! [gyroscopic_torque]

/// True when L × ω can move L: some moments differ, and no axis is locked. With one axis locked,
/// L and ω lie across it and L × ω along it, where whatever locks the axis bears it. Every other
/// top turns steadily, see turn_steadily().
//! [is_gyroscopic]
template <class Real>
bool is_gyroscopic(const Top<Real>& top) {
  const Vec3<Real>& inverse = top.inverse_moments;
  const bool round = inverse.x() == inverse.y() && inverse.y() == inverse.z();
  return !round && (inverse.array() != 0).all();
}
//! [is_gyroscopic]

}  // namespace tumble
