// caught by: The velocity gains h F/m in a step
// message: is the mass, 2 kg, forgotten?
#pragma once
#include <tumble/particle.hpp>

template <class Real>
void step_without_lag(tumble::Particle<Real>& particle, Real time_step) {
  particle.position += time_step * particle.velocity + time_step * time_step / 2 * particle.force;
  particle.velocity += time_step * particle.force;
}
