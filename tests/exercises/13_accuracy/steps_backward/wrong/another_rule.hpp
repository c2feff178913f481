// caught by: A tumbling top is turned to fourth order
// message: momentum_after is
#pragma once

#include <cmath>
#include <stdexcept>
#include <tumble/splitting.hpp>
#include <vector>

template <class Real>
std::vector<Real> weights(int pairs) {
  const Real outer_count = Real(2 * pairs);
  const Real outer = 1 / (outer_count - std::cbrt(outer_count));
  std::vector<Real> parts(static_cast<std::size_t>(2 * pairs + 1), outer);
  parts[static_cast<std::size_t>(pairs)] = 1 - outer_count * outer;
  return parts;
}

template <class Real>
void turn_composed(tumble::Top<Real>&, Real, int) {
  throw std::logic_error("not written");
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
                                  int) {
  tumble::Top<Real> top;
  top.inverse_moments = {1, Real(1) / 2, Real(1) / 3};
  top.angular_momentum_body = momentum;
  for (int n = 0; n < steps; ++n)
    for (const Real part : weights<Real>(2)) turn_by_splitting(top, part * time_step);
  return top.angular_momentum_body;
}
