/// @file
/// Where a point of space lies on the page of a drawing, seen from a little beside x and a little
/// above.
#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <tumble/real.hpp>

namespace tumble::support {

inline constexpr double seen_beside = 35 * std::numbers::pi / 180,
                        seen_above = 20 * std::numbers::pi / 180;

/// To the right and upwards on the page; lengths that lie in the page keep their size.
inline std::array<double, 2> on_page(const Vec3d& v) {
  const double depth = std::cos(seen_beside) * v.x() + std::sin(seen_beside) * v.y();
  return {std::cos(seen_beside) * v.y() - std::sin(seen_beside) * v.x(),
          std::cos(seen_above) * v.z() - std::sin(seen_above) * depth};
}

/// Whether a face with this outward normal is turned towards the reader.
inline bool faces_reader(const Vec3d& normal) {
  return std::cos(seen_above) *
                 (std::cos(seen_beside) * normal.x() + std::sin(seen_beside) * normal.y()) +
             std::sin(seen_above) * normal.z() >
         0;
}

}  // namespace tumble::support
