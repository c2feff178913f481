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
  //! [solution] the exact motion of v' = F/m - k v over one step: position and velocity
  const Real z = rate * time_step;
  const Real first = z > 0 ? -std::expm1(-z) / z : Real(1);  // (1 − e^(−z))/z
  Real second = 1;                                           // 2 (z − 1 + e^(−z))/z²
  if (z >= 1)
    second = 2 * (z + std::expm1(-z)) / (z * z);
  else
    for (int n = 20; n >= 3; --n) second = 1 - z / Real(n) * second;

  const tumble::Vec3<Real> acceleration = bead.inverse_mass * bead.force;
  bead.position += time_step * (first * bead.velocity + time_step / 2 * second * acceleration);
  bead.velocity =
      tumble::fraction_kept(rate, time_step) * bead.velocity + time_step * first * acceleration;
  //! [end]
}
