/// @file
/// Exercise: a jet that is fixed to a body.
#pragma once

#include <exercise/todo.hpp>
#include <tumble/rigid_body.hpp>

/// Adds what a jet does in this step. It sits at `place` (m, from the centre of mass) and pushes
/// with `thrust` (N), both in body axes.
template <class Real>
void fire(tumble::RigidBody<Real>& body, const tumble::Vec3<Real>& place,
          const tumble::Vec3<Real>& thrust) {
  //! [solution] the jet's force at the jet's place, both as the world sees them
  const tumble::Vec3<Real> force = tumble::rotate(body.top.orientation, thrust);
  tumble::add_force_at(body, force, tumble::point_outward(tumble::pose_of(body), place));
  //! [end]
}
