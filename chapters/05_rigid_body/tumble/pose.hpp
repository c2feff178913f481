/// @file
/// Where something is and which way it faces, and how one pose is given in another.
#pragma once

#include <tumble/require.hpp>
#include <tumble/rotation_vector.hpp>

namespace tumble {

/// The place and orientation of one set of axes, seen from another: the inner axes from the outer
/// ones. A body's pose is that of its body axes, seen from the world.
//! [pose]
template <class Real>
struct Pose {
  Vec3<Real> position = Vec3<Real>::Zero();  ///< of the inner origin, m, outer axes
  Quaternion<Real> orientation = {};         ///< from inner axes to outer ones
};
//! [pose]

using Posef = Pose<float>;
using Posed = Pose<double>;

/// A point given in the inner axes (m), as the outer ones see it.
template <class Real>
Vec3<Real> point_outward(const Pose<Real>& pose, const Vec3<Same<Real>>& point) {
  return pose.position + rotate(pose.orientation, point);
}

/// A point given in the outer axes (m), as the inner ones see it.
template <class Real>
Vec3<Real> point_inward(const Pose<Real>& pose, const Vec3<Same<Real>>& point) {
  return rotate_back<Real>(pose.orientation, point - pose.position);
}

/// `inner` is given in `middle`, and `middle` in the outer axes: the same `inner` in the outer
/// axes.
//! [composed]
template <class Real>
Pose<Real> composed(const Pose<Real>& middle, const Pose<Real>& inner) {
  return {.position = point_outward(middle, inner.position),
          .orientation = middle.orientation * inner.orientation};
}
//! [composed]

/// The outer axes as the inner ones see them, so that composed(pose, inverse(pose)) is no move.
template <class Real>
Pose<Real> inverse(const Pose<Real>& pose) {
  return {.position = rotate_back<Real>(pose.orientation, -pose.position),
          .orientation = conjugate(pose.orientation)};
}

/// `pose` with its orientation brought to length 1.
/// @throws std::invalid_argument if the position is not finite or the quaternion not nearly unit.
template <class Real>
Pose<Real> checked_pose(const Pose<Real>& pose, std::string_view name) {
  const std::string prefix(name);
  require_finite(prefix + ": position", pose.position, "m");
  return {.position = pose.position,
          .orientation = checked_orientation(pose.orientation, prefix + ": orientation")};
}

}  // namespace tumble
