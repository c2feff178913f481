/// @file
/// Sine and cosine of one angle together, in arithmetic alone: no table and no branch, so that the
/// same lines serve one body and eight side by side. They give the same bits on every machine with
/// IEEE 754 arithmetic, as long as the compiler fuses no product with a sum (-ffp-contract=off).
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <tumble/real.hpp>

namespace tumble {

/// What sine_cosine() needs to know of a kind of number.
template <class Real>
struct SineCosineConstants {
  using Limits = std::numeric_limits<Real>;

  /// How many binary digits the number of quarter turns in an angle may have.
  static constexpr int count_digits = Limits::digits < 53 ? 10 : 20;
  /// Angles (rad) of up to this size are answered, larger ones with NaN: 1536 in float, 1572864 in
  /// double and long double.
  static constexpr Real limit = Real(3 << (count_digits - 1));
  /// Added and taken away again, it rounds to the nearest whole number: out there the whole
  /// numbers are all that can be stored.
  static constexpr Real to_whole = Real(1.5) / Limits::epsilon();

  /// The binary digits of π/2, 32 in a word; the first of them stands for 1.
  static constexpr std::array<std::uint32_t, 7> quarter_turn_digits = {
      0xc90fdaa2, 0x2168c234, 0xc4c6628b, 0x80dc1cd1, 0x29024e08, 0x8a67cc74, 0x020bbea6};

  /// What `count` digits of π/2 stand for, beginning with digit `first`.
  static constexpr Real quarter_turn_part(int first, int count) {
    Real value = 0, digit_value = 1;
    for (int digit = 0; digit < first + count; ++digit, digit_value /= 2) {
      const std::uint32_t word = quarter_turn_digits[static_cast<std::size_t>(digit / 32)];
      if (digit >= first && (word >> (31 - digit % 32) & 1) != 0) value += digit_value;
    }
    return value;
  }

  /// π/2 as a sum of four numbers. The first three are so short that a number of quarter turns
  /// times any of them is exact.
  static constexpr int short_digits = Limits::digits - count_digits;
  static constexpr std::array<Real, 4> quarter_turn = {
      quarter_turn_part(0, short_digits), quarter_turn_part(short_digits, short_digits),
      quarter_turn_part(2 * short_digits, short_digits),
      quarter_turn_part(3 * short_digits, Limits::digits)};

  /// How many terms the two series need: at 0.79 > π/4 the first term left out of the cosine, which
  /// is larger than that of the sine, is below a sixteenth of a rounding.
  static constexpr int count_terms() {
    int count = 1;
    Real next = Real(0.79) * Real(0.79) / 2;
    for (; next > Limits::epsilon() / 32; ++count)
      next *= Real(0.79) * Real(0.79) / Real((2 * count + 1) * (2 * count + 2));
    return count;
  }
  static constexpr int terms = count_terms();  ///< of each series

  /// ±1/n! for n = first, first + 2, first + 4, …, with alternating signs. Each n! fits into the
  /// digits of Real, so that the quotient alone is rounded; long double, which has other digits on
  /// other machines, takes no part in it.
  static constexpr std::array<Real, terms> series(int first) {
    std::array<Real, terms> coefficients = {};
    Real factorial = 1;
    for (int term = 0; term < terms; ++term) {
      coefficients[static_cast<std::size_t>(term)] = (term % 2 == 0 ? 1 : -1) / factorial;
      factorial *= static_cast<Real>((2 * term + first + 1) * (2 * term + first + 2));
    }
    return coefficients;
  }
  static constexpr std::array<Real, terms> sine_series = series(1);    ///< of x, x³, …
  static constexpr std::array<Real, terms> cosine_series = series(0);  ///< of 1, x², …
};

/// The sine and the cosine of one angle, as sine_cosine() returns them: no unit, between -1 and 1
/// up to its rounding errors, or both NaN.
template <class Real>
struct SineCosine {
  Real sine;    ///< of the angle
  Real cosine;  ///< of the same
};

/// The sine and cosine of `angle` (rad), each within two units in its last place; right next to a
/// multiple of a quarter turn within two and a half.
///
/// An angle whose size exceeds SineCosineConstants::limit gives NaN, as infinity and NaN do.
//! [sine_cosine]
template <class Real>
SineCosine<Real> sine_cosine(Real angle) {
  using Constants = SineCosineConstants<Real>;
  constexpr auto& part = Constants::quarter_turn;
  const auto whole = [](Real x) { return (x + Constants::to_whole) - Constants::to_whole; };

  // Take away the nearest number of quarter turns, piece by piece, the rounding of the second
  // piece with the rest.
  const Real turns = whole(angle * (1 / (part[0] + part[1])));
  const Real coarse = angle - turns * part[0];
  const Real fine = coarse - turns * part[1];
  const Real lost = (coarse - fine) - turns * part[1];
  const Real rest = fine + ((lost - turns * part[2]) - turns * part[3]);
  const auto answered = angle * angle <= Constants::limit * Constants::limit;
  const Real x = select(answered, rest, Constants::Limits::quiet_NaN());

  // Sum the series of sin x and cos x, |x| ≤ π/4, from the smallest term on. An x² that can't be
  // seen beside 1 counts as 0: what underflows is slow.
  const Real square = select(x * x < Constants::Limits::epsilon() / 16, Real(0), x * x);
  Real sine_sum = 0, cosine_sum = 0;
  for (std::size_t term = Constants::terms - 1; term > 0; --term) {
    sine_sum = square * (sine_sum + Constants::sine_series[term]);
    cosine_sum = square * (cosine_sum + Constants::cosine_series[term]);
  }
  const Real sine = x + x * sine_sum, cosine = 1 + cosine_sum;

  // Turn by the quarters that are left of whole turns: -2, -1, 0, 1 or 2.
  const Real quarter = turns - 4 * whole(turns / 4);
  const Real sine_sign = select(quarter * (quarter - 1) > 1, Real(-1), Real(1));
  const Real cosine_sign = select(quarter * (quarter + 1) > 1, Real(-1), Real(1));
  return {.sine = sine_sign * select(quarter * quarter == 1, cosine, sine),
          .cosine = cosine_sign * select(quarter * quarter == 1, sine, cosine)};
}
//! [sine_cosine]

/// sin x / x given sin x: 1 where x is 0. A tiny x costs no digits, since sin x is then x itself.
//! [sine_over_angle]
template <class Real>
Real sine_over_angle(Real sine, Same<Real> x) {
  return select(x == 0, Real(1), sine / x);
}
//! [sine_over_angle]

}  // namespace tumble
