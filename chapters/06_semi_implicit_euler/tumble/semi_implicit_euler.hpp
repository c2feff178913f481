/// @file
/// In which order to step. Semi-implicit Euler is step() of force.hpp, a kick and then a drift;
/// here stand what comes between the two, the order that gains energy, and how long a step a spring
/// allows.
#pragma once

#include <tumble/force.hpp>

namespace tumble {

/// Changes the velocity at once: v ← v + J/m, with the impulse J in N s, world axes. A static
/// particle keeps its velocity.
///
/// Its place in a step is between kick() and drift(): there it meets the velocity that this step's
/// forces have made, before that velocity moves anything.
/// @throws std::invalid_argument if the impulse is not finite; the particle is then unchanged.
//! [apply_impulse]
template <class Real>
void apply_impulse(Particle<Real>& particle, const Vec3<Same<Real>>& impulse) {
  require_finite("impulse", impulse, "N s");
  particle.velocity += particle.inverse_mass * impulse;
}
//! [apply_impulse]

/// One step of explicit Euler over `time_step` seconds: the drift with the old velocity, then the
/// kick with the force of the old place. It gains energy; it is here to be compared with step().
//! [explicit_step]
template <class Real>
void explicit_step(Particle<Real>& particle, Same<Real> time_step) {
  drift(particle, time_step);
  kick(particle, time_step);
}
//! [explicit_step]

/// The time step (s) below which step() keeps a particle on a spring with a damper, F = −k x − c v,
/// from growing without bound: h = 4 / (c/m + √((c/m)² + 4 k/m)), which is 2 √(m/k) without the
/// damper. Infinite where nothing pulls or nothing can move.
///
/// @param stiffness k, N/m
/// @param damping c, N s/m
/// @param inverse_mass 1/m, 1/kg, of the particle; for two that are joined, the sum of both
/// @throws std::invalid_argument if one of them is negative, NaN or infinite.
//! [largest_stable_time_step]
template <class Real>
Real largest_stable_time_step(Real stiffness, Same<Real> damping, Same<Real> inverse_mass) {
  require_not_negative("stiffness", stiffness, "N/m");
  require_not_negative("spring's damping", damping, "N s/m");
  require_not_negative("inverse mass", inverse_mass, "1/kg");
  const Real damping_rate = damping * inverse_mass;
  const Real angular_frequency = std::sqrt(stiffness) * std::sqrt(inverse_mass);
  return 4 / (damping_rate + std::hypot(damping_rate, 2 * angular_frequency));
}
//! [largest_stable_time_step]

}  // namespace tumble
