/// @file
/// Five simple rules for a top without torque, all of them wrong somewhere. Each takes it through
/// one step of h seconds.
#pragma once

#include <tumble/euler_equations.hpp>

namespace tumble {

/// Turns by |ω| h about the present ω. Then ω is what it was in world axes, and as it is the axis
/// of the turn, in body axes too. So L stays as it was in body axes, and turns with the body in the
/// world.
///
/// This is the rule "no torque, so ω is constant". It is exact where L × ω is zero, for equal
/// moments and for a spin about a principal axis, and where an axis is locked, which bears it.
//! [turn_steadily]
template <class Real>
void turn_steadily(Top<Real>& top, Same<Real> time_step) {
  top.orientation = turn_exponential_body(top.orientation, angular_velocity_body(top), time_step);
}
//! [turn_steadily]

/// Euler's equations by explicit Euler, L ← L + h L × ω, then the turn. What is added is
/// perpendicular to L, so |L| grows in every step, and the energy with it: without bound, unless
/// the top spins about a principal axis, where L × ω is zero and nothing is added.
//! [turn_explicitly]
template <class Real>
void turn_explicitly(Top<Real>& top, Same<Real> time_step) {
  top.angular_momentum_body += time_step * gyroscopic_torque(top);
  turn_steadily(top, time_step);
}
//! [turn_explicitly]

/// The same, with |L| brought back to what it was before the turn. Nothing brings the energy back.
//! [turn_restoring_momentum]
template <class Real>
void turn_restoring_momentum(Top<Real>& top, Same<Real> time_step) {
  using std::sqrt;
  Vec3<Real>& L = top.angular_momentum_body;
  const Real square_before = L.squaredNorm();
  L += time_step * gyroscopic_torque(top);
  L *= select(square_before > 0, sqrt(square_before / L.squaredNorm()), Real(1));
  turn_steadily(top, time_step);
}
//! [turn_restoring_momentum]

/// The matrix [v] with [v] x = v × x.
template <class Real>
Mat3<Real> cross_matrix(const Vec3<Real>& v) {
  Mat3<Real> matrix;
  matrix << 0, -v.z(), v.y(),  //
      v.z(), 0, -v.x(),        //
      -v.y(), v.x(), 0;
  return matrix;
}

/// The x with M x = right, by Cramer's rule. Exact enough, and without a choice of pivot, where M
/// has no unit and stays near 1.
template <class Real>
Vec3<Real> solved(const Mat3<Real>& M, const Vec3<Same<Real>>& right) {
  const Vec3<Real> a = M.col(0), b = M.col(1), c = M.col(2);
  const Vec3<Real> b_c = b.cross(c), c_a = c.cross(a), a_b = a.cross(b);
  return Vec3<Real>(dot(b_c, right), dot(c_a, right), dot(a_b, right)) / dot(a, b_c);
}

/// Euler's equations by implicit Euler: L' = L + h L' × ω', with ω' = I⁻¹ L'. One step of Newton's
/// method from L solves it nearly: a change d of L' changes L' × ω' by d × ω + L × I⁻¹ d, so
/// (1 + h [ω] − h [L] I⁻¹) d = h L × ω. The matrix has no unit, so it suits small bodies and large.
//! [turn_implicitly]
template <class Real>
void turn_implicitly(Top<Real>& top, Same<Real> time_step) {
  Vec3<Real>& L = top.angular_momentum_body;
  const Mat3<Real> change =
      cross_matrix(angular_velocity_body(top)) - cross_matrix(L) * top.inverse_moments.asDiagonal();
  const Mat3<Real> newton = Mat3<Real>::Identity() + time_step * change;
  L += solved<Real>(newton, time_step * gyroscopic_torque(top));
  turn_steadily(top, time_step);
}
//! [turn_implicitly]

/// Turns by |ω| h about the present ω, and keeps L in the world: seen from the turned body, it has
/// turned back. Exact in L, first order in all else.
//! [turn_carrying_momentum]
template <class Real>
void turn_carrying_momentum(Top<Real>& top, Same<Real> time_step) {
  const Vec3<Real> angle = time_step * angular_velocity_body(top);
  const Quaternion<Real> turn = quaternion_of_rotation_vector(angle);
  top.angular_momentum_body = rotate_back(turn, top.angular_momentum_body);
  top.orientation = renormalized(top.orientation * turn);
}
//! [turn_carrying_momentum]

}  // namespace tumble
