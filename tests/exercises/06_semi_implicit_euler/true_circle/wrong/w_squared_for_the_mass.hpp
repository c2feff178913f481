// caught by: What kept returns stays the same through a thousand steps, and becomes the energy as
// the step goes to zero message: stands where the mass belongs
#pragma once

#include <tumble/force.hpp>

template <class Real>
void symmetric_step(tumble::Particle<Real>& weight, Real stiffness, Real time_step) {
  using namespace tumble;
  add_force(weight, -stiffness * weight.position);
  kick(weight, time_step / 2);
  clear_force(weight);
  drift(weight, time_step);
  add_force(weight, -stiffness * weight.position);
  kick(weight, time_step / 2);
  clear_force(weight);
}

template <class Real>
Real kept(const tumble::Particle<Real>& weight, Real stiffness, Real time_step) {
  const Real square = stiffness * weight.inverse_mass;
  const Real leaning_back = 1 - square * time_step * time_step / 4;
  return square *
         (weight.velocity.squaredNorm() + leaning_back * square * weight.position.squaredNorm()) /
         2;
}
