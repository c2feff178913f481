/// @file
/// Lab: two craft become one.
#pragma once

#include <exercise/todo.hpp>
#include <tumble/rigid_body.hpp>

/// The centre of mass (m, world) of the two together.
template <class Real>
tumble::Vec3<Real> common_centre(const tumble::RigidBody<Real>& a,
                                 const tumble::RigidBody<Real>& b) {
  todo("the mean of the two places, weighted by mass");
}

/// The velocity (m/s, world) of that point once the two hold each other.
template <class Real>
tumble::Vec3<Real> common_velocity(const tumble::RigidBody<Real>& a,
                                   const tumble::RigidBody<Real>& b) {
  todo("the momentum of both, over the mass of both");
}

/// The angular velocity (rad/s, world axes) of the pair once the two hold each other.
template <class Real>
tumble::Vec3<Real> common_spin(const tumble::RigidBody<Real>& a, const tumble::RigidBody<Real>& b) {
  todo("the spin with which the pair has the angular momentum that both brought");
}
