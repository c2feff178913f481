// caught by: The centre of mass lies between the middle of the handle and the head, nearer the
// heavier message: as if they were equally heavy
#pragma once
#include <tumble/mass_properties.hpp>

template <class Real>
Real height_of_centre(Real m, Real l, Real M) {
  return (l / 2 + l) / 2 + 0 * (m + M);
}

template <class Real>
Real moment_about_grip(Real m, Real l, Real M) {
  return m * l * l / 3 + M * l * l;
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
