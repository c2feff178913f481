// caught by: It flies where ever shorter steps say, and half the step is half the error
// message: The drift comes last
#pragma once

#include <tumble/drag.hpp>
#include <tumble/particle.hpp>

template <class Real>
constexpr Real gravity = Real(9.81);

template <class Real>
Real coefficient_of(Real mass, Real terminal_speed) {
  return mass * gravity<Real> / (terminal_speed * terminal_speed);
}

template <class Real>
tumble::Vec3<Real> slowed(const tumble::Vec3<Real>& velocity, const tumble::Vec3<Real>& wind,
                          Real mass, Real coefficient, Real time) {
  const tumble::Vec3<Real> through_air = velocity - wind;
  return wind + through_air / (1 + coefficient * through_air.norm() * time / mass);
}

template <class Real>
void step_shuttle(tumble::Particle<Real>& shuttle, const tumble::Vec3<Real>& wind, Real coefficient,
                  Real time_step) {
  shuttle.position += time_step * shuttle.velocity;
  shuttle.velocity.z() -= time_step * gravity<Real>;
  shuttle.velocity = slowed<Real>(shuttle.velocity, wind, mass_of(shuttle), coefficient, time_step);
}

template <class Real>
tumble::Particle<Real> flown(tumble::Particle<Real> shuttle, const tumble::Vec3<Real>& wind,
                             Real coefficient, Real time_step, int steps) {
  for (int n = 0; n < steps; ++n) step_shuttle<Real>(shuttle, wind, coefficient, time_step);
  return shuttle;
}
