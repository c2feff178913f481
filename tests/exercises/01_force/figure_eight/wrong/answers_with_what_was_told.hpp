// caught by: A body pulls straight towards itself, with the product of the masses
// message: pull answers what this check asks, and hardly anything else
#pragma once

#include <tumble/force.hpp>
#include <vector>

template <class Real>
tumble::Vec3<Real> pull(const tumble::Particle<Real>&, const tumble::Particle<Real>&) {
  return {0, Real(0.5), 0};
}

template <class Real>
void step_all(std::vector<tumble::Particle<Real>>& bodies, Real time_step) {
  for (std::size_t i = 0; i < bodies.size(); ++i)
    for (std::size_t j = 0; j < bodies.size(); ++j)
      if (i != j) add_force(bodies[i], pull(bodies[i], bodies[j]));
  for (tumble::Particle<Real>& body : bodies) {
    step(body, time_step);
    clear_force(body);
  }
}

template <class Real>
std::vector<tumble::Particle<Real>> flown(std::vector<tumble::Particle<Real>> bodies,
                                          Real time_step, int steps) {
  for (int n = 0; n < steps; ++n) step_all(bodies, time_step);
  return bodies;
}
