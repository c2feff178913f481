/// @file
/// Lab: a satellite that turns itself over by moving two masses.
#pragma once

#include <exercise/todo.hpp>
#include <tumble/splitting.hpp>

/// Moves the two booms' masses, `mass` kg each, to `reach` m from the centre of mass, on both sides
/// along body x. `hull` holds the principal moments (kg m²) of all else. The masses move in no
/// time, pushed by nothing but the satellite itself.
template <class Real>
void set_booms(tumble::Top<Real>& top, const tumble::Vec3<Real>& hull, Real mass, Real reach) {
  todo("the inverse moments with the masses out there; what else changes?");
}

/// Whether the booms should be out; `out` says whether they are now. The order is: spin with −x
/// along the angular momentum, from wherever you are.
template <class Real>
bool booms_out(const tumble::Top<Real>& top, bool out) {
  todo("out until it is upside down, and in again when it is as far over as it gets");
}

/// The satellite after `steps` steps of `time_step` seconds, from a start with the booms in.
template <class Real>
tumble::Top<Real> flown(tumble::Top<Real> top, const tumble::Vec3<Real>& hull, Real mass,
                        Real reach, Real time_step, int steps) {
  bool out = false;
  for (int n = 0; n < steps; ++n) {
    out = booms_out(top, out);
    set_booms(top, hull, mass, out ? reach : 0);
    turn_by_splitting(top, time_step);
  }
  return top;
}
