/// @file
/// The truth for live figures: without a library's functions, whose roundings differ from machine
/// to machine.
#pragma once

#include <cmath>
#include <tumble/compositions.hpp>

namespace tumble::support {

/// The length of the chord between two orientations: their angle (rad), but for its third power
/// over 24. The angle itself would need a library's arc tangent.
inline double chord_between(const Quaternion<double>& p, const Quaternion<double>& q) {
  return 2 * (conjugate(p) * q).imaginary.norm();
}

/// Turns a free top for `seconds` by the tenth order, so finely that it is right to a few
/// roundings; `fastest` (rad/s) is how fast it spins.
inline void turn_finely(Topd& top, double seconds, double fastest) {
  const int parts = static_cast<int>(std::ceil(fastest * seconds / 0.5));
  for (int n = 0; n < parts; ++n) turn_by_row<SofroniouSpaletta>(top, seconds / parts);
}

/// The logarithm of a normal number above 0 to the base 2, cut off after 29 binary digits: each
/// squaring doubles it, and brings its next digit before the point.
inline double binary_logarithm(double value) {
  int exponent;
  double rest = 2 * std::frexp(value, &exponent), logarithm = exponent - 1;
  for (double digit = 0.5; digit > 1e-9; digit /= 2) {
    rest *= rest;
    if (rest < 2) continue;
    rest /= 2;
    logarithm += digit;
  }
  return logarithm;
}

}  // namespace tumble::support
