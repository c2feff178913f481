/// @file
/// Exercise: where to hit the ball so that the hand feels nothing.
#pragma once

#include <exercise/todo.hpp>
#include <tumble/mass_properties.hpp>
#include <tumble/torque.hpp>

/// The velocity (m/s) of `point` just after a free body at rest was struck with `blow` N s at the
/// point `at`. Both points are in m, as seen from the centre of mass; all in the model's axes.
template <class Real>
tumble::Vec3<Real> velocity_after_blow(const tumble::MassProperties<Real>& body,
                                       const tumble::Vec3<Real>& blow, const tumble::Vec3<Real>& at,
                                       const tumble::Vec3<Real>& point) {
  todo("the velocity of the centre of mass, and that of the turn about it");
}

/// How far (m) beyond the centre of mass a blow across the bat must land to leave the grip at rest.
/// The grip is `grip` m from the centre of mass, on the other side. `moment` (kg m²) is that about
/// the axis through the centre of mass that is perpendicular to bat and blow; `mass` is in kg.
template <class Real>
Real sweet_spot(Real mass, Real moment, Real grip) {
  todo("the distance at which the grip stays at rest");
}
