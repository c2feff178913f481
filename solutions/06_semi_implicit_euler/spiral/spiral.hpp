/// @file
/// Exercise: a planet that is to stay.
#pragma once

#include <cmath>
#include <exercise/todo.hpp>
#include <tumble/force.hpp>

/// The planet after `steps` steps of `time_step` (years / 2π) around a sun at the origin, which
/// pulls with m / r² towards itself.
template <class Real>
tumble::Particle<Real> orbit(tumble::Particle<Real> planet, Real time_step, int steps) {
  using namespace tumble;
  for (int n = 0; n < steps; ++n) {
    //! [solution]
    const Real distance = planet.position.norm();
    clear_force(planet);
    add_force(planet, -mass_of(planet) / (distance * distance * distance) * planet.position);
    kick(planet, time_step);
    drift(planet, time_step);
    //! [starter]
    // const Real distance = planet.position.norm();
    // clear_force(planet);
    // add_force(planet, -mass_of(planet) / (distance * distance * distance) * planet.position);
    // drift(planet, time_step);
    // kick(planet, time_step);
    //! [end]
  }
  return planet;
}
