// caught by: A bead at its terminal speed F/(m k) keeps it, however long the step
// message: a bead of 5 kg
#pragma once

#include <cmath>
#include <tumble/damping.hpp>

template <class Real>
void step_through_honey(tumble::Particle<Real>& bead, Real rate, Real time_step) {
  const Real z = rate * time_step;
  const Real first = z > 0 ? -std::expm1(-z) / z : Real(1);  // (1 − e^(−z))/z
  Real second = 1;                                           // 2 (z − 1 + e^(−z))/z²
  if (z >= 1)
    second = 2 * (z + std::expm1(-z)) / (z * z);
  else
    for (int n = 20; n >= 3; --n) second = 1 - z / Real(n) * second;

  const tumble::Vec3<Real> acceleration = Real(0.5) * bead.force;
  bead.position += time_step * (first * bead.velocity + time_step / 2 * second * acceleration);
  bead.velocity =
      tumble::fraction_kept(rate, time_step) * bead.velocity + time_step * first * acceleration;
}
