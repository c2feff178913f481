/// @file
/// How a body yields where a force holds it, and what a held force does to its turning.
#pragma once

#include <algorithm>
#include <cmath>
#include <tumble/principal_axes.hpp>
#include <tumble/rigid_body.hpp>

namespace tumble {

/// How easily a force moves the point that it acts at, in whatever direction it acts, at most:
/// 1/kg. `arm` leads there from the centre of mass, m, body axes.
///
/// A force F at r gives the point the acceleration F/m + (J (r × F)) × r, where J is the inverse
/// tensor, so F meets the inverse mass 1/m + J(r × n, r × n) in its own direction n. The vectors
/// r × n fill the plane perpendicular to r. There J is a matrix of two by two, whose larger
/// eigenvalue is (A + B)/2 + √(((A − B)/2)² + C²).
//! [largest_inverse_mass_at]
template <class Real>
Real largest_inverse_mass_at(const RigidBody<Real>& body, const Vec3<Same<Real>>& arm) {
  const Real length = arm.norm();
  if (length == 0) return body.centre.inverse_mass;
  const Vec3<Real> n = arm / length;
  int least = 0;  // the axis that the arm is farthest from
  for (const int axis : {1, 2})
    if (std::abs(n[axis]) < std::abs(n[least])) least = axis;
  Vec3<Real> e = n.cross(Vec3<Real>::Unit(least));
  e /= e.norm();
  const Vec3<Real> f = n.cross(e), &J = body.top.inverse_moments;
  Real A = 0, B = 0, C = 0;
  for (int i = 0; i < 3; ++i) {
    A += J[i] * e[i] * e[i];
    B += J[i] * f[i] * f[i];
    C += J[i] * e[i] * f[i];
  }
  return body.centre.inverse_mass + length * length * ((A + B) / 2 + std::hypot((A - B) / 2, C));
}
//! [largest_inverse_mass_at]

/// How a force F (N) that keeps its direction, at an arm a (m) that turns with the body, resists a
/// small turn: N m/rad, in the axes of the two vectors.
///
/// A turn by θ moves the arm by θ × a, and the torque changes by (θ × a) × F = a (θ·F) − θ (a·F).
/// What resists is the opposite, (a·F) θ − a (F·θ). Its symmetric part is what a potential energy
/// can give; the other part belongs to the torque a × F, and the torques on a body in equilibrium
/// cancel.
//! [turning_stiffness]
template <class Real>
Mat3<Real> turning_stiffness(const Vec3<Real>& arm, const Vec3<Same<Real>>& force) {
  Mat3<Real> stiffness;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      stiffness(i, j) =
          (i == j ? dot(arm, force) : Real(0)) - (arm[i] * force[j] + force[i] * arm[j]) / 2;
  return stiffness;
}
//! [turning_stiffness]

/// The largest square of an angular frequency, (rad/s)², with which a stiffness against turns
/// (N m/rad, body axes) lets the body oscillate; 0 if it resists no turn.
///
/// That is the largest eigenvalue of √J K √J, where J holds the inverse moments.
template <class Real>
Real largest_turning_rate_squared(const RigidBody<Real>& body, const Mat3<Same<Real>>& stiffness) {
  const Vec3<Real>& J = body.top.inverse_moments;
  Mat3<Real> scaled;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) scaled(i, j) = std::sqrt(J[i]) * stiffness(i, j) * std::sqrt(J[j]);
  if (!is_finite(scaled)) return std::numeric_limits<Real>::infinity();
  return std::max(Real(0), principal_axes<Real>(scaled).moments.z());
}

}  // namespace tumble
