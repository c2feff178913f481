// caught by: A wall feels infinitely heavy, and a wheel on a fixed axle resists by its turn alone
// message: divided by its inverse mass
#pragma once

#include <tumble/rigid_body.hpp>

template <class Real>
Real felt_mass(const tumble::RigidBody<Real>& body, const tumble::Vec3<Real>& point,
               const tumble::Vec3<Real>& direction) {
  const tumble::Vec3<Real> lever = (point - body.centre.position).cross(direction);
  const tumble::Vec3<Real> turn = tumble::inverse_inertia_times(body.top, lever);
  const Real mass = 1 / body.centre.inverse_mass;
  return mass / (1 + mass * lever.dot(turn));
}
