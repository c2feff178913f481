// caught by: Half a kick, a drift, half a kick: with the force of the place where each half acts
// message: both halves of the kick used the force of the place before the drift
#pragma once

#include <tumble/force.hpp>

template <class Real>
void symmetric_step(tumble::Particle<Real>& weight, Real stiffness, Real time_step) {
  using namespace tumble;
  add_force(weight, -stiffness * weight.position);
  kick(weight, time_step / 2);
  drift(weight, time_step);
  kick(weight, time_step / 2);
  clear_force(weight);
}

template <class Real>
Real kept(const tumble::Particle<Real>& weight, Real stiffness, Real time_step) {
  const Real square = stiffness * weight.inverse_mass;
  const Real leaning_back = 1 - square * time_step * time_step / 4;
  return tumble::mass_of(weight) *
         (weight.velocity.squaredNorm() + leaning_back * square * weight.position.squaredNorm()) /
         2;
}
