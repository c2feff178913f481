/// @file
/// A particle: all that a body is to a force, as long as nobody asks which way it faces.
#pragma once

#include <limits>
#include <tumble/require.hpp>

namespace tumble {

/// A point with mass. All vectors are in world axes.
//! [particle]
template <class Real>
struct Particle {
  Vec3<Real> position = Vec3<Real>::Zero();  ///< where it is, m
  Vec3<Real> velocity = Vec3<Real>::Zero();  ///< how fast the position changes, m/s
  Vec3<Real> force = Vec3<Real>::Zero();     ///< the sum of this step's forces, N
  Real inverse_mass = 0;                     ///< 1/mass, 1/kg; 0 means that nothing can move it
};
//! [particle]

using Particlef = Particle<float>;
using Particled = Particle<double>;

/// True when no force can change the particle's velocity.
template <class Real>
auto is_static(const Particle<Real>& particle) {
  return particle.inverse_mass == 0;
}

/// The mass in kg; 0 for a static particle, whose mass no formula may use.
template <class Real>
Real mass_of(const Particle<Real>& particle) {
  return select(is_static(particle), Real(0), 1 / particle.inverse_mass);
}

/// Throws unless `mass` (kg) is more than 0, and such that it and its inverse have all their
/// digits.
template <class Real>
void require_mass(std::string_view name, Real mass) {
  if (!(mass > 0)) reject(name, mass, "kg", "it must be greater than 0");
  require_finite(name, mass, "kg");
  const Real smallest =
      std::numeric_limits<Real>::min();  // the smallest number with all its digits
  require_between(name, mass, "kg", smallest, 1 / smallest);
}

/// A particle of `mass` kg at `position` m, moving with `velocity` m/s. The type of the mass is
/// that of all its numbers, so write 2.0 and not 2.
///
/// @throws std::invalid_argument as require_mass(), or if a vector is not finite.
template <class Real>
Particle<Real> make_particle(Real mass, const Vec3<Same<Real>>& position = Vec3<Real>::Zero(),
                             const Vec3<Same<Real>>& velocity = Vec3<Real>::Zero()) {
  static_assert(std::is_floating_point_v<Real>, "write the mass with a decimal point: 2.0, not 2");
  if (mass > std::numeric_limits<Real>::max())
    reject("mass", mass, "kg", "for a body that nothing can move, use make_static_particle");
  require_mass("mass", mass);
  require_finite("position", position, "m");
  require_finite("velocity", velocity, "m/s");
  return {.position = position, .velocity = velocity, .inverse_mass = 1 / mass};
}

/// A particle that no force can move: the ground, a wall, the nail that a pendulum hangs from. If
/// it is given a velocity, it keeps it.
/// @throws std::invalid_argument if `position` (m) is not finite.
template <class Real>
Particle<Real> make_static_particle(const Vec3<Real>& position) {
  require_finite("position", position, "m");
  return {.position = position};
}

}  // namespace tumble
