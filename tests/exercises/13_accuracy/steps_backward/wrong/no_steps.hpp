// caught by: Their cubes add up to zero, for every number of pairs
// message: Cubes of no steps at all
#pragma once

#include <cmath>
#include <tumble/splitting.hpp>
#include <vector>

template <class Real>
std::vector<Real> weights(int pairs) {
  return std::vector<Real>(static_cast<std::size_t>(2 * pairs + 1));
}

template <class Real>
void turn_composed(tumble::Top<Real>& top, Real time_step, int pairs) {
  for (const Real part : weights<Real>(pairs)) turn_by_splitting(top, part * time_step);
}

template <class Real>
Real error_for_the_same_work(int pairs) {
  Real sum = 0;
  const std::vector<Real> parts = weights<Real>(pairs);
  for (const Real part : parts) sum += std::pow(part, Real(5));
  return std::abs(sum) * std::pow(Real(parts.size()), Real(4));
}

template <class Real>
tumble::Vec3<Real> momentum_after(const tumble::Vec3<Real>& momentum, Real time_step, int steps,
                                  int pairs) {
  tumble::Top<Real> top;
  top.inverse_moments = {1, Real(1) / 2, Real(1) / 3};
  top.angular_momentum_body = momentum;
  for (int n = 0; n < steps; ++n) turn_composed(top, time_step, pairs);
  return top.angular_momentum_body;
}
