// caught by: After a hundred years the planet is as far from its sun as ever
// message: it must be near
#pragma once
#include <cmath>
#include <tumble/force.hpp>

template <class Real>
tumble::Particle<Real> orbit(tumble::Particle<Real> planet, Real time_step, int steps) {
  const Real angle = time_step * Real(steps), c = std::cos(angle), s = std::sin(angle);
  for (tumble::Vec3<Real>* each : {&planet.position, &planet.velocity})
    *each = tumble::Vec3<Real>(c * each->x() - s * each->y(), s * each->x() + c * each->y(), 0);
  return planet;
}
