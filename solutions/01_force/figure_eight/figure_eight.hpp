/// @file
/// Lab: three equal suns chase each other along a figure of eight.
#pragma once

#include <exercise/todo.hpp>
#include <tumble/force.hpp>
#include <vector>

/// The pull (N) that the body `by` exerts on the body `on`: m M r / |r|³, r leading from `on` to
/// `by`. The units are such that the constant of gravity is 1.
template <class Real>
tumble::Vec3<Real> pull(const tumble::Particle<Real>& on, const tumble::Particle<Real>& by) {
  //! [solution] the pull of one body on another
  const tumble::Vec3<Real> r = by.position - on.position;
  const Real distance = r.norm();
  return mass_of(on) * mass_of(by) / (distance * distance * distance) * r;
  //! [end]
}

/// One step of `time_step` seconds of all bodies, each pulled by all others.
template <class Real>
void step_all(std::vector<tumble::Particle<Real>>& bodies, Real time_step) {
  //! [solution] gather the pulls on every body, then step every body
  for (std::size_t i = 0; i < bodies.size(); ++i)
    for (std::size_t j = 0; j < bodies.size(); ++j)
      if (i != j) add_force(bodies[i], pull(bodies[i], bodies[j]));
  for (tumble::Particle<Real>& body : bodies) {
    step(body, time_step);
    clear_force(body);
  }
  //! [end]
}

/// The bodies after `steps` steps.
template <class Real>
std::vector<tumble::Particle<Real>> flown(std::vector<tumble::Particle<Real>> bodies,
                                          Real time_step, int steps) {
  for (int n = 0; n < steps; ++n) step_all(bodies, time_step);
  return bodies;
}
