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
  todo("one over how easily the body moves and turns");
}
