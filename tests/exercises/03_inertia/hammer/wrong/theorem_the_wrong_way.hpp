// caught by: About the centre of mass it is what a thousand particles give
// message: M d² is taken away
#pragma once
#include <tumble/mass_properties.hpp>

template <class Real>
Real height_of_centre(Real m, Real l, Real M) {
  return (m * l / 2 + M * l) / (m + M);
}

template <class Real>
Real moment_about_grip(Real m, Real l, Real M) {
  return m * l * l / 3 + M * l * l;
}

template <class Real>
tumble::MassProperties<Real> hammer(Real m, Real l, Real M) {
  const Real c = (m * l / 2 + M * l) / (m + M);
  const Real moment = m * l * l / 3 + M * l * l + (m + M) * c * c;
  tumble::MassProperties<Real> body{.mass = m + M};
  body.centre_of_mass.z() = c;
  body.inertia.diagonal() << moment, moment, 0;
  return body;
}
