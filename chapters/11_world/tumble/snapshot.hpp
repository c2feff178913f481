/// @file
/// How all bodies of a world move at one moment, to come back to it.
#pragma once

#include <tumble/bodies.hpp>

namespace tumble {

/// The motion of all bodies after so many steps. What acts on them is not part of it.
//! [snapshot]
template <class Real>
struct Snapshot {
  std::int64_t ticks = 0;
  std::vector<Vec3<Real>> positions, velocities;  ///< of the bodies, in the order of the world
  std::vector<Quaternion<Real>> orientations;     ///< of the tops
  std::vector<Vec3<Real>> angular_momenta;        ///< body axes
  std::vector<bool> has_moved, has_turned;        ///< what the plan knew of the bodies
};
//! [snapshot]

}  // namespace tumble
