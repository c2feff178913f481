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

/// Calls `draw(axis, side, corners)` for each side of a box that the reader sees: the axis on which
/// it lies, 1 or -1, and its corners once around, back to the first, on the page. `half` has half
/// the box's edges, and `turned` takes a vector of its axes to the world's.
template <class Turned, class Draw>
void for_each_seen_side(const Vec3d& half, const Turned& turned, const Draw& draw) {
  for (int axis = 0; axis < 3; ++axis)
    for (const int side : {1, -1}) {
      if (!faces_reader(turned(Vec3d(side * Vec3d::Unit(axis))))) continue;
      const Vec3d out = side * half[axis] * Vec3d::Unit(axis);
      const Vec3d one = half[(axis + 1) % 3] * Vec3d::Unit((axis + 1) % 3),
                  other = half[(axis + 2) % 3] * Vec3d::Unit((axis + 2) % 3);
      std::array<std::array<double, 2>, 5> corners;
      corners[0] = corners[4] = on_page(turned(Vec3d(out + one + other)));
      corners[1] = on_page(turned(Vec3d(out + one - other)));
      corners[2] = on_page(turned(Vec3d(out - one - other)));
      corners[3] = on_page(turned(Vec3d(out - one + other)));
      draw(axis, side, corners);
    }
}

}  // namespace tumble::support
