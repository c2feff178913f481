/// @file
/// The exact solutions as methods: one step of any length.
#pragma once

#include <support/problems.hpp>
#include <tumble/exact/free_top.hpp>
#include <tumble/exact/heavy_top.hpp>
#include <tumble/exact/kepler.hpp>
#include <tumble/exact/oscillator.hpp>
#include <tumble/exact/projectile.hpp>

namespace tumble::support {

/// The exact motion of a free top for `time_step` seconds, as a rung: whatever it costs to find the
/// solution that goes through the present state is paid in every step.
template <class Real>
void turn_exactly(Top<Real>& top, Same<Real> time_step) {
  top = exact::FreeTop<Real>(top).at(time_step);
}

/// Where each problem's body is `time` seconds after `start`.
template <class Real>
Top<Real> exactly_after(const NoTorque<Real>&, Top<Real> top, Same<Real> time) {
  turn_exactly(top, time);
  return top;
}

template <class Real>
Top<Real> exactly_after(const Weight<Real>& weight, const Top<Real>& top, Same<Real> time) {
  return exact::HeavyTop<Real>(top, Vec3<Real>(0, 0, -weight.weight_times_arm)).at(time);
}

template <class Real>
Particle<Real> exactly_after(const SpringForce<Real>& spring, Particle<Real> particle,
                             Same<Real> time) {
  const Real rate = std::sqrt(spring.stiffness * particle.inverse_mass);
  for (int axis = 0; axis < 3; ++axis) {
    const exact::OscillatorState<Real> start{particle.position[axis], particle.velocity[axis]};
    const auto end = exact::Oscillator<Real>(start, rate, 0).at(time);
    particle.position[axis] = end.position;
    particle.velocity[axis] = end.velocity;
  }
  return particle;
}

template <class Real>
Particle<Real> exactly_after(const Star<Real>& star, const Particle<Real>& particle,
                             Same<Real> time) {
  return exact::KeplerOrbit<Real>(particle, star.strength).at(time);
}

template <class Real>
Particle<Real> exactly_after(const GravityInAir<Real>& air, const Particle<Real>& particle,
                             Same<Real> time) {
  const Vec3<Real> acceleration(0, 0, -particle.inverse_mass * air.weight);
  return exact::Projectile<Real>(particle, acceleration, air.drag_rate).at(time);
}

}  // namespace tumble::support
