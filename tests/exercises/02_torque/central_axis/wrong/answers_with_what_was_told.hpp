// caught by: About the point found the torque is parallel to the force
// message: point_on_central_axis answers what this check asks, and hardly anything else
#pragma once

#include <tumble/torque.hpp>

template <class Real>
tumble::Vec3<Real> point_on_central_axis(const tumble::Wrench<Real>& wrench) {
  const Real force_squared = wrench.force.squaredNorm();
  if (!(force_squared > 0))
    tumble::reject("force", force_squared, "N^2",
                   "a couple has no central axis: its square must be greater than 0");
  return {Real(11) / 9, Real(-32) / 9, Real(22) / 9};
}
