// caught by: About the point found the torque is parallel to the force
// message: the point lies on the wrong side
#pragma once
#include <tumble/torque.hpp>

template <class Real>
tumble::Vec3<Real> point_on_central_axis(const tumble::Wrench<Real>& wrench) {
  const Real square = wrench.force.squaredNorm();
  if (!(square > 0)) tumble::reject("force", square, "N^2", "a couple has no central axis");
  return wrench.about + wrench.torque.cross(wrench.force) / square;
}
