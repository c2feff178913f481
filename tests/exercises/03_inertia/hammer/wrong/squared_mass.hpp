// caught by: Twice the head adds twice as much to the moment about the grip
// message: yours grew fourfold. Is a mass squared?
#pragma once
#include <tumble/mass_properties.hpp>

template <class Real>
Real height_of_centre(Real m, Real l, Real M) {
  return (m * l / 2 + M * l) / (m + M);
}

template <class Real>
Real moment_about_grip(Real m, Real l, Real M) {
  return m * l * l / 3 + M * M * l * l;
}

template <class Real>
tumble::MassProperties<Real> hammer(Real m, Real l, Real M) {
  const Real c = (m * l / 2 + M * l) / (m + M);
  const Real moment = m * (l * l / 12 + (c - l / 2) * (c - l / 2)) + M * (l - c) * (l - c);
  tumble::MassProperties<Real> body{.mass = m + M};
  body.centre_of_mass.z() = c;
  body.inertia.diagonal() << moment, moment, 0;
  return body;
}
