// caught by: The centre of mass lies between the middle of the handle and the head, nearer the
// heavier
// message: the height of the centre of mass of a hammer
#pragma once

#include <tumble/mass_properties.hpp>

template <class Real>
Real height_of_centre(Real handle_mass, Real length, Real head_mass) {
  return (handle_mass * length * length + head_mass * length) / (handle_mass + head_mass);
}

template <class Real>
Real moment_about_grip(Real handle_mass, Real length, Real head_mass) {
  return handle_mass * length * length / 3 + head_mass * length * length;
}

template <class Real>
tumble::MassProperties<Real> hammer(Real handle_mass, Real length, Real head_mass) {
  const Real mass = handle_mass + head_mass;
  const Real height = height_of_centre(handle_mass, length, head_mass);
  // Each part about the common centre: nothing large is subtracted, so no digit is lost.
  const Real to_middle = height - length / 2, to_head = length - height;
  const Real moment =
      handle_mass * (length * length / 12 + to_middle * to_middle) + head_mass * to_head * to_head;
  tumble::MassProperties<Real> body{.mass = mass};
  body.centre_of_mass.z() = height;
  body.inertia.diagonal() << moment, moment, 0;
  return body;
}
