/// @file
/// Exercise: a step that reads the same backwards, and what it keeps.
#pragma once

#include <exercise/todo.hpp>
#include <tumble/force.hpp>

/// One step of `time_step` seconds (h) of a weight on a spring of `stiffness` N/m (k) that pulls it
/// to the origin, F = −k x: half a kick, a drift, half a kick. No force is left behind.
template <class Real>
void symmetric_step(tumble::Particle<Real>& weight, Real stiffness, Real time_step) {
  //! [solution] half a kick, a drift, half a kick, each with the force of its place
  using namespace tumble;
  add_force(weight, -stiffness * weight.position);
  kick(weight, time_step / 2);
  clear_force(weight);
  drift(weight, time_step);
  add_force(weight, -stiffness * weight.position);
  kick(weight, time_step / 2);
  clear_force(weight);
  //! [end]
}

/// What symmetric_step() leaves unchanged, in J: ½ m (v² + α ω² x²), ω² = k/m, with an α that goes
/// to 1 as the step goes to zero.
template <class Real>
Real kept(const tumble::Particle<Real>& weight, Real stiffness, Real time_step) {
  //! [solution] half of m times the combination of v² and ω² x² that the step keeps
  const Real square = stiffness * weight.inverse_mass;
  const Real leaning_back = 1 - square * time_step * time_step / 4;
  return tumble::mass_of(weight) *
         (weight.velocity.squaredNorm() + leaning_back * square * weight.position.squaredNorm()) /
         2;
  //! [end]
}
