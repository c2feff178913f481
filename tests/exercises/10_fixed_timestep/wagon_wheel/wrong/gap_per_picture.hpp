// caught by: A wheel that speeds up seems to stand still at every multiple of the standing rate,
// and there alone message: it turns by sixteen gaps
#pragma once

#include <cmath>
#include <numbers>

template <class Real>
Real seen_turn(Real turn, int spokes) {
  return std::remainder(turn, 2 * std::numbers::pi_v<Real> / Real(spokes));
}

template <class Real>
Real seen_rate(Real rate, int spokes, Real pictures_per_second) {
  return pictures_per_second * seen_turn<Real>(rate / pictures_per_second, spokes);
}

template <class Real>
Real standing_rate(int spokes, Real pictures_per_second) {
  return 2 * std::numbers::pi_v<Real> / Real(spokes) / pictures_per_second;
}
