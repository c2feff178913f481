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
  const Vec3<Real> e = (arm / length).unitOrthogonal(), f = (arm / length).cross(e);
  const Vec3<Real> J_e = body.top.inverse_moments.cwiseProduct(e);
  const Vec3<Real> J_f = body.top.inverse_moments.cwiseProduct(f);
  const Real A = dot(e, J_e), B = dot(f, J_f), C = dot(e, J_f);
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
  return dot(arm, force) * Mat3<Real>::Identity() -
         (arm * force.transpose() + force * arm.transpose()) / 2;
}
//! [turning_stiffness]

/// The largest square of an angular frequency, (rad/s)², with which a stiffness against turns
/// (N m/rad, body axes) lets the body oscillate; 0 if it resists no turn.
///
/// That is the largest eigenvalue of √J K √J, where J holds the inverse moments.
template <class Real>
Real largest_turning_rate_squared(const RigidBody<Real>& body, const Mat3<Same<Real>>& stiffness) {
  const Vec3<Real> root = body.top.inverse_moments.cwiseSqrt();
  const Mat3<Real> scaled = root.asDiagonal() * stiffness * root.asDiagonal();
  if (!scaled.allFinite()) return std::numeric_limits<Real>::infinity();
  return std::max(Real(0), principal_axes<Real>(scaled).moments.z());
}

}  // namespace tumble
