/// @file
/// The classical Runge–Kutta rule of fourth order, for a particle and for a top.
#pragma once

#include <tumble/force.hpp>
#include <tumble/tumbling.hpp>

namespace tumble {

/// How position and velocity change, m/s and m/s².
template <class Real>
struct ParticleRate {
  Vec3<Real> position, velocity;
};

template <class Real>
ParticleRate<Real> rate_of(const Particle<Real>& particle) {
  return {particle.velocity, particle.inverse_mass * particle.force};
}

/// The particle as it would be after `time` seconds at that rate.
template <class Real>
Particle<Real> advanced(Particle<Real> particle, const ParticleRate<Real>& rate, Same<Real> time) {
  particle.position += time * rate.position;
  particle.velocity += time * rate.velocity;
  return particle;
}

/// How orientation and angular momentum change, 1/s and N m, body axes.
template <class Real>
struct TopRate {
  Quaternion<Real> orientation;
  Vec3<Real> angular_momentum_body;
};

/// Euler's equations without torque, and chapter 7's rate.
//! [rate_of_free]
template <class Real>
TopRate<Real> rate_of_free(const Top<Real>& top) {
  return {orientation_rate_body(top.orientation, angular_velocity_body(top)),
          gyroscopic_torque(top)};
}
//! [rate_of_free]

/// The same with the torque that the top has gathered. An axis that is locked bears its part.
template <class Real>
TopRate<Real> rate_of(const Top<Real>& top) {
  TopRate<Real> rate = rate_of_free(top);
  rate.angular_momentum_body += rotate_back(top.orientation, top.torque);
  rate.angular_momentum_body = free_part(top, rate.angular_momentum_body);
  return rate;
}

template <class Real>
Top<Real> advanced(Top<Real> top, const TopRate<Real>& rate, Same<Real> time) {
  top.orientation = top.orientation + time * rate.orientation;
  top.angular_momentum_body += time * rate.angular_momentum_body;
  return top;
}

/// Four looks at the rate: at the start, twice in the middle, at the end. `rate_at(state, ahead)`
/// answers for a state `ahead` seconds from now. Simpson's rule in disguise: where the rate depends
/// on time alone, it is that.
//! [runge_kutta]
template <class State, class Real, class RateAt>
State after_runge_kutta(const State& start, Real time_step, const RateAt& rate_at) {
  const Real half = time_step / 2;
  const auto first = rate_at(start, Real(0));
  const auto second = rate_at(advanced(start, first, half), half);
  const auto third = rate_at(advanced(start, second, half), half);
  const auto fourth = rate_at(advanced(start, third, time_step), time_step);
  State end = advanced(start, first, time_step / 6);
  end = advanced(end, second, time_step / 3);
  end = advanced(end, third, time_step / 3);
  return advanced(end, fourth, time_step / 6);
}
//! [runge_kutta]

/// A free top by that rule, its quaternion normalised afterwards. It keeps neither the energy nor
/// L, but both to fourth order, as long as |ω| h is small.
//! [turn_by_runge_kutta]
template <class Real>
void turn_by_runge_kutta(Top<Real>& top, Same<Real> time_step) {
  top =
      after_runge_kutta(top, time_step, [](const Top<Real>& at, Real) { return rate_of_free(at); });
  top.orientation = renormalized(top.orientation);
}
//! [turn_by_runge_kutta]

/// A particle or top under force or torque. `gather(body, time)` must leave in the body the sum of
/// what acts on it at that time (s). It has done so when the step begins, and has when it ends.
template <class Body, class Gather, class Real>
void step_by_runge_kutta(Body& body, const Gather& gather, Real time, Real time_step) {
  body = after_runge_kutta(body, time_step, [&](Body at, Real ahead) {
    if (ahead != 0) gather(at, time + ahead);
    return rate_of(at);
  });
  if constexpr (requires { body.orientation; }) body.orientation = renormalized(body.orientation);
  gather(body, time + time_step);
}

}  // namespace tumble
