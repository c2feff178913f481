// caught by: A wall stays where it is, whatever pushes
// message: a wall has no mass to divide by
#pragma once
#include <tumble/particle.hpp>

template <class Real>
void step_without_lag(tumble::Particle<Real>& particle, Real time_step) {
  const Real mass = 1 / particle.inverse_mass;
  const tumble::Vec3<Real> change = time_step * (mass * particle.force) / (mass * mass);
  particle.position += time_step * (particle.velocity + change / 2);
  particle.velocity += change;
}
