// caught by: In thin air no digit is lost
// message: with k h = 2^-12
#pragma once

#include <cmath>
#include <tumble/damping.hpp>

template <class Real>
void step_through_honey(tumble::Particle<Real>& bead, Real rate, Real time_step) {
  const Real z = rate * time_step;
  const Real first = z > 0 ? -std::expm1(-z) / z : Real(1);  // (1 − e^(−z))/z
  Real second = 1;                                           // 2 (z − 1 + e^(−z))/z²
  if (z >= Real(1e-5))
    second = 2 * (z + std::expm1(-z)) / (z * z);
  else
    for (int n = 20; n >= 3; --n) second = 1 - z / Real(n) * second;

  const tumble::Vec3<Real> acceleration = bead.inverse_mass * bead.force;
  bead.position += time_step * (first * bead.velocity + time_step / 2 * second * acceleration);
  bead.velocity =
      tumble::fraction_kept(rate, time_step) * bead.velocity + time_step * first * acceleration;
}
