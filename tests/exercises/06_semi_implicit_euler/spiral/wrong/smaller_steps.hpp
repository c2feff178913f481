// caught by: The planet sweeps the same area in every step, to rounding
// message: Smaller steps only slow that down
#pragma once
#include <cmath>
#include <tumble/force.hpp>

template <class Real>
tumble::Particle<Real> orbit(tumble::Particle<Real> planet, Real time_step, int steps) {
  using namespace tumble;
  const int parts = 100;
  for (int n = 0; n < parts * steps; ++n) {
    const Real distance = planet.position.norm();
    clear_force(planet);
    add_force(planet, -mass_of(planet) / (distance * distance * distance) * planet.position);
    drift(planet, time_step / parts);
    kick(planet, time_step / parts);
  }
  return planet;
}
