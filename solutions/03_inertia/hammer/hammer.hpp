/// @file
/// Exercise: the mass properties of a hammer, by hand.
#pragma once

#include <exercise/todo.hpp>
#include <tumble/mass_properties.hpp>

/// A hammer in its own axes: a thin handle of `handle_mass` kg from the origin up along z to
/// `length` m, and there a head of `head_mass` kg, so small that it counts as one particle.

/// The height of the hammer's centre of mass, m.
template <class Real>
Real height_of_centre(Real handle_mass, Real length, Real head_mass) {
  //! [solution] the height of the centre of mass
  return (handle_mass * length / 2 + head_mass * length) / (handle_mass + head_mass);
  //! [end]
}

/// The moment of inertia (kg m²) about the x axis, through the grip's end at the origin.
template <class Real>
Real moment_about_grip(Real handle_mass, Real length, Real head_mass) {
  //! [solution] the moment about the end of the grip
  return handle_mass * length * length / 3 + head_mass * length * length;
  //! [end]
}

/// Mass, centre of mass and inertia tensor about the centre of mass.
template <class Real>
tumble::MassProperties<Real> hammer(Real handle_mass, Real length, Real head_mass) {
  //! [solution] the three mass properties, the tensor about the centre of mass
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
  //! [end]
}
