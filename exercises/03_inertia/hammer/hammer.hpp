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
  todo("the height of the centre of mass");
}

/// The moment of inertia (kg m²) about the x axis, through the grip's end at the origin.
template <class Real>
Real moment_about_grip(Real handle_mass, Real length, Real head_mass) {
  todo("the moment about the end of the grip");
}

/// Mass, centre of mass and inertia tensor about the centre of mass.
template <class Real>
tumble::MassProperties<Real> hammer(Real handle_mass, Real length, Real head_mass) {
  todo("the three mass properties, the tensor about the centre of mass");
}
