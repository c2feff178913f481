// caught by: The blow's work is the energy of the body: half of the blow times the velocity where
// it hits message: the turn takes energy away
#pragma once
#include <tumble/mass_properties.hpp>
#include <tumble/torque.hpp>

template <class Real>
tumble::Vec3<Real> velocity_after_blow(const tumble::MassProperties<Real>& body,
                                       const tumble::Vec3<Real>& blow, const tumble::Vec3<Real>& at,
                                       const tumble::Vec3<Real>& point) {
  const tumble::Vec3<Real> spin = body.inertia.inverse() * at.cross(blow);
  return blow / body.mass + point.cross(spin);
}

template <class Real>
Real sweet_spot(Real mass, Real moment, Real grip) {
  return moment / (mass * grip);
}
