// caught by: Two steady turns are the whole motion, at any time
// message: But ω itself goes round L
#pragma once

#include <cmath>
#include <tumble/rotation_vector.hpp>
#include <tumble/top.hpp>

template <class Real>
Real wobbles_per_turn(Real across, Real about, Real tilt) {
  return about / (across * std::cos(tilt));
}

template <class Real>
tumble::Quaternion<Real> after(const tumble::Top<Real>& top, Real time) {
  using namespace tumble;
  const Vec3<Real> turn = time * angular_velocity_world(top);
  return quaternion_of_rotation_vector(turn) * top.orientation;
}
