/// @file
/// Turns as an axis and an angle: into a quaternion and out of one.
#pragma once

#include <numbers>
#include <tumble/quaternion.hpp>
#include <tumble/sine_cosine.hpp>

namespace tumble {

/// The turn by |v| rad about the direction of v (`rotation_vector`): the exponential of v/2, that
/// is cos(|v|/2) and sin(|v|/2) v/|v|.
///
/// Where |v| is so small that its square underflows, sin(|v|/2)/(|v|/2) is 1 and v/2 is right as
/// it stands. Sizes beyond twice SineCosineConstants::limit give NaN: 3072 rad in float, 3145728
/// rad in double.
//! [exponential]
template <class Real>
Quaternion<Real> quaternion_of_rotation_vector(const Vec3<Real>& rotation_vector) {
  const Vec3<Real> half = rotation_vector / 2;
  const Real half_angle = half.norm();
  const SineCosine<Real> half_turn = sine_cosine(half_angle);
  return {.real = half_turn.cosine,
          .imaginary = sine_over_angle(half_turn.sine, half_angle) * half};
}
//! [exponential]

/// The shortest turn that q stands for: its direction is the axis, its length the angle, 0 to π
/// rad. The inverse of quaternion_of_rotation_vector() for lengths below π; q and −q give one
/// vector. (At π both directions are right, and the sign of the real part's zero chooses.) The norm
/// of q does not matter, as long as its square neither under- nor overflows.
//! [logarithm]
template <class Real>
Vec3<Real> rotation_vector_of(const Quaternion<Real>& q) {
  const Real size = q.imaginary.norm();  // 0 where its square underflows
  const Real half_angle = std::atan2(size, std::abs(q.real));
  const Real factor = select(size == 0, 1 / std::abs(q.real), half_angle / size);
  return (std::copysign(Real(2), q.real) * factor) * q.imaginary;
}
//! [logarithm]

/// The angle (rad, 0 to π) of the shortest turn from p to q. Never by the arc cosine of the real
/// part, which is 0 for all angles below the root of the rounding error.
//! [angle_between]
template <class Real>
Real angle_between(const Quaternion<Real>& p, const Quaternion<Real>& q) {
  const Quaternion<Real> between = conjugate(p) * q;
  const Vec3<Real>& u = between.imaginary;
  return 2 * std::atan2(std::hypot(u.x(), u.y(), u.z()), std::abs(between.real));
}
//! [angle_between]

/// The turn by `angle` rad about `axis`, a direction of any length, in world axes: cos(angle/2) and
/// sin(angle/2) times the unit vector along the axis.
/// @throws std::invalid_argument if the axis is zero or not finite, or if the angle is not finite
/// or more than twice SineCosineConstants::limit.
//! [about]
template <class Real>
Quaternion<Real> quaternion_about(const Vec3<Real>& axis, Same<Real> angle) {
  require_finite("axis", axis, "");
  if ((axis.array() == 0).all()) reject("axis", axis, "", "it needs a direction");
  const Real limit = 2 * SineCosineConstants<Real>::limit;
  require_between("angle", angle, "rad", -limit, limit);
  const SineCosine<Real> half_turn = sine_cosine(angle / 2);
  // Scaled to about 1, so that no square over- or underflows.
  const Vec3<Real> direction = (axis / axis.cwiseAbs().maxCoeff()).normalized();
  return {.real = half_turn.cosine, .imaginary = half_turn.sine * direction};
}
//! [about]

}  // namespace tumble
