// caught by: Turn the craft, and push and twist turn with it
// message: the force was turned and the place was not
#pragma once

#include <tumble/rigid_body.hpp>

template <class Real>
void fire(tumble::RigidBody<Real>& body, const tumble::Vec3<Real>& place,
          const tumble::Vec3<Real>& thrust) {
  const tumble::Vec3<Real> force = tumble::rotate(body.top.orientation, thrust);
  tumble::add_force_at(body, force, body.centre.position + place);
}
