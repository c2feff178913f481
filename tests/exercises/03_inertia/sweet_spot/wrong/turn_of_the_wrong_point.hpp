// caught by: What a blow w at a does to b along u, a blow u at b does to a along w
// message: it must be
#pragma once
#include <tumble/mass_properties.hpp>
#include <tumble/torque.hpp>

template <class Real>
tumble::Vec3<Real> velocity_after_blow(const tumble::MassProperties<Real>& body,
                                       const tumble::Vec3<Real>& blow, const tumble::Vec3<Real>& at,
                                       const tumble::Vec3<Real>& point) {
  const tumble::Vec3<Real> spin = body.inertia.inverse() * at.cross(blow);
  return blow / body.mass + spin.cross(at) + 0 * point;
}

template <class Real>
Real sweet_spot(Real mass, Real moment, Real grip) {
  return moment / (mass * grip);
}
