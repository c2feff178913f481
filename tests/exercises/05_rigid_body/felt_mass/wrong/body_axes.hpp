// caught by: A blow of felt mass times speed gives the point that speed, however the body lies
// message: right only as long as the brick is not turned
#pragma once

#include <tumble/rigid_body.hpp>

template <class Real>
Real felt_mass(const tumble::RigidBody<Real>& body, const tumble::Vec3<Real>& point,
               const tumble::Vec3<Real>& direction) {
  const tumble::Vec3<Real> lever = (point - body.centre.position).cross(direction);
  const tumble::Vec3<Real> turn = body.top.inverse_moments.cwiseProduct(lever);
  return 1 / (body.centre.inverse_mass + lever.dot(turn));
}
