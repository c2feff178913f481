// caught by: A turn that lacks little of whole gaps is seen as a small turn backward
// message: std::remainder, not std::fmod
#pragma once

#include <cmath>
#include <numbers>

template <class Real>
Real seen_turn(Real turn, int spokes) {
  return std::fmod(turn, 2 * std::numbers::pi_v<Real> / Real(spokes));
}

template <class Real>
Real seen_rate(Real rate, int spokes, Real pictures_per_second) {
  return pictures_per_second * seen_turn<Real>(rate / pictures_per_second, spokes);
}

template <class Real>
Real standing_rate(int spokes, Real pictures_per_second) {
  return pictures_per_second * (2 * std::numbers::pi_v<Real> / Real(spokes));
}
