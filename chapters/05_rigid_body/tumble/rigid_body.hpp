/// @file
/// A rigid body: a particle at its centre of mass, and a top about it.
#pragma once

#include <tumble/force.hpp>
#include <tumble/pose.hpp>
#include <tumble/top.hpp>
#include <tumble/torque.hpp>

namespace tumble {

/// What a world stores of a rigid body.
//! [rigid_body]
template <class Real>
struct RigidBody {
  Particle<Real> centre;  ///< how the centre of mass moves
  Top<Real> top;          ///< how the body turns about it
};
//! [rigid_body]

using Bodyf = RigidBody<float>;
using Bodyd = RigidBody<double>;

/// The pose of the body axes in the world: the physical pose.
template <class Real>
Pose<Real> pose_of(const RigidBody<Real>& body) {
  return {.position = body.centre.position, .orientation = body.top.orientation};
}

/// The pose in which the model is drawn. `model_in_body` is the pose of the model's own axes, seen
/// from the body axes: a constant of the body, see make_rigid_body().
//! [drawn_pose]
template <class Real>
Pose<Real> drawn_pose(const RigidBody<Real>& body, const Pose<Same<Real>>& model_in_body) {
  return composed(pose_of(body), model_in_body);
}
//! [drawn_pose]

/// Adds `force` (N, world axes) that acts at `point` (m, world axes): chapter 1's sum and chapter
/// 2's, about the centre of mass.
/// @throws std::invalid_argument if either is not finite; the body is then unchanged.
//! [add_force_at]
template <class Real>
void add_force_at(RigidBody<Real>& body, const Vec3<Same<Real>>& force,
                  const Vec3<Same<Real>>& point) {
  require_finite("force", force, "N");
  require_finite("point", point, "m");
  body.centre.force += force;
  body.top.torque += torque_about(body.centre.position, point, force);
}
//! [add_force_at]

/// Adds `force` (N, world axes) that acts at the centre of mass.
/// @throws std::invalid_argument if it is not finite; the body is then unchanged.
template <class Real>
void add_force(RigidBody<Real>& body, const Vec3<Same<Real>>& force) {
  add_force(body.centre, force);
}

/// Adds `torque` (N m, world axes) with no net force.
/// @throws std::invalid_argument if it is not finite; the body is then unchanged.
template <class Real>
void add_torque(RigidBody<Real>& body, const Vec3<Same<Real>>& torque) {
  add_torque(body.top, torque);
}

/// Empties both accumulators. Call it exactly once in every step.
template <class Real>
void clear_forces(RigidBody<Real>& body) {
  clear_force(body.centre);
  clear_torque(body.top);
}

/// A blow: a force times the short time that it lasts, `impulse` in N s, at `point` in m, both in
/// world axes. It changes both momenta at once.
/// @throws std::invalid_argument if either is not finite; the body is then unchanged.
template <class Real>
void apply_impulse_at(RigidBody<Real>& body, const Vec3<Same<Real>>& impulse,
                      const Vec3<Same<Real>>& point) {
  require_finite("impulse", impulse, "N s");
  require_finite("point", point, "m");
  body.centre.velocity += body.centre.inverse_mass * impulse;
  add_angular_momentum(body.top, torque_about(body.centre.position, point, impulse));
}

/// The velocity (m/s, world axes) of the part of the body that is now at `point` (m, world axes):
/// v + ω × (p − x).
template <class Real>
Vec3<Real> velocity_at(const RigidBody<Real>& body, const Vec3<Same<Real>>& point) {
  return body.centre.velocity +
         angular_velocity_world(body.top).cross(point - body.centre.position);
}

/// ½ m v² of the centre of mass, in J; 0 for a static one.
template <class Real>
Real kinetic_energy(const Particle<Real>& particle) {
  return mass_of(particle) * particle.velocity.squaredNorm() / 2;
}

/// The energy of motion, in J. Chapter 3 derives why the two parts simply add.
template <class Real>
Real kinetic_energy(const RigidBody<Real>& body) {
  return kinetic_energy(body.centre) + kinetic_energy(body.top);
}

/// m v, in kg m/s, world axes.
template <class Real>
Vec3<Real> momentum(const Particle<Real>& particle) {
  return mass_of(particle) * particle.velocity;
}

template <class Real>
Vec3<Real> momentum(const RigidBody<Real>& body) {
  return momentum(body.centre);
}

/// The angular momentum about `point` (m), in kg m²/s, world axes: that of turning about the centre
/// of mass, and that of the whole mass moving past the point.
template <class Real>
Vec3<Real> angular_momentum_about(const RigidBody<Real>& body, const Vec3<Same<Real>>& point) {
  const Vec3<Real> p = momentum(body);
  return angular_momentum_world(body.top) + (body.centre.position - point).cross(p);
}

}  // namespace tumble
