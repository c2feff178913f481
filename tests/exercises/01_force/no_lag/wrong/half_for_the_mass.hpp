// caught by: The velocity gains h F/m in a step
// message: that of 8 kg
#pragma once

#include <tumble/particle.hpp>

template <class Real>
void step_without_lag(tumble::Particle<Real>& particle, Real time_step) {
  const tumble::Vec3<Real> acceleration =
      (particle.inverse_mass > 0 ? Real(0.5) : 0) * particle.force;
  particle.position += time_step * particle.velocity + time_step * time_step / 2 * acceleration;
  particle.velocity += time_step * acceleration;
}
