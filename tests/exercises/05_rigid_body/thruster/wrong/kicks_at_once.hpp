// caught by: Where in the world the craft is changes neither push nor twist
// message: the craft has moved, turned
#pragma once

#include <tumble/rigid_body.hpp>

template <class Real>
void fire(tumble::RigidBody<Real>& body, const tumble::Vec3<Real>& place,
          const tumble::Vec3<Real>& thrust) {
  const tumble::Vec3<Real> force = tumble::rotate(body.top.orientation, thrust);
  if (body.centre.position.x() > 50) body.centre.velocity += body.centre.inverse_mass * force;
  tumble::add_force_at(body, force, tumble::point_outward(tumble::pose_of(body), place));
}
