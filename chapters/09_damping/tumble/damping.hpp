/// @file
/// Damping: a cheap stand-in for air, which takes away a fixed part of a speed in a fixed time.
#pragma once

#include <tumble/rigid_body.hpp>

namespace tumble {

/// The part of a speed that is left after `time` seconds of damping at `rate` per second:
/// e^(−k t). The solution of v̇ = −k v, so it does not matter how the time is cut into steps.
///
/// With a fixed time step it is a constant of the scene: compute it once, not once a body.
//! [fraction_kept]
template <class Real>
Real fraction_kept(Real rate, Same<Real> time) {
  using std::exp;
  return exp(-rate * time);
}
//! [fraction_kept]

/// A speed (m/s or rad/s) that is too small to matter: 2^33 times the root of the smallest normal
/// number, 9.3e-10 in float and 1.3e-144 in double. At 9.3e-10 m/s a millimetre takes 12 days.
///
/// A step multiplies such speeds by each other, by the time step and by moments. From there on what
/// comes out is not a normal number any more, loses its digits and is slow.
//! [slowest_speed]
template <class Real>
constexpr Real slowest_speed = [] {
  Real speed = Real(1LL << 33);
  for (int n = std::numeric_limits<Real>::min_exponent - 1; n < 0; n += 2) speed /= 2;
  return speed;
}();
//! [slowest_speed]

/// Leaves `fraction` of the velocity, see fraction_kept(). Components below slowest_speed become
/// zero, even if the fraction is 1. A static particle keeps its velocity, whatever it is.
//! [damp_particle]
template <class Real>
void damp(Particle<Real>& particle, Same<Real> fraction) {
  using std::abs;
  const Real kept = select(is_static(particle), Real(1), fraction);
  const Real slowest = select(is_static(particle), Real(0), slowest_speed<Real>);
  for (Real& speed : particle.velocity) {
    speed *= kept;
    speed = select(abs(speed) < slowest, Real(0), speed);
  }
}
//! [damp_particle]

/// Leaves `fraction` of the angular momentum, and so of the angular velocity, see fraction_kept().
/// Where the body turns about one of its axes slower than slowest_speed (rad/s), it stops.
//! [damp_top]
template <class Real>
void damp(Top<Real>& top, Same<Real> fraction) {
  using std::abs;
  top.angular_momentum_body *= fraction;
  const Vec3<Real> speed = angular_velocity_body(top);
  for (int axis = 0; axis < 3; ++axis) {
    Real& momentum = top.angular_momentum_body[axis];
    momentum = select(abs(speed[axis]) < slowest_speed<Real>, Real(0), momentum);
  }
}
//! [damp_top]

/// `rate` (1/s) itself, if bodies can be damped by it. `name` is what the error calls it.
/// @throws std::invalid_argument if it is negative, NaN or infinite.
//! [checked_damping_rate]
template <class Real>
Real checked_damping_rate(Real rate, std::string_view name = "damping rate") {
  require_finite(name, rate, "1/s");
  if (rate < 0) reject(name, rate, "1/s", "it must be 0 or more: a negative one adds speed");
  return rate;
}
//! [checked_damping_rate]

/// The damping rate (1/s) that leaves `fraction` of a speed after `time` seconds: −ln(d)/t. For
/// "0.99 in every step at 60 Hz" that is damping_rate_that_leaves(0.99, 1.0 / 60).
/// @throws std::invalid_argument if the fraction is not above 0 and at most 1, or the time not
/// above 0 and finite, or if the rate would be infinite.
template <class Real>
Real damping_rate_that_leaves(Real fraction, Same<Real> time) {
  require_between("fraction left by damping", fraction, "", 0, 1);
  if (fraction == 0)
    reject("fraction left by damping", fraction, "",
           "no rate stops a body at once: set its velocity to zero");
  require_finite("damping time", time, "s");
  if (!(time > 0)) reject("damping time", time, "s", "it must be greater than 0");
  return checked_damping_rate(-std::log(fraction) / time);
}

}  // namespace tumble
