// caught by: Under a constant force it lands on the parabola, however long a step is
// message: or the half of ½ a h² is missing
#pragma once

#include <tumble/particle.hpp>

template <class Real>
void step_without_lag(tumble::Particle<Real>& particle, Real time_step) {
  const tumble::Vec3<Real> acceleration = particle.inverse_mass * particle.force;
  particle.position += time_step * particle.velocity + time_step * time_step * acceleration;
  particle.velocity += time_step * acceleration;
}
