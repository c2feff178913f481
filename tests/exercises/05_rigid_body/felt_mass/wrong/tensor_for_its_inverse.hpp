// caught by: Struck at its end a free rod feels like a quarter of itself
// message: the tensor stands where its inverse belongs
#pragma once

#include <tumble/rigid_body.hpp>

template <class Real>
Real felt_mass(const tumble::RigidBody<Real>& body, const tumble::Vec3<Real>& point,
               const tumble::Vec3<Real>& direction) {
  const tumble::Vec3<Real> lever = (point - body.centre.position).cross(direction);
  const tumble::Vec3<Real> turn = tumble::world_inertia(body.top) * lever;
  return 1 / (body.centre.inverse_mass + lever.dot(turn));
}
