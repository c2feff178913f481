/// @file
/// Random numbers that are the same on every machine; std::uniform_real_distribution's are not.
#pragma once

#include <random>
#include <tumble/real.hpp>

namespace tumble::support {

/// Draws numbers, from a seed on.
class RandomGenerator {
 public:
  explicit RandomGenerator(std::uint64_t seed) : engine_(seed) {}
  bool one_in(std::uint64_t n) { return engine_() % n == 0; }
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(engine_() % n); }
  /// Between 0 and 1.
  double operator()() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  /// Between −1 and 1.
  double both_ways() { return 2 * (*this)() - 1; }
  template <class Real>
  Real real() {
    return static_cast<Real>(both_ways());
  }
  /// Each component between −1 and 1.
  template <class Real>
  Vec3<Real> vector() {
    const Real x = real<Real>(), y = real<Real>();
    return {x, y, real<Real>()};
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace tumble::support
