/// @file
/// Random numbers for scenes.
#pragma once

#include <array>
#include <numbers>
#include <random>
#include <tumble/quaternion.hpp>
#include <tumble/sine_cosine.hpp>

namespace tumble {

/// Numbers that are the same with every standard library: of the engine the standard fixes every
/// bit, and the first 53 of them become a fraction.
class PortableRandom {
 public:
  explicit PortableRandom(std::uint64_t seed) : engine_(seed) {}

  /// From 0 on, below 1.
  double fraction() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  Vec3d between(const std::array<Vec3d, 2>& corners) {
    Vec3d point;
    for (Eigen::Index axis = 0; axis < 3; ++axis)
      point[axis] = corners[0][axis] + fraction() * (corners[1][axis] - corners[0][axis]);
    return point;
  }
  /// Every orientation alike (Shoemake, 1992).
  Quaternion<double> orientation() {
    const double split = fraction();
    const auto [s1, c1] = sine_cosine(2 * std::numbers::pi * fraction());
    const auto [s2, c2] = sine_cosine(2 * std::numbers::pi * fraction());
    const double a = std::sqrt(1 - split), b = std::sqrt(split);
    return {b * c2, {a * s1, a * c1, b * s2}};
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace tumble
