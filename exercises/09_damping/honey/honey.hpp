/// @file
/// Exercise: a step through honey that is exact, however long it is.
#pragma once

#include <cmath>
#include <exercise/todo.hpp>
#include <tumble/damping.hpp>

/// Moves the particle by `time_step` seconds (h) under the force F that it has gathered and a
/// resistance that is proportional to its velocity: v' = F/m − k v. `rate` is k in 1/s, 0 or more.
/// There is no error but rounding, however long the step is.
template <class Real>
void step_through_honey(tumble::Particle<Real>& bead, Real rate, Real time_step) {
  todo("the exact motion of v' = F/m - k v over one step: position and velocity");
}
