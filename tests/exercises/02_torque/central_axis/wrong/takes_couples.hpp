// caught by: A couple has no force and no axis, and is refused
// message: a couple was given a point
#pragma once
#include <tumble/torque.hpp>

template <class Real>
tumble::Vec3<Real> point_on_central_axis(const tumble::Wrench<Real>& wrench) {
  const Real square = wrench.force.squaredNorm();
  return wrench.about + wrench.force.cross(wrench.torque) / square;
}
