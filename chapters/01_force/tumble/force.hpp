/// @file
/// Forces on a particle, gravity in two ways, and the first step through time.
#pragma once

#include <tumble/particle.hpp>

namespace tumble {

/// Adds `force` (N, world axes) to what already acts in this step.
/// @throws std::invalid_argument if the force is not finite; the particle is then unchanged.
//! [add_force]
template <class Real>
void add_force(Particle<Real>& particle, const Vec3<Same<Real>>& force) {
  require_finite("force", force, "N");
  particle.force += force;
}
//! [add_force]

/// Empties the accumulator. Call it exactly once in every step.
//! [clear_force]
template <class Real>
void clear_force(Particle<Real>& particle) {
  particle.force.setZero();
}
//! [clear_force]

/// Gravity as a force: F = m g, with `gravity` in m/s², world axes. A static particle feels none.
//! [add_gravity]
template <class Real>
void add_gravity(Particle<Real>& particle, const Vec3<Same<Real>>& gravity) {
  particle.force += mass_of(particle) * gravity;
}
//! [add_gravity]

/// Gravity, or any acceleration that is the same for every mass, without the detour through a
/// force: Δv = a h, with `acceleration` in m/s², world axes, over `time_step` seconds. A static
/// particle keeps its velocity.
//! [accelerate]
template <class Real>
void accelerate(Particle<Real>& particle, const Vec3<Same<Real>>& acceleration,
                Same<Real> time_step) {
  particle.velocity += select(is_static(particle), Real(0), time_step) * acceleration;
}
//! [accelerate]

/// The kick: what this step's force does to the velocity in `time_step` seconds (h), v ← v + h F/m.
//! [kick]
template <class Real>
void kick(Particle<Real>& particle, Same<Real> time_step) {
  particle.velocity += time_step * particle.inverse_mass * particle.force;
}
//! [kick]

/// The drift: where the velocity carries the position in `time_step` seconds (h), x ← x + h v.
//! [drift]
template <class Real>
void drift(Particle<Real>& particle, Same<Real> time_step) {
  particle.position += time_step * particle.velocity;
}
//! [drift]

/// One step of `time_step` seconds (h): the kick, then the drift with the new velocity.
///
/// The force must stay the same from one step to the next for the error to be exactly ½ a h t;
/// chapter 6 says what happens otherwise. The time step is checked where it enters the program, see
/// checked_time_step().
//! [step]
template <class Real>
void step(Particle<Real>& particle, Same<Real> time_step) {
  kick(particle, time_step);
  drift(particle, time_step);
}
//! [step]

/// `time_step` (s) itself, if a simulation can step by it. Zero is allowed and changes nothing.
/// @throws std::invalid_argument if it is negative, NaN or infinite.
template <class Real>
Real checked_time_step(Real time_step) {
  require_finite("time step", time_step, "s");
  if (time_step < 0) reject("time step", time_step, "s", "time runs forward: it must be 0 or more");
  return time_step;
}

}  // namespace tumble
