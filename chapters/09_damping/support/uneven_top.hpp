/// @file
/// A body that tumbles, for the checks and programs of this chapter.
#pragma once

#include <tumble/tumbling.hpp>

namespace tumble::support {

/// A top with principal moments of 1, 2 and 3 kg m² and angular velocity ω (rad/s) about its own
/// axes in this order. It stores the closest inverse moments, 1/2 and 1/3, first.
template <class Real>
Top<Real> uneven_top(const Vec3<Real>& angular_velocity) {
  Top<Real> top;
  top.inverse_moments = Vec3<Real>(Real(1) / 2, Real(1) / 3, 1);
  const Vec3<Real>& w = angular_velocity;
  set_angular_velocity_body(top, Vec3<Real>(w.y(), w.z(), w.x()));
  return top;
}

}  // namespace tumble::support
