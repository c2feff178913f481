/// @file
/// The second method that every exact solution is held against: Boost.Odeint's Runge-Kutta rule of
/// eighth order by Fehlberg, in long double, on the equations of motion. It knows no solution.
#pragma once

#include <array>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cmath>
#include <support/checks.hpp>
#include <tumble/rotation_vector.hpp>
#include <tumble/top.hpp>

namespace tumble::support {

/// `state` after `time` seconds in so many equal steps, with `rates(state, rate, time)`.
template <std::size_t size, class Rates>
std::array<long double, size> integrated(std::array<long double, size> state, long double time,
                                         int steps, const Rates& rates) {
  using State = std::array<long double, size>;
  boost::numeric::odeint::runge_kutta_fehlberg78<State, long double> rule;
  const long double h = time / steps;
  for (int n = 0; n < steps; ++n) rule.do_step(rates, state, h * n, h);
  return state;
}

/// What a rule of eighth order leaves after `time`: (r h)⁸ r t, where nothing changes faster than
/// at the rate r. Roundings come on top, two a step.
inline long double eighth_order_error(long double rate, long double time, int steps) {
  return std::pow(rate * time / steps, 8.0L) * rate * time + 2 * steps * unit_roundoff<long double>;
}

/// What `count` roundings of numbers of size 1 add up to. Each is off by up to a unit roundoff, one
/// as likely as another, so their sum spreads by √(count/3) of them; it is five times as far off
/// once in two million times. They are counted so: an operation rounds once, an elementary function
/// twice (it is right to a unit in its last place), Carlson's integrals eight times (to four).
template <class Real>
Real spread(int count) {
  return 5 * std::sqrt(static_cast<Real>(count) / 3) * unit_roundoff<Real>;
}

/// The error that FreeTop may make of the orientation, rad, or of L relative to |L|, where the
/// fastest spin has turned by `turned` rad.
///
/// Each radian rounds 65 times: λ t + u₀ 7 (D has 5, λ two more and the root), 2E t/|L| 9, the
/// factor of the third kind 15, its n 13, Carlson's integrals in it 16, their products 5.
///
/// The rest comes once, 290: sn, cn and dn 14 each by Landen's steps, each of which halves what the
/// one before was off by; an arc tangent halves too, so that the quick angle has 30 at either end;
/// the third kind at the start 48 for each radian of at most π; two turns to L of 30 each, and 20
/// for the products.
template <class Real>
Real rounding_of_free_top(Real turned) {
  return spread<Real>(290) + spread<Real>(65) * turned;
}

/// The same numbers in long double: truth starts from the rounded values.
template <class Real>
Top<long double> in_long_double(const Top<Real>& top) {
  return {
      .orientation = {top.orientation.real, top.orientation.imaginary.template cast<long double>()},
      .angular_momentum_body = top.angular_momentum_body.template cast<long double>(),
      .torque = top.torque.template cast<long double>(),
      .inverse_moments = top.inverse_moments.template cast<long double>()};
}

/// A top by Euler's equations and q' = ½ q ω, under a torque in body axes that depends on how it
/// stands.
template <class Torque>
Top<long double> integrated_top(Top<long double> top, long double time, int steps,
                                const Torque& torque_body) {
  using State = std::array<long double, 7>;
  const auto top_at = [&](const State& s) {
    Top<long double> at = top;
    at.orientation = {s[0], {s[1], s[2], s[3]}};
    at.angular_momentum_body = {s[4], s[5], s[6]};
    return at;
  };
  const auto rates = [&](const State& state, State& rate, long double) {
    const Top<long double> now = top_at(state);
    const Vec3<long double> w = angular_velocity_body(now), half = w / 2;
    const Quaternion<long double> q = now.orientation * pure(half);
    const Vec3<long double> L = now.angular_momentum_body.cross(w) + torque_body(now);
    rate = {q.real, q.imaginary[0], q.imaginary[1], q.imaginary[2], L[0], L[1], L[2]};
  };
  const auto& [q, L] = std::pair(top.orientation, top.angular_momentum_body);
  top = top_at(
      integrated(State{q.real, q.imaginary[0], q.imaginary[1], q.imaginary[2], L[0], L[1], L[2]},
                 time, steps, rates));
  top.orientation = normalized(top.orientation);
  return top;
}

inline Top<long double> integrated_free_top(const Top<long double>& top, long double time,
                                            int steps) {
  return integrated_top(top, time, steps, [](const Top<long double>&) -> Vec3<long double> {
    return Vec3<long double>::Zero();
  });
}

/// The angle between two orientations (rad), and how far apart the angular momenta are, relative to
/// `size` (kg m²/s): the larger of the two.
template <class Real>
long double difference(const Top<Real>& top, const Top<long double>& truth, long double size) {
  const Top<long double> mine = in_long_double(top);
  const long double apart = (mine.angular_momentum_body - truth.angular_momentum_body).norm();
  return std::max(angle_between(mine.orientation, truth.orientation), apart / size);
}

/// The same, relative to |L|.
template <class Real>
long double difference(const Top<Real>& top, const Top<long double>& truth) {
  return difference(top, truth, truth.angular_momentum_body.norm());
}

}  // namespace tumble::support
