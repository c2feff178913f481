// caught by: The planet sweeps the same area in every step, to rounding
// message: it must be near
#pragma once
#include <cmath>
#include <tumble/force.hpp>

template <class Real>
tumble::Particle<Real> orbit(tumble::Particle<Real> planet, Real, int) {
  planet.position = -planet.position;
  planet.velocity = -planet.velocity;
  return planet;
}
