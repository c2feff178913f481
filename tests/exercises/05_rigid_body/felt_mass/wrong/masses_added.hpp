// caught by: Struck at its end a free rod feels like a quarter of itself
// message: heavier than the whole rod
#pragma once

#include <tumble/rigid_body.hpp>

template <class Real>
Real felt_mass(const tumble::RigidBody<Real>& body, const tumble::Vec3<Real>& point,
               const tumble::Vec3<Real>& direction) {
  const tumble::Vec3<Real> lever = (point - body.centre.position).cross(direction);
  const tumble::Vec3<Real> turn = tumble::inverse_inertia_times(body.top, lever);
  const Real easily = lever.dot(turn);
  return 1 / body.centre.inverse_mass + (easily > 0 ? 1 / easily : 0);
}
