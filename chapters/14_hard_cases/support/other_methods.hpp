/// @file
/// The methods for a free top that are not rungs of the turning ladder, compiled once.
#pragma once

#include <support/rungs.hpp>
#include <vector>

namespace tumble::support {

/// Chapter 8's splitting without a sine, the rungs that keep L apart, those that choose their own
/// steps within each time step, and the exact solution from each step to the next.
template <class Real>
std::span<const TurningRung<Real>> other_methods();
template <>
std::span<const TurningRung<float>> other_methods<float>();
template <>
std::span<const TurningRung<double>> other_methods<double>();

/// Every method of the book for a free top: the rungs, and these.
template <class Real>
std::vector<TurningRung<Real>> all_methods() {
  std::vector<TurningRung<Real>> all(rungs<Real>().begin(), rungs<Real>().end());
  all.insert(all.end(), other_methods<Real>().begin(), other_methods<Real>().end());
  return all;
}

/// What those that choose their steps are given.
inline constexpr double given_tolerance = 1e-6, given_angle = 0.1;  ///< rad/s; rad

}  // namespace tumble::support
