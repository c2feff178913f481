// caught by: A small turn is seen as it is, forward and backward
// message: not the smallest positive one
#pragma once

#include <cmath>
#include <numbers>

template <class Real>
Real seen_turn(Real turn, int spokes) {
  const Real gap = 2 * std::numbers::pi_v<Real> / Real(spokes);
  return turn - gap * std::floor(turn / gap);
}

template <class Real>
Real seen_rate(Real rate, int spokes, Real pictures_per_second) {
  return pictures_per_second * seen_turn<Real>(rate / pictures_per_second, spokes);
}

template <class Real>
Real standing_rate(int spokes, Real pictures_per_second) {
  return pictures_per_second * (2 * std::numbers::pi_v<Real> / Real(spokes));
}
