/// @file
/// Six ways to step a free top, five of which some engine ships. Each takes the top through
/// `time_step` seconds (h) without torque.
#pragma once

#include <tumble/euler_equations.hpp>

namespace tumble {

/// Turns about the present ω by |ω| h; ω and L stay what they are in body axes, and so does ω in
/// world axes. This is the rule "no torque, so ω is constant". It is exact where L × ω is zero: for
/// equal moments, a spin about a principal axis, a locked axis. Elsewhere it turns L in the world.
//! [turn_steadily]
template <class Real>
void turn_steadily(Top<Real>& top, Same<Real> time_step) {
  const Vec3<Real> angle = time_step * angular_velocity_body(top);
  top.orientation = normalized(top.orientation * quaternion_of_rotation_vector(angle));
}
//! [turn_steadily]

/// Euler's equations by explicit Euler: L ← L + h L × ω, then turn. The addition is square to L, so
/// |L| grows in every step, and the energy with it, without bound.
//! [turn_explicit]
template <class Real>
void turn_explicit(Top<Real>& top, Same<Real> time_step) {
  top.angular_momentum_body += time_step * gyroscopic_torque(top);
  turn_steadily(top, time_step);
}
//! [turn_explicit]

/// The same, with |L| brought back to what it was. Nothing brings the energy back.
//! [turn_restoring]
template <class Real>
void turn_restoring_momentum(Top<Real>& top, Same<Real> time_step) {
  const Real before = top.angular_momentum_body.squaredNorm();
  top.angular_momentum_body += time_step * gyroscopic_torque(top);
  const Real after = top.angular_momentum_body.squaredNorm();
  using std::sqrt;
  top.angular_momentum_body *= select(after > 0, sqrt(before / after), Real(1));
  turn_steadily(top, time_step);
}
//! [turn_restoring]

/// Euler's equations by implicit Euler: the new ω solves I (ω − ω₀) = h (I ω) × ω. One Newton step
/// from ω₀ is I (ω − ω₀) + h (…)
//! [turn_implicit]
template <class Real>
void turn_implicit(Top<Real>& top, Same<Real> time_step) {
  const Vec3<Real> moments = moments_of(top), angular_velocity = angular_velocity_body(top);
  const Vec3<Real> residual = -time_step * gyroscopic_torque(top);
  Mat3<Real> jacobian = moments.asDiagonal();
  const auto& L = top.angular_momentum_body;
  Mat3<Real> w, l;
  w << 0, -angular_velocity.z(), angular_velocity.y(), angular_velocity.z(), 0, -angular_velocity.x(), -angular_velocity.y(), angular_velocity.x(), 0;
  l << 0, -L.z(), L.y(), L.z(), 0, -L.x(), -L.y(), L.x(), 0;
  jacobian += time_step * (w * moments.asDiagonal() - l);
  Vec3<Real> wn = angular_velocity - jacobian.inverse() * residual;
  top.angular_momentum_body = moments.cwiseProduct(wn);
  turn_steadily(top, time_step);
}
//! [turn_implicit]

/// Keeps L in the world: turns about the present ω, and looks at the same L from the turned body.
//! [turn_carrying]
template <class Real>
void turn_carrying_momentum(Top<Real>& top, Same<Real> time_step) {
  const Vec3<Real> angle = time_step * angular_velocity_body(top);
  const Quaternion<Real> turn = quaternion_of_rotation_vector(angle);
  top.angular_momentum_body = rotate_back(turn, top.angular_momentum_body);
  top.orientation = normalized(top.orientation * turn);
}
//! [turn_carrying]

}  // namespace tumble
