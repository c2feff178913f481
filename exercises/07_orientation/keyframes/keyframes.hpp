/// @file
/// Exercise: the angular velocity that leads from one key frame to the next.
#pragma once

#include <exercise/todo.hpp>
#include <tumble/orientation.hpp>

/// The angular velocity (rad/s, world axes) with which turn_exponential() leads from one
/// orientation to the other in `time_step` seconds, the shorter way.
template <class Real>
tumble::Vec3<Real> angular_velocity_between(const tumble::Quaternion<Real>& from,
                                            const tumble::Quaternion<Real>& to, Real time_step) {
  todo("the rotation vector of the turn from the one to the other, per second");
}

/// The same for turn_first_order().
/// @throws std::invalid_argument if the two are half a turn apart, which that rule cannot make.
template <class Real>
tumble::Vec3<Real> angular_velocity_for_first_order(const tumble::Quaternion<Real>& from,
                                                    const tumble::Quaternion<Real>& to,
                                                    Real time_step) {
  todo("solve the first-order rule for the angular velocity, and refuse half a turn");
}
