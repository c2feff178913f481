/// @file
/// Exercise: the line about which a set of forces does nothing but push and twist.
#pragma once

#include <exercise/todo.hpp>
#include <tumble/torque.hpp>

/// The point (m, world) of the central axis that is nearest to the point which the wrench is taken
/// about. About every point of that axis the torque is parallel to the force, or zero.
/// @throws std::invalid_argument if the force is zero: a couple has no such axis.
template <class Real>
tumble::Vec3<Real> point_on_central_axis(const tumble::Wrench<Real>& wrench) {
  //! [solution] the nearest point about which the torque is parallel to the force
  const Real force_squared = wrench.force.squaredNorm();
  if (!(force_squared > 0))
    tumble::reject("force", force_squared, "N^2",
                   "a couple has no central axis: its square must be greater than 0");
  return wrench.about + wrench.force.cross(wrench.torque) / force_squared;
  //! [end]
}
