// caught by: With a single spoke it is what the chapter draws between two states
// message: never longer than half a turn
#pragma once

#include <cmath>
#include <numbers>

template <class Real>
Real seen_turn(Real turn, int spokes) {
  return turn + 0 * Real(spokes);
}

template <class Real>
Real seen_rate(Real rate, int spokes, Real pictures_per_second) {
  return pictures_per_second * seen_turn<Real>(rate / pictures_per_second, spokes);
}

template <class Real>
Real standing_rate(int spokes, Real pictures_per_second) {
  return pictures_per_second * (2 * std::numbers::pi_v<Real> / Real(spokes));
}
