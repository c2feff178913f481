/// @file
/// Exercise: find the wrong line in a table of numbers that looks right.
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

/// Σ weight_i coefficient_ij node_j: what the rule makes of a stage that another one leads.
template <class Real>
Real sum_of_chains() {
  long double sum = 0;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < i; ++j)
      sum += ThreeEighths::rule.weights[i] * ThreeEighths::rule.coefficients[i][j] *
             ThreeEighths::rule.nodes[j];
  return static_cast<Real>(sum);
}

/// By how much the stages go astray at a constant rate: the largest difference of a row's sum from
/// its node, or of the weights' sum from 1.
template <class Real>
Real astray() {
  long double largest = -1;
  for (const long double weight : ThreeEighths::rule.weights) largest += weight;
  largest = std::abs(largest);
  for (std::size_t i = 0; i < 4; ++i) {
    long double row = -ThreeEighths::rule.nodes[i];
    for (const long double coefficient : ThreeEighths::rule.coefficients[i]) row += coefficient;
    largest = std::max(largest, std::abs(row));
  }
  return static_cast<Real>(largest);
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
