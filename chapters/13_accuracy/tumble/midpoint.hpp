/// @file
/// Two implicit rules that take ω from the middle of the step, and keep what Euler's equations
/// keep.
#pragma once

#include <limits>
#include <tumble/turning_rules.hpp>

namespace tumble {

/// Newton's method: `vector` is improved by `correction_of(vector)` until a correction is below the
/// root of a rounding: the next, about its square, is the last.
///
/// It squares a small error in each round. A start from which it does not get there, at angles of
/// several radians a step, is left after 20.
//! [newton]
template <class Real, class Correction>
Vec3<Real> newton(Vec3<Real> vector, const Correction& correction_of) {
  const Real small_square = std::numeric_limits<Real>::epsilon();
  bool close = false;
  for (int round = 0; round < 20; ++round) {
    const Vec3<Real> correction = correction_of(vector);
    vector += correction;
    if (close) break;
    close = correction.squaredNorm() <= small_square * vector.squaredNorm();
  }
  return vector;
}
//! [newton]

/// The implicit midpoint rule, L' = L + h M × ω with M = ½ (L + L') and ω = I⁻¹ M. Half of it,
/// M = L + ½h M × I⁻¹ M, is chapter 8's implicit Euler over half a step, solved to the end here.
///
/// What is added is perpendicular to M and to ω, so |L| and the energy both stay. And L' = L − h ω
/// × M says that L is turned back by the first-order rule of chapter 7; turned by the same rule,
/// the body keeps L in the world. All that is wrong is the phase, to second order.
//! [turn_by_implicit_midpoint]
template <class Real>
void turn_by_implicit_midpoint(Top<Real>& top, Same<Real> time_step) {
  const Vec3<Real>& inverse = top.inverse_moments;
  const Vec3<Real> L = top.angular_momentum_body;
  const Real half = time_step / 2;
  const Vec3<Real> middle = newton<Real>(L, [&](const Vec3<Real>& M) -> Vec3<Real> {
    const Vec3<Real> w = inverse.cwiseProduct(M);
    const Mat3<Real> change = cross_matrix(w) - cross_matrix(M) * inverse.asDiagonal();
    return solved<Real>(Mat3<Real>::Identity() + half * change, L + half * M.cross(w) - M);
  });
  top.angular_momentum_body = 2 * middle - L;
  top.orientation =
      turn_first_order_body<Real>(top.orientation, inverse.cwiseProduct(middle), time_step);
}
//! [turn_by_implicit_midpoint]

/// How the turn about `vector` (rad) answers to a small change d of the vector: by one more turn,
/// T d, in the axes that it has turned. T = 1 − a [v] + b [v]² with a = (1 − cos θ)/θ² and
/// b = (θ − sin θ)/θ³, here by the first terms of their series: Newton's method corrects itself.
template <class Real>
Mat3<Real> change_of_turn(const Vec3<Real>& vector) {
  const Real square = vector.squaredNorm();
  const Real a = Real(1) / 2 - square / 24 * (1 - square / 30 * (1 - square / 56));
  const Real b = Real(1) / 6 - square / 120 * (1 - square / 42 * (1 - square / 72));
  const Mat3<Real> cross = cross_matrix(vector);
  return Mat3<Real>::Identity() - a * cross + b * cross * cross;
}

/// The Lie midpoint rule: as seen after half the turn v, the momentum is M = e^(−v/2) L, and it
/// gives the turn, v = h I⁻¹ M. Two such turns by v/2 make the step, and L is carried along.
///
/// L is kept in the world, and the step is the same forwards and backwards. The energy is not kept,
/// but wavers within bounds. Second order.
//! [turn_by_lie_midpoint]
template <class Real>
void turn_by_lie_midpoint(Top<Real>& top, Same<Real> time_step) {
  const Vec3<Real> L = top.angular_momentum_body;
  const Vec3<Real> half_turn_each = time_step / 2 * top.inverse_moments;  // v/2 = this times M
  const Vec3<Real> middle = newton<Real>(L, [&](const Vec3<Real>& M) -> Vec3<Real> {
    const Vec3<Real> half_turn = half_turn_each.cwiseProduct(M);
    const Vec3<Real> turned = rotate_back(quaternion_of_rotation_vector(half_turn), L);
    const Mat3<Real> change =
        cross_matrix(turned) * change_of_turn(half_turn) * half_turn_each.asDiagonal();
    return solved<Real>(Mat3<Real>::Identity() - change, turned - M);
  });
  const Vec3<Real> half_turn = half_turn_each.cwiseProduct(middle);
  const Quaternion<Real> half = quaternion_of_rotation_vector(half_turn);
  top.angular_momentum_body = rotate_back(half, rotate_back(half, L));
  top.orientation = renormalized((top.orientation * half) * half);
}
//! [turn_by_lie_midpoint]

}  // namespace tumble
