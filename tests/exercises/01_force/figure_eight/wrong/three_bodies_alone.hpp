// caught by: A step leaves the momentum of all three together as it was, and no force behind
// message: it feels nothing
#pragma once

#include <tumble/force.hpp>
#include <vector>

template <class Real>
tumble::Vec3<Real> pull(const tumble::Particle<Real>& on, const tumble::Particle<Real>& by) {
  const tumble::Vec3<Real> r = by.position - on.position;
  const Real distance = r.norm();
  return mass_of(on) * mass_of(by) / (distance * distance * distance) * r;
}

template <class Real>
void step_all(std::vector<tumble::Particle<Real>>& bodies, Real time_step) {
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
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
