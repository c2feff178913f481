// caught by: Under a constant force it lands on the parabola, however long a step is
// message: where a ball of 8 kg is
#pragma once

#include <tumble/particle.hpp>

template <class Real>
void step_without_lag(tumble::Particle<Real>& particle, Real time_step) {
  const tumble::Vec3<Real> acceleration(0, 0, particle.inverse_mass * particle.force.z());
  particle.position += time_step * particle.velocity + time_step * time_step / 2 * acceleration;
  particle.velocity += time_step * acceleration;
}
