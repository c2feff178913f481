// caught by: After one period all three are back where they began, the nearer the shorter the
//   step
// message: m from where another began
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
                                          Real time_step, int) {
  bodies[0].position.x() += time_step;
  return bodies;
}
