/// @file
/// Exercise: a rule of fourth order, from several steps of one of second order.
#pragma once

#include <cmath>
#include <exercise/todo.hpp>
#include <tumble/splitting.hpp>
#include <vector>

/// The lengths of 2 `pairs` + 1 steps, as parts of the whole: so many equal ones, the middle one
/// backward, and as many again. Together they make up 1, and their cubes make up 0.
template <class Real>
std::vector<Real> weights(int pairs) {
  //! [solution] the weights, from the two conditions
  const Real outer_count = Real(2 * pairs);
  const Real outer = 1 / (outer_count - std::cbrt(outer_count));
  std::vector<Real> parts(static_cast<std::size_t>(2 * pairs + 1), outer);
  parts[static_cast<std::size_t>(pairs)] = 1 - outer_count * outer;
  return parts;
  //! [end]
}

/// Turns the top by `time_step` seconds, in steps of chapter 8's splitting with these weights.
template <class Real>
void turn_composed(tumble::Top<Real>& top, Real time_step, int pairs) {
  //! [solution] a step of the splitting for each weight
  for (const Real part : weights<Real>(pairs)) turn_by_splitting(top, part * time_step);
  //! [end]
}

/// How large the error of a long motion is against that of other pairs, for the same number of
/// steps of the splitting in all: |Σ w⁵| n⁴, n weights in a step.
template <class Real>
Real error_for_the_same_work(int pairs) {
  //! [solution] the size of the leading error, times what n steps in one cost
  Real sum = 0;
  const std::vector<Real> parts = weights<Real>(pairs);
  for (const Real part : parts) sum += std::pow(part, Real(5));
  return std::abs(sum) * std::pow(Real(parts.size()), Real(4));
  //! [end]
}

/// The angular momentum in body axes (kg m²/s) of a top with moments of 1, 2 and 3 kg m², which
/// began with `momentum`, after `steps` steps.
template <class Real>
tumble::Vec3<Real> momentum_after(const tumble::Vec3<Real>& momentum, Real time_step, int steps,
                                  int pairs) {
  tumble::Top<Real> top;
  top.inverse_moments = {1, Real(1) / 2, Real(1) / 3};
  top.angular_momentum_body = momentum;
  for (int n = 0; n < steps; ++n) turn_composed(top, time_step, pairs);
  return top.angular_momentum_body;
}
