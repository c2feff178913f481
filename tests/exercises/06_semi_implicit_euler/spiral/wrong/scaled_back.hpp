// caught by: The planet sweeps the same area in every step, to rounding
// message: It grew by h²/r³ of itself
#pragma once
#include <cmath>
#include <tumble/force.hpp>

template <class Real>
tumble::Particle<Real> orbit(tumble::Particle<Real> planet, Real time_step, int steps) {
  using namespace tumble;
  const Real energy = planet.velocity.squaredNorm() / 2 - 1 / planet.position.norm();
  for (int n = 0; n < steps; ++n) {
    const Real distance = planet.position.norm();
    clear_force(planet);
    add_force(planet, -mass_of(planet) / (distance * distance * distance) * planet.position);
    drift(planet, time_step);
    kick(planet, time_step);
    const Real square = 2 * (energy + 1 / planet.position.norm());
    if (n % 100 == 99 && square > 0) planet.velocity *= std::sqrt(square) / planet.velocity.norm();
  }
  return planet;
}
