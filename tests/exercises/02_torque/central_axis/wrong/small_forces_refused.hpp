// caught by: Twice the force with twice the torque has the same axis
// message: gave up where it should have answered
#pragma once

#include <tumble/torque.hpp>

template <class Real>
tumble::Vec3<Real> point_on_central_axis(const tumble::Wrench<Real>& wrench) {
  const Real force_squared = wrench.force.squaredNorm();
  if (!(force_squared > Real(1e-8)))
    tumble::reject("force", force_squared, "N^2",
                   "a couple has no central axis: its square must be greater than 0");
  return wrench.about + wrench.force.cross(wrench.torque) / force_squared;
}
