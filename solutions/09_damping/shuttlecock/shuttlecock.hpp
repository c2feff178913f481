/// @file
/// Lab: how a shuttlecock flies.
#pragma once

#include <exercise/todo.hpp>
#include <tumble/drag.hpp>
#include <tumble/force.hpp>

/// How fast everything falls that meets no air, m/s².
template <class Real>
constexpr Real gravity = Real(9.81);

/// The c in kg/m of the drag c |u| u on a body of `mass` kg that falls with `terminal_speed` m/s in
/// the end.
template <class Real>
Real coefficient_of(Real mass, Real terminal_speed) {
  //! [solution] the coefficient with which drag and weight balance at the terminal speed
  return mass * gravity<Real> / (terminal_speed * terminal_speed);
  //! [end]
}

/// The velocity (m/s) that drag alone leaves of `velocity` after `time` seconds, in air that moves
/// with `wind` (m/s). `mass` in kg, `coefficient` in kg/m. Exact, however long the time is.
template <class Real>
tumble::Vec3<Real> slowed(const tumble::Vec3<Real>& velocity, const tumble::Vec3<Real>& wind,
                          Real mass, Real coefficient, Real time) {
  //! [solution] the exact decay of the motion through the air
  const tumble::Vec3<Real> through_air = velocity - wind;
  return wind + through_air / (1 + coefficient * through_air.norm() * time / mass);
  //! [end]
}

/// One step of `time_step` seconds: kicked by gravity along −z, slowed by the air, moved.
template <class Real>
void step_shuttle(tumble::Particle<Real>& shuttle, const tumble::Vec3<Real>& wind, Real coefficient,
                  Real time_step) {
  //! [solution] the kick of gravity, the decay by drag, and the drift
  shuttle.velocity.z() -= time_step * gravity<Real>;
  shuttle.velocity = slowed<Real>(shuttle.velocity, wind, mass_of(shuttle), coefficient, time_step);
  shuttle.position += time_step * shuttle.velocity;
  //! [end]
}

/// The shuttle after `steps` steps.
template <class Real>
tumble::Particle<Real> flown(tumble::Particle<Real> shuttle, const tumble::Vec3<Real>& wind,
                             Real coefficient, Real time_step, int steps) {
  for (int n = 0; n < steps; ++n) step_shuttle<Real>(shuttle, wind, coefficient, time_step);
  return shuttle;
}
