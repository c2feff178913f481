/// @file
/// Jacobi's elliptic functions and the integrals that belong to them, for a parameter m that may
/// lie as close to 0 or 1 as it likes.
///
/// Libraries have them as functions of the modulus k = √m. From k nobody can tell how far m is from
/// 1, and it is 1 − m that says when a body flips. So the functions are made here from both m and
/// 1 − m, and the integrals from Carlson's symmetric ones, which take what is accurate: squares of
/// sn, cn and dn.
///
/// Sources: Abramowitz and Stegun, chapters 16 and 17 (Landen's transformation 16.12 and 17.6,
/// Jacobi's imaginary one 16.20); DLMF 19.25 for the integrals in Carlson's form.
#pragma once

#include <algorithm>
#include <array>
#include <tumble/exact/carlson.hpp>

namespace tumble::exact {

/// sn, cn and dn of one argument. sn² + cn² = 1 and dn² = 1 − m sn².
template <class Real>
struct SnCnDn {
  Real sn = 0, cn = 1, dn = 1;
};

/// Jacobi's elliptic functions with the parameter m. Every value, also a small one, has a relative
/// error of a few roundings, apart from what the rounding of the argument does.
template <class Real>
class Jacobi {
 public:
  /// `m` and `one_minus_m`, both in 0 … 1. Each must be accurate for itself: of two numbers that
  /// add up to 1 the smaller one says more than the larger.
  Jacobi(Real m, Real one_minus_m)
      : m_(m), m1_(one_minus_m), quarter_period_(m1_ > 0 ? carlson_rf<Real>(0, m1_, 1) : infinity) {
    hyperbolic_ = m1_ < m_;
    const Real smaller = hyperbolic_ ? m1_ : m_;
    Real a = 1, b = std::sqrt(1 - smaller), c = std::sqrt(smaller);
    constexpr Real epsilon = std::numeric_limits<Real>::epsilon();
    while (c > epsilon * epsilon) {  // a hyperbolic sine makes it as large as its root
      const Real mean = (a + b) / 2;
      c = c * c / (4 * mean);  // which is (a - b)/2, with all its digits
      b = std::sqrt(a * b);
      a = mean;
      ratio_[steps_++] = c / a;
    }
    mean_ = a;
  }

  /// m, the square of the modulus.
  Real parameter() const { return m_; }

  /// K(m): a quarter of the period of sn and cn, half of that of dn; infinite where m is 1.
  Real quarter_period() const { return quarter_period_; }

  /// sn, cn and dn of `u`, any number.
  SnCnDn<Real> at(Real u) const {
    const Real half_periods = whole_half_periods(u);
    SnCnDn<Real> value = within_half_period(u - half_periods * half_period());
    if (std::fmod(half_periods, Real(2)) != 0) {
      value.sn = -value.sn;
      value.cn = -value.cn;
    }
    return value;
  }

  /// How many half periods 2K one must take from `u` to be left with −K … K.
  Real whole_half_periods(Real u) const {
    return m1_ > 0 ? std::nearbyint(u / (2 * quarter_period_)) : Real(0);
  }
  Real half_period() const { return m1_ > 0 ? 2 * quarter_period_ : Real(0); }

  /// The u in −K … K with sn u and cn u in the ratio `sn` to `cn`, where cn is 0 or more: the
  /// integral of the first kind.
  Real argument_of(Real sn, Real cn) const {
    const Real length = std::hypot(sn, cn), s = sn / length, c = cn / length;
    return s * carlson_rf<Real>(c * c, c * c + m1_ * (s * s), 1);
  }

  /// ∫ du/(1 − n sn² u) from 0 to `u`, the integral of the third kind, for n in 0 … 1. It takes
  /// `one_minus_n`, and n only as far as it counts.
  Real third_kind(Real n, Real one_minus_n, Real u) const {
    const Real half_periods = whole_half_periods(u);
    const Real rest = u - half_periods * half_period();
    Real whole = 0;
    if (half_periods != 0)
      whole =
          half_periods * 2 * (quarter_period_ + n / 3 * carlson_rj<Real>(0, m1_, 1, one_minus_n));
    const auto [s, c, d] = within_half_period(rest);
    if (n == 0 || s == 0) return whole + rest;
    const Real rj = carlson_rj<Real>(c * c, d * d, 1, c * c + one_minus_n * (s * s));
    return whole + (rest + n / 3 * (s * s * s) * rj);
  }

 private:
  static constexpr Real infinity = std::numeric_limits<Real>::infinity();

  /// For u in −K … K. What lies beyond K/2 is mirrored, so that cn and dn keep their digits where
  /// they are small: sn u = cn v/dn v, cn u = k' sn v/dn v and dn u = k'/dn v with v = K − u.
  SnCnDn<Real> within_half_period(Real u) const {
    const Real size = std::abs(u);
    SnCnDn<Real> value;
    if (m1_ > 0 && size > quarter_period_ / 2) {
      const auto [s, c, d] = near_zero(quarter_period_ - size);
      const Real k1 = std::sqrt(m1_);
      value = {c / d, k1 * s / d, k1 / d};
    } else {
      value = near_zero(size);
    }
    value.sn = std::copysign(value.sn, u);
    return value;
  }

  /// For u in 0 … K/2. Landen's transformation halves the bend of the function again and again,
  /// until it is a sine; where m is nearer to 1 than to 0 it is a hyperbolic sine, by Jacobi's
  /// sn(iu|m) = i sn(u|1 − m)/cn(u|1 − m).
  SnCnDn<Real> near_zero(Real u) const {
    // Only where m is 1 can u be large. cn falls like exp(-u) then, and must not become 0.
    const Real longest = std::log(std::numeric_limits<Real>::max()) - 4;
    Real angle = std::ldexp(mean_ * std::min(u, longest), static_cast<int>(steps_));
    if (hyperbolic_) {
      for (std::size_t n = steps_; n > 0; --n)
        angle = (angle + std::asinh(ratio_[n - 1] * std::sinh(angle))) / 2;
      const Real sn = std::tanh(angle), cn = 1 / std::cosh(angle);
      return {sn, cn, std::hypot(cn, std::sqrt(m1_) * sn)};
    }
    for (std::size_t n = steps_; n > 0; --n)
      angle = (angle + std::asin(ratio_[n - 1] * std::sin(angle))) / 2;
    const Real sn = std::sin(angle), cn = std::cos(angle);
    return {sn, cn, std::sqrt(1 - m_ * (sn * sn))};
  }

  Real m_, m1_, quarter_period_, mean_ = 1;
  bool hyperbolic_ = false;
  std::size_t steps_ = 0;
  std::array<Real, 8> ratio_ = {};
};

}  // namespace tumble::exact
