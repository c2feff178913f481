/// @file
/// Exercise: the mass that a blow meets.
#pragma once

#include <exercise/todo.hpp>
#include <tumble/rigid_body.hpp>

/// How heavy (kg) the body feels to a blow at `point` (m) along `direction`, of length 1, both in
/// world axes: the impulse divided by the change of the point's velocity along it. Infinite where
/// nothing yields.
template <class Real>
Real felt_mass(const tumble::RigidBody<Real>& body, const tumble::Vec3<Real>& point,
               const tumble::Vec3<Real>& direction) {
  //! [solution] one over how easily the body moves and turns
  const tumble::Vec3<Real> lever = (point - body.centre.position).cross(direction);
  const tumble::Vec3<Real> turn = tumble::inverse_inertia_times(body.top, lever);
  return 1 / (body.centre.inverse_mass + lever.dot(turn));
  //! [end]
}
