// caught by: Twice the force with twice the torque has the same axis
// message: it doubled
#pragma once
#include <tumble/torque.hpp>

template <class Real>
tumble::Vec3<Real> point_on_central_axis(const tumble::Wrench<Real>& wrench) {
  const Real square = wrench.force.squaredNorm();
  if (!(square > 0)) tumble::reject("force", square, "N^2", "a couple has no central axis");
  return wrench.about + wrench.force.cross(wrench.torque) / wrench.force.norm();
}
