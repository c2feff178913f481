// caught by: It still takes a year for a round, the nearer the shorter the step
// message: falls with the square of the distance
#pragma once

#include <cmath>
#include <tumble/force.hpp>

template <class Real>
tumble::Particle<Real> orbit(tumble::Particle<Real> planet, Real time_step, int steps) {
  using namespace tumble;
  for (int n = 0; n < steps; ++n) {
    const Real distance = planet.position.norm();
    clear_force(planet);
    add_force(planet, -mass_of(planet) / (distance * distance) * planet.position);
    kick(planet, time_step);
    drift(planet, time_step);
  }
  return planet;
}
