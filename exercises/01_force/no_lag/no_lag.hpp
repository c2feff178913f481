/// @file
/// Exercise: a step that stays on the parabola.
#pragma once

#include <exercise/todo.hpp>
#include <tumble/particle.hpp>

/// Moves the particle by `time_step` seconds (h) under the force that it has gathered. Under a
/// constant force there is no error but rounding, however long the step is.
template <class Real>
void step_without_lag(tumble::Particle<Real>& particle, Real time_step) {
  todo("a step of position and velocity that lands on the parabola");
}
