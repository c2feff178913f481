// caught by: After a hundred years the planet is as far from its sun as ever
// message: the planet spirals outward
#pragma once

#include <cmath>
#include <tumble/force.hpp>

template <class Real>
tumble::Particle<Real> orbit(tumble::Particle<Real> planet, Real time_step, int steps) {
  using namespace tumble;
  for (int n = 0; n < steps; ++n) {
    const Real distance = planet.position.norm();
    clear_force(planet);
    add_force(planet, -mass_of(planet) / (distance * distance * distance) * planet.position);
    drift(planet, time_step);
    kick(planet, time_step);
  }
  return planet;
}
