// caught by: With half the step the error of a tumbling top is a sixteenth
// message: that is a rule of second order
#pragma once

#include <algorithm>
#include <cmath>
#include <tumble/runge_kutta.hpp>

struct ThreeEighths {
  static constexpr tumble::Tableau<4> rule = {.nodes = {0, 1 / 3.0L, 2 / 3.0L, 1},
                                              .weights = {1 / 8.0L, 3 / 8.0L, 3 / 8.0L, 1 / 8.0L},
                                              .coefficients = {{
                                                  {},
                                                  {1 / 3.0L},
                                                  {2 / 3.0L},
                                                  {1, -1, 1},
                                              }}};
};

template <class Real>
Real sum_of_chains() {
  long double sum = 0;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < i; ++j)
      sum += ThreeEighths::rule.weights[i] * ThreeEighths::rule.coefficients[i][j] *
             ThreeEighths::rule.nodes[j];
  return static_cast<Real>(sum);
}

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

template <class Real>
tumble::Vec3<Real> momentum_after(const tumble::Vec3<Real>& momentum, Real time_step, int steps) {
  tumble::Top<Real> top;
  top.inverse_moments = {1, Real(1) / 2, Real(1) / 3};
  top.angular_momentum_body = momentum;
  for (int n = 0; n < steps; ++n) tumble::turn_by_runge_kutta<ThreeEighths, Real>(top, time_step);
  return top.angular_momentum_body;
}
