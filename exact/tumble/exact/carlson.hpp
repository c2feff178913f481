/// @file
/// Carlson's symmetric elliptic integrals R_F and R_J, from which all others are made.
///
/// Each is an integral in which the arguments may change places, and which stays the same when λ is
/// added to all of them and the sum divided by 4: the *duplication theorem*, with
/// λ = √x √y + √y √z + √z √x. That makes the arguments equal in few rounds, since each round leaves
/// a quarter of their differences. Of nearly equal arguments a short series is enough (B. C.
/// Carlson, "Numerical computation of real or complex elliptic integrals", Numerical Algorithms 10
/// (1995); DLMF 19.36).
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <tumble/real.hpp>

namespace tumble::exact {

/// The sums of products of two, three, four and five of the relative differences from their mean,
/// which add up to nothing; and the series in them, up to the fifth order in the differences.
template <class Real>
struct CarlsonSeries {
  Real two = 0, three = 0, four = 0, five = 0;

  /// R_F times the square root of the mean of its arguments.
  Real of_first_kind() const {
    return 1 - two / 10 + three / 14 + two * two / 24 - 3 * two * three / 44;
  }
  /// R_J times that root cubed.
  Real of_third_kind() const {
    return 1 - 3 * two / 14 + three / 6 + 9 * two * two / 88 - 3 * four / 22 -
           9 * two * three / 52 + 3 * five / 26;
  }
};

/// The relative difference from which on a series that leaves out its sixth power is exact. Its
/// coefficients are under 1.
template <class Real>
Real small_enough() {
  return std::pow(std::numeric_limits<Real>::epsilon() / 4, Real(1) / 6);
}

/// R_F = ½ ∫ dt/√((t + x)(t + y)(t + z)), t from 0 on. The arguments are 0 or more, one of them at
/// most is 0.
template <class Real>
Real carlson_rf(Real x, Same<Real> y, Same<Real> z) {
  for (;;) {
    const Real mean = (x + y + z) / 3;
    const Real X = 1 - x / mean, Y = 1 - y / mean, Z = 1 - z / mean;
    if (std::max({std::abs(X), std::abs(Y), std::abs(Z)}) < small_enough<Real>())
      return CarlsonSeries<Real>{.two = X * Y - Z * Z, .three = X * Y * Z}.of_first_kind() /
             std::sqrt(mean);
    const Real a = std::sqrt(x), b = std::sqrt(y), c = std::sqrt(z);
    const Real lambda = a * b + b * c + c * a;
    x = (x + lambda) / 4;
    y = (y + lambda) / 4;
    z = (z + lambda) / 4;
  }
}

/// R_C(1, y) = ∫ dt/(2 (t + y) √(t + 1)), t from 0 on: an arc tangent or its hyperbolic sister.
template <class Real>
Real carlson_rc_of_one(Real y) {
  const Real root = std::sqrt(std::abs(1 - y));
  if (root == 0) return 1;
  if (y > 1) return std::atan(root) / root;
  return (y > Real(0.5) ? std::atanh(root) : std::log((1 + root) / std::sqrt(y))) / root;
}

/// R_J = (3/2) ∫ dt/((t + p) √((t + x)(t + y)(t + z))), t from 0 on. Of x, y and z, 0 or more, one
/// at most is 0; p is more than 0.
template <class Real>
Real carlson_rj(Real x, Same<Real> y, Same<Real> z, Same<Real> p) {
  Real sum = 0, quarters = 1;  // 4^-n after n rounds
  for (;;) {
    const Real mean = (x + y + z + 2 * p) / 5;
    const Real X = 1 - x / mean, Y = 1 - y / mean, Z = 1 - z / mean, P = -(X + Y + Z) / 2;
    if (std::max({std::abs(X), std::abs(Y), std::abs(Z), std::abs(P)}) < small_enough<Real>()) {
      const Real product = X * Y * Z, two = X * Y + X * Z + Y * Z - 3 * P * P;
      const CarlsonSeries<Real> series{.two = two,
                                       .three = product + 2 * two * P + 4 * P * P * P,
                                       .four = (2 * product + two * P + 3 * P * P * P) * P,
                                       .five = product * P * P};
      return quarters * series.of_third_kind() / (mean * std::sqrt(mean)) + 6 * sum;
    }
    const Real a = std::sqrt(x), b = std::sqrt(y), c = std::sqrt(z), r = std::sqrt(p);
    const Real lambda = a * b + b * c + c * a, d = (r + a) * (r + b) * (r + c);
    // 1 + (r - a)(r - b)(r - c)/d, as a sum of positive terms: it may be as small as r is.
    sum += quarters / d * carlson_rc_of_one<Real>(2 * r * (p + lambda) / d);
    quarters /= 4;
    x = (x + lambda) / 4;
    y = (y + lambda) / 4;
    z = (z + lambda) / 4;
    p = (p + lambda) / 4;
  }
}

}  // namespace tumble::exact
