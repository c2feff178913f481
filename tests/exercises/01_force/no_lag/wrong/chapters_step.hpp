// caught by: Under a constant force it lands on the parabola, however long a step is
// message: too low by half of a h t, as in the chapter
#pragma once
#include <tumble/force.hpp>

template <class Real>
void step_without_lag(tumble::Particle<Real>& particle, Real time_step) {
  tumble::step(particle, time_step);
}
