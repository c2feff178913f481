// caught by: A couple has no force and no axis, and is refused
// message: gave up where it should have answered
#pragma once

#include <tumble/torque.hpp>

template <class Real>
tumble::Vec3<Real> point_on_central_axis(const tumble::Wrench<Real>& wrench) {
  const Real force_squared = wrench.force.squaredNorm();
  if (wrench.force.z() == 0)
    tumble::reject("force", force_squared, "N^2",
                   "a couple has no central axis: its square must be greater than 0");
  return wrench.about + wrench.force.cross(wrench.torque) / force_squared;
}
