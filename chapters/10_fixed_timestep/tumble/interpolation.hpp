/// @file
/// What to draw between two steps.
#pragma once

#include <tumble/pose.hpp>

namespace tumble {

/// The pose at `fraction` (0 to 1, unchecked) of the way from one pose to another: the position on
/// the straight line, the orientation on the shortest arc, both at a steady rate.
///
/// The arc is that of the turn from the one to the other, so q and −q make no difference. A body
/// that turned by more than π in a step, and less than 2π, is drawn turning the other way, like a
/// wheel in a film; beyond 2π only what is left of whole turns is drawn.
//! [interpolated]
template <class Real>
Pose<Real> interpolated(const Pose<Real>& from, const Pose<Real>& to, Same<Real> fraction) {
  const Vec3<Real> turn = rotation_vector_of(to.orientation * conjugate(from.orientation));
  const Quaternion<Real> part = quaternion_of_rotation_vector<Real>(fraction * turn);
  return {.position = from.position + fraction * (to.position - from.position),
          .orientation = part * from.orientation};
}
//! [interpolated]

}  // namespace tumble
