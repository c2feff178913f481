/// @file
/// Lab: two craft become one.
#pragma once

#include <exercise/todo.hpp>
#include <tumble/rigid_body.hpp>

/// The centre of mass (m, world) of the two together.
template <class Real>
tumble::Vec3<Real> common_centre(const tumble::RigidBody<Real>& a,
                                 const tumble::RigidBody<Real>& b) {
  //! [solution] the mean of the two places, weighted by mass
  using namespace tumble;
  const Real mass_a = mass_of(a.centre), mass_b = mass_of(b.centre);
  return (mass_a * a.centre.position + mass_b * b.centre.position) / (mass_a + mass_b);
  //! [end]
}

/// The velocity (m/s, world) of that point once the two hold each other.
template <class Real>
tumble::Vec3<Real> common_velocity(const tumble::RigidBody<Real>& a,
                                   const tumble::RigidBody<Real>& b) {
  //! [solution] the momentum of both, over the mass of both
  using namespace tumble;
  return (momentum(a) + momentum(b)) / (mass_of(a.centre) + mass_of(b.centre));
  //! [end]
}

/// The angular velocity (rad/s, world axes) of the pair once the two hold each other.
template <class Real>
tumble::Vec3<Real> common_spin(const tumble::RigidBody<Real>& a, const tumble::RigidBody<Real>& b) {
  //! [solution] the spin with which the pair has the angular momentum that both brought
  using namespace tumble;
  const Vec3<Real> centre = common_centre(a, b);
  Vec3<Real> angular_momentum = Vec3<Real>::Zero();
  Mat3<Real> inertia = Mat3<Real>::Zero();
  for (const RigidBody<Real>& body : {a, b}) {
    angular_momentum += angular_momentum_about(body, centre);
    inertia += world_inertia(body.top) +
               inertia_of_particle<Real>(mass_of(body.centre), body.centre.position - centre);
  }
  return inertia.inverse() * angular_momentum;
  //! [end]
}
