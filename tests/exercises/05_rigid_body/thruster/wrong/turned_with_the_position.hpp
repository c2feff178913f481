// caught by: Where in the world the craft is changes neither push nor twist
// message: it was turned as well
#pragma once

#include <tumble/rigid_body.hpp>

template <class Real>
void fire(tumble::RigidBody<Real>& body, const tumble::Vec3<Real>& place,
          const tumble::Vec3<Real>& thrust) {
  const tumble::Vec3<Real> force = tumble::rotate(body.top.orientation, thrust);
  tumble::add_force_at(body, force,
                       tumble::rotate(body.top.orientation, body.centre.position + place));
}
