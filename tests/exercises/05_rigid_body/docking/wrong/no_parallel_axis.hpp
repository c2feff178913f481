// caught by: Two craft that already move as one body notice nothing
// message: Where is the parallel axis?
#pragma once

#include <tumble/rigid_body.hpp>

template <class Real>
tumble::Vec3<Real> common_centre(const tumble::RigidBody<Real>& a,
                                 const tumble::RigidBody<Real>& b) {
  using namespace tumble;
  const Real mass_a = mass_of(a.centre), mass_b = mass_of(b.centre);
  return (mass_a * a.centre.position + mass_b * b.centre.position) / (mass_a + mass_b);
}

template <class Real>
tumble::Vec3<Real> common_velocity(const tumble::RigidBody<Real>& a,
                                   const tumble::RigidBody<Real>& b) {
  using namespace tumble;
  return (momentum(a) + momentum(b)) / (mass_of(a.centre) + mass_of(b.centre));
}

template <class Real>
tumble::Vec3<Real> common_spin(const tumble::RigidBody<Real>& a, const tumble::RigidBody<Real>& b) {
  using namespace tumble;
  const Vec3<Real> centre = common_centre(a, b);
  Vec3<Real> angular_momentum = Vec3<Real>::Zero();
  Mat3<Real> inertia = Mat3<Real>::Zero();
  for (const RigidBody<Real>& body : {a, b}) {
    angular_momentum += angular_momentum_about(body, centre);
    inertia += world_inertia(body.top);
  }
  return inertia.inverse() * angular_momentum;
}
