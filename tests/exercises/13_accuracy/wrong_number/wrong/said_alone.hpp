// caught by: Stages that depend on other stages have their proper weight: the sum of chains is 1/6
// message: the rule that turns the top is of second order
#pragma once

#include <algorithm>
#include <cmath>
#include <tumble/runge_kutta.hpp>

/// Kutta's other rule of fourth order, "three eighths", in the form of chapter 13.
struct ThreeEighths {
  static constexpr tumble::Tableau<4> rule = {.nodes = {0, 1 / 3.0L, 2 / 3.0L, 1},
                                              .weights = {1 / 8.0L, 3 / 8.0L, 3 / 8.0L, 1 / 8.0L},
                                              .coefficients = {{
                                                  {},
                                                  {1 / 3.0L},
                                                  {1 / 3.0L, 1 / 3.0L},
                                                  {1, -1, 1},
                                              }}};
};

template <class Real>
Real sum_of_chains() {
  return Real(1) / 6;
}

template <class Real>
Real astray() {
  return 0;
}

/// The angular momentum in body axes (kg m²/s) of a top with moments of 1, 2 and 3 kg m², which
/// began with `momentum`, after `steps` steps of this rule.
template <class Real>
tumble::Vec3<Real> momentum_after(const tumble::Vec3<Real>& momentum, Real time_step, int steps) {
  tumble::Top<Real> top;
  top.inverse_moments = {1, Real(1) / 2, Real(1) / 3};
  top.angular_momentum_body = momentum;
  for (int n = 0; n < steps; ++n) tumble::turn_by_runge_kutta<ThreeEighths, Real>(top, time_step);
  return top.angular_momentum_body;
}
