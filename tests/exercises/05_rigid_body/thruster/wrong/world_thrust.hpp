// caught by: Turn the craft, and push and twist turn with it
// message: the jet still pushes along the world's y
#pragma once

#include <tumble/rigid_body.hpp>

template <class Real>
void fire(tumble::RigidBody<Real>& body, const tumble::Vec3<Real>& place,
          const tumble::Vec3<Real>& thrust) {
  const tumble::Vec3<Real> force = thrust;
  tumble::add_force_at(body, force, tumble::point_outward(tumble::pose_of(body), place));
}
