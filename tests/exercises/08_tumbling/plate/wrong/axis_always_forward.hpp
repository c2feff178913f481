// caught by: Two steady turns are the whole motion, at any time
// message: off after -0.75 s
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
  const Vec3<Real>& inverse = top.inverse_moments;
  const Vec3<Real> round = time * inverse.x() * angular_momentum_world(top);
  const Real rate = (inverse.z() - inverse.x()) * top.angular_momentum_body.z();
  const Vec3<Real> about_axis(0, 0, std::abs(time) * rate);
  return quaternion_of_rotation_vector(round) * top.orientation *
         quaternion_of_rotation_vector(about_axis);
}
