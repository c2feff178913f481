/// @file
/// Runge–Kutta rules for a particle and for a top: the state as plain numbers, and their rates.
#pragma once

#include <tumble/force.hpp>
#include <tumble/tableaux.hpp>
#include <tumble/tumbling.hpp>
#include <utility>

namespace tumble {

/// All that changes in a body, as numbers in a column, so that a rule can weigh them alike. Eight,
/// since processors add four or eight at once; what is left over stays 0.
template <class Real>
using Numbers = std::array<Real, 7>;

template <class Real>
Numbers<Real> numbers_of(const Particle<Real>& particle) {
  const Vec3<Real>&x = particle.position, &v = particle.velocity;
  return {x[0], x[1], x[2], v[0], v[1], v[2], 0};
}

template <class Real>
void set_numbers(Particle<Real>& particle, const Numbers<Real>& numbers) {
  particle.position = {numbers[0], numbers[1], numbers[2]};
  particle.velocity = {numbers[3], numbers[4], numbers[5]};
}

/// How they change: the velocity, m/s, and the acceleration by the force gathered, m/s².
template <class Real>
Numbers<Real> rates_of(const Particle<Real>& particle) {
  const Vec3<Real>& v = particle.velocity;
  const Vec3<Real> a = particle.inverse_mass * particle.force;
  return {v[0], v[1], v[2], a[0], a[1], a[2], 0};
}

template <class Real>
Numbers<Real> numbers_of(const Top<Real>& top) {
  const Vec3<Real>&u = top.orientation.imaginary, &L = top.angular_momentum_body;
  return {top.orientation.real, u[0], u[1], u[2], L[0], L[1], L[2]};
}

template <class Real>
void set_numbers(Top<Real>& top, const Numbers<Real>& numbers) {
  top.orientation = {numbers[0], {numbers[1], numbers[2], numbers[3]}};
  top.angular_momentum_body = {numbers[4], numbers[5], numbers[6]};
}

/// Chapter 7's rate of the orientation, and Euler's equations with a torque (N m, body axes).
//! [rates_of]
template <class Real>
Numbers<Real> rates_of(const Top<Real>& top, const Vec3<Same<Real>>& torque_body) {
  const auto [w, u] = orientation_rate_body(top.orientation, angular_velocity_body(top));
  const Vec3<Real> N = gyroscopic_torque(top) + torque_body;
  return {w, u[0], u[1], u[2], N[0], N[1], N[2]};
}
//! [rates_of]

/// The same with the torque gathered.
template <class Real>
Numbers<Real> rates_of(const Top<Real>& top) {
  return rates_of(top, rotate_back(top.orientation, top.torque));
}

/// start + h Σ weight_j × rate_j. The weights are known when the program is compiled, so that
/// nothing is spent on those that are 0.
template <const auto& weights, class Real, std::size_t s, std::size_t... j>
Numbers<Real> led(const Numbers<Real>& start, Real time_step,
                  const std::array<Numbers<Real>, s>& rates, std::index_sequence<j...>) {
  Numbers<Real> result;
  for (std::size_t n = 0; n < result.size(); ++n) {
    Real sum = 0;
    const auto add = [&]<std::size_t k>() {
      if constexpr (weights[k] != 0) sum += static_cast<Real>(weights[k]) * rates[k][n];
    };
    (add.template operator()<j>(), ...);
    result[n] = start[n] + time_step * sum;
  }
  return result;
}

/// The numbers after one step: look after look, and then all of them weighed.
/// `rates_at(numbers, ahead)` answers for a state `ahead` seconds after the start; `first` is what
/// it would say of the start.
//! [after_step]
template <class Rule, class Real, class RatesAt>
Numbers<Real> after_step(const Numbers<Real>& start, const Numbers<Real>& first, Real time_step,
                         const RatesAt& rates_at) {
  static constexpr auto& rule = Rule::rule;
  constexpr std::size_t s = rule.nodes.size();
  std::array<Numbers<Real>, s> rates = {first};
  const auto look = [&]<std::size_t i>() {
    static constexpr auto& looks = rule.looks[i];
    rates[i] = rates_at(led<looks, Real>(start, time_step, rates, std::make_index_sequence<i>()),
                        static_cast<Real>(rule.nodes[i]) * time_step);
  };
  [&]<std::size_t... i>(std::index_sequence<i...>) {
    (look.template operator()<i + 1>(), ...);
  }
  (std::make_index_sequence<s - 1>());
  static constexpr auto& weights = rule.weights;
  return led<weights, Real>(start, time_step, rates, std::make_index_sequence<s>());
}
//! [after_step]

/// A free top by such a rule, its quaternion normalised afterwards. Neither the energy nor L is
/// kept, but both to the order of the rule, as long as |ω| h is small.
//! [turn_by_runge_kutta]
template <class Rule, class Real>
void turn_by_runge_kutta(Top<Real>& top, Same<Real> time_step) {
  const auto rates_at = [&](const Numbers<Real>& numbers, Real) -> Numbers<Real> {
    Top<Real> at = top;
    set_numbers(at, numbers);
    return rates_of<Real>(at, Vec3<Real>::Zero());
  };
  const Numbers<Real> start = numbers_of(top);
  set_numbers(top, after_step<Rule>(start, rates_at(start, 0), time_step, rates_at));
  top.orientation = renormalized(top.orientation);
}
//! [turn_by_runge_kutta]

/// A particle or a top under force or torque. `gather(body, time)` must leave in the body the sum
/// of what acts on it at that time (s). It has done so when the step begins, and when it ends.
//! [step_by_runge_kutta]
template <class Rule, class Body, class Gather, class Real>
void step_by_runge_kutta(Body& body, const Gather& gather, Real time, Real time_step) {
  const auto rates_at = [&](const Numbers<Real>& numbers, Real ahead) -> Numbers<Real> {
    Body at = body;
    set_numbers(at, numbers);
    gather(at, time + ahead);
    return rates_of(at);
  };
  set_numbers(body, after_step<Rule, Real>(numbers_of(body), rates_of(body), time_step, rates_at));
  if constexpr (requires { body.orientation; }) body.orientation = renormalized(body.orientation);
  gather(body, time + time_step);
}
//! [step_by_runge_kutta]

}  // namespace tumble
