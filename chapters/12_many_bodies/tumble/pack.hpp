/// @file
/// A pack: the same number of several bodies side by side, which the processor adds, multiplies and
/// compares with one instruction.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <tumble/damping.hpp>
#include <tumble/sine_cosine.hpp>

namespace tumble {

/// `width` answers yes or no, one for each body of a pack; &&, || and ! are of each by itself.
//! [mask]
template <class Real, int width>
struct PackMask {
  using Bits = std::conditional_t<sizeof(Real) == 4, std::int32_t, std::int64_t>;
  using Lanes __attribute__((vector_size(width * sizeof(Bits)))) = Bits;
  Lanes lanes;  ///< −1, which is all bits, for yes; 0 for no

  /// The answer for one of the bodies.
  bool operator[](int lane) const { return lanes[lane] != 0; }
  friend PackMask operator&&(PackMask a, PackMask b) { return {a.lanes & b.lanes}; }
  friend PackMask operator||(PackMask a, PackMask b) { return {a.lanes | b.lanes}; }
  friend PackMask operator!(PackMask a) { return {~a.lanes}; }
};
//! [mask]

/// Where a pack begins in memory, a multiple of so many bytes. Eigen, whose vectors hold packs,
/// aligns nothing to more than this machine's registers need.
template <class Real, int width>
inline constexpr std::size_t pack_alignment = std::min(
    width * sizeof(Real), std::max<std::size_t>(EIGEN_MAX_STATIC_ALIGN_BYTES, alignof(Real)));

/// `width` numbers, one for each of as many bodies. It stands where the chapters say `Real`: what
/// they wrote for one body then works on `width` of them at once. Its operators, abs() and sqrt()
/// take each number by itself; a comparison gives a PackMask, by which select() chooses, since an
/// `if` can't go both ways.
//! [pack]
template <class Real, int width>
struct Pack {
  static constexpr std::size_t bytes = width * sizeof(Real);
  static constexpr std::size_t alignment = pack_alignment<Real, width>;
  using Lanes __attribute__((vector_size(bytes), aligned(alignment))) = Real;  // the compilers' own
  Lanes lanes;  ///< all of them, for the processor

  friend Pack operator+(Pack a, Pack b) { return a.lanes + b.lanes; }
  friend Pack operator*(Pack a, Pack b) { return a.lanes * b.lanes; }
  //! [pack]

  Pack() = default;
  Pack(Lanes values) : lanes(values) {}
  template <class Number>
  requires std::is_arithmetic_v<Number> Pack(Number number)  // the same for every body
      : lanes(static_cast<Real>(number) - Lanes{}) {}

  /// The number of one of the bodies.
  Real operator[](int lane) const { return lanes[lane]; }

  friend Pack operator-(Pack a, Pack b) { return a.lanes - b.lanes; }
  friend Pack operator/(Pack a, Pack b) { return a.lanes / b.lanes; }
  friend Pack operator-(Pack a) { return -a.lanes; }
  Pack& operator+=(Pack b) { return *this = *this + b; }
  Pack& operator-=(Pack b) { return *this = *this - b; }
  Pack& operator*=(Pack b) { return *this = *this * b; }
  Pack& operator/=(Pack b) { return *this = *this / b; }

  using Mask = PackMask<Real, width>;
  friend Mask operator==(Pack a, Pack b) { return {a.lanes == b.lanes}; }
  friend Mask operator!=(Pack a, Pack b) { return {a.lanes != b.lanes}; }
  friend Mask operator<(Pack a, Pack b) { return {a.lanes < b.lanes}; }
  friend Mask operator<=(Pack a, Pack b) { return {a.lanes <= b.lanes}; }
  friend Mask operator>(Pack a, Pack b) { return {a.lanes > b.lanes}; }
  friend Mask operator>=(Pack a, Pack b) { return {a.lanes >= b.lanes}; }

  /// Body by body: the one number or the other.
  friend Pack select(Mask condition, Pack if_true, Pack if_false) {
    return condition.lanes ? if_true.lanes : if_false.lanes;
  }
  friend Pack abs(Pack a) { return select(a < 0, -a, a + 0); }
  friend Pack sqrt(Pack a) {
    for (int lane = 0; lane < width; ++lane) a.lanes[lane] = std::sqrt(a.lanes[lane]);
    return a;
  }
};

/// @cond what is known of numbers elsewhere, said of packs
/// What sine_cosine() needs to know of a pack is what it knows of one of its numbers.
template <class Real, int width>
struct SineCosineConstants<Pack<Real, width>> : SineCosineConstants<Real> {};

template <class Real, int width>
inline constexpr Real slowest_speed<Pack<Real, width>> = slowest_speed<Real>;
/// @endcond

}  // namespace tumble

/// @cond the same
/// The rounding of a pack is that of its numbers.
template <class Real, int width>
struct std::numeric_limits<tumble::Pack<Real, width>> : std::numeric_limits<Real> {};

template <class Real, int width>
inline constexpr Real std::numbers::pi_v<tumble::Pack<Real, width>> = std::numbers::pi_v<Real>;

/// Lets Eigen's vectors hold packs.
template <class Real, int width>
struct Eigen::NumTraits<tumble::Pack<Real, width>>
    : Eigen::GenericNumTraits<tumble::Pack<Real, width>> {
  enum { IsInteger = 0, IsComplex = 0, IsSigned = 1, RequireInitialization = 0 };
};
/// @endcond
