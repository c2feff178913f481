// caught by: Turn the craft, and push and twist turn with it
// message: that is the torque in body axes
#pragma once

#include <tumble/rigid_body.hpp>

template <class Real>
void fire(tumble::RigidBody<Real>& body, const tumble::Vec3<Real>& place,
          const tumble::Vec3<Real>& thrust) {
  const tumble::Vec3<Real> force = tumble::rotate(body.top.orientation, thrust);
  tumble::add_force(body, force);
  tumble::add_torque(body, place.cross(thrust));
}
