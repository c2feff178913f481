/// @file
/// Exercise: the motion of a thrown plate, exactly.
#pragma once

#include <cmath>
#include <exercise/todo.hpp>
#include <tumble/rotation_vector.hpp>
#include <tumble/top.hpp>

/// How often the axis of a free symmetric top goes round L while the top spins once about its axis,
/// at the rate ω₃. The moments (kg m²) are those `across` and `about` the axis, which stands `tilt`
/// rad from L.
template <class Real>
Real wobbles_per_turn(Real across, Real about, Real tilt) {
  //! [solution] the rate of the axis round L, over the rate of the spin
  return about / (across * std::cos(tilt));
  //! [end]
}

/// The orientation after `time` seconds of a free top whose axis is body z: its inverse moments
/// about x and y are equal.
template <class Real>
tumble::Quaternion<Real> after(const tumble::Top<Real>& top, Real time) {
  //! [solution] a turn about L in the world, and one about the axis in the body
  using namespace tumble;
  const Vec3<Real>& inverse = top.inverse_moments;
  const Vec3<Real> round = time * inverse.x() * angular_momentum_world(top);
  const Real rate = (inverse.z() - inverse.x()) * top.angular_momentum_body.z();
  const Vec3<Real> about_axis(0, 0, time * rate);
  return quaternion_of_rotation_vector(round) * top.orientation *
         quaternion_of_rotation_vector(about_axis);
  //! [end]
}
