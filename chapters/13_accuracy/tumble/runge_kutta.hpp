/// @file
/// Runge–Kutta rules for a particle and for a top: the state as plain numbers, and their rates.
#pragma once

#include <tumble/force.hpp>
#include <tumble/tableaux.hpp>
#include <tumble/tumbling.hpp>
#include <utility>

namespace tumble {

/// All that changes in a body, as numbers in a row, so that a rule can weigh them alike: the
/// position and the velocity of a particle, the orientation and L of a top.
template <class Real, std::size_t count>
using Numbers = std::array<Real, count>;

template <class Real>
Numbers<Real, 6> numbers_of(const Particle<Real>& particle) {
  const Vec3<Real>&x = particle.position, &v = particle.velocity;
  return {x[0], x[1], x[2], v[0], v[1], v[2]};
}

template <class Real>
void set_numbers(Particle<Real>& particle, const Numbers<Real, 6>& numbers) {
  particle.position = {numbers[0], numbers[1], numbers[2]};
  particle.velocity = {numbers[3], numbers[4], numbers[5]};
}

/// How they change: the velocity, m/s, and the acceleration by the force gathered, m/s².
template <class Real>
[[gnu::always_inline]] inline Numbers<Real, 6> rates_of(const Numbers<Real, 6>& numbers,
                                                        const Particle<Real>& particle) {
  const Vec3<Real>& F = particle.force;
  const Real i = particle.inverse_mass;
  return {numbers[3], numbers[4], numbers[5], i * F[0], i * F[1], i * F[2]};
}

template <class Real>
Numbers<Real, 7> numbers_of(const Top<Real>& top) {
  const Vec3<Real>&u = top.orientation.imaginary, &L = top.angular_momentum_body;
  return {top.orientation.real, u[0], u[1], u[2], L[0], L[1], L[2]};
}

template <class Real>
void set_numbers(Top<Real>& top, const Numbers<Real, 7>& numbers) {
  top.orientation = {numbers[0], {numbers[1], numbers[2], numbers[3]}};
  top.angular_momentum_body = {numbers[4], numbers[5], numbers[6]};
}

/// Chapter 7's rate of the orientation, ½ q ω, and L × ω. Number by number, and inlined before all
/// else, so that the numbers stay in registers: a vector made on the way costs more than the sums.
//! [rates_of]
template <class Real>
[[gnu::always_inline]] inline Numbers<Real, 7> rates_of(const Numbers<Real, 7>& numbers,
                                                        const Vec3<Same<Real>>& inverse) {
  const Real w = numbers[0], x = numbers[1], y = numbers[2], z = numbers[3];
  const Real L0 = numbers[4], L1 = numbers[5], L2 = numbers[6];
  const Real w0 = inverse[0] * L0, w1 = inverse[1] * L1, w2 = inverse[2] * L2;
  return {-(x * w0 + y * w1 + z * w2) / 2,
          (w * w0 + y * w2 - z * w1) / 2,
          (w * w1 + z * w0 - x * w2) / 2,
          (w * w2 + x * w1 - y * w0) / 2,
          L1 * w2 - L2 * w1,
          L2 * w0 - L0 * w2,
          L0 * w1 - L1 * w0};
}
//! [rates_of]

/// The same with the torque gathered, which is given in world axes. About a locked axis L stays 0:
/// whatever locks it bears the torque and L × ω.
template <class Real>
[[gnu::always_inline]] inline Numbers<Real, 7> rates_of(const Numbers<Real, 7>& numbers,
                                                        const Top<Real>& top) {
  Numbers<Real, 7> rates = rates_of(numbers, top.inverse_moments);
  const Vec3<Real> torque = rotate_back(top.orientation, top.torque);
  const Vec3<Real> change = free_part<Real>(top, Vec3<Real>(rates[4], rates[5], rates[6]) + torque);
  for (std::size_t axis = 0; axis < 3; ++axis) rates[4 + axis] = change[Eigen::Index(axis)];
  return rates;
}

/// start + h Σ weight_j rate_j, with the weights of look i of the rule, or those of the step where
/// i is the number of looks. They are known when the program is compiled, so that nothing is spent
/// on those that are 0.
template <class Rule, std::size_t i, class Real, std::size_t count, std::size_t s, std::size_t... j>
Numbers<Real, count> led(const Numbers<Real, count>& start, Same<Real> time_step,
                         const std::array<Numbers<Real, count>, s>& rates,
                         std::index_sequence<j...>) {
  Numbers<Real, count> result;
  for (std::size_t n = 0; n < count; ++n) {
    Real sum = 0;
    const auto add = [&]<std::size_t k>() {
      constexpr long double weight = i < s ? Rule::rule.looks[i % s][k] : Rule::rule.weights[k];
      if constexpr (weight != 0) sum += static_cast<Real>(weight) * rates[k][n];
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
template <class Rule, class Real, std::size_t count, class RatesAt>
Numbers<Real, count> after_step(const Numbers<Real, count>& start,
                                const Numbers<Real, count>& first, Same<Real> time_step,
                                const RatesAt& rates_at) {
  static constexpr auto& rule = Rule::rule;
  constexpr std::size_t s = rule.nodes.size();
  std::array<Numbers<Real, count>, s> rates = {first};
  const auto look = [&]<std::size_t i>() {
    const auto there = led<Rule, i>(start, time_step, rates, std::make_index_sequence<i>());
    rates[i] = rates_at(there, static_cast<Real>(rule.nodes[i]) * time_step);
  };
  [&]<std::size_t... i>(std::index_sequence<i...>) {
    (look.template operator()<i + 1>(), ...);
  }
  (std::make_index_sequence<s - 1>());
  return led<Rule, s>(start, time_step, rates, std::make_index_sequence<s>());
}
//! [after_step]

/// A free top by such a rule, flattened for the same reason, its quaternion normalised afterwards.
/// Neither the energy nor L is kept, but both to the order of the rule, as long as |ω| h is small.
//! [turn_by_runge_kutta]
template <class Rule, class Real>
[[gnu::flatten]] void turn_by_runge_kutta(Top<Real>& top, Same<Real> time_step) {
  const Vec3<Real> inverse = top.inverse_moments;
  const auto rates_at = [inverse](const Numbers<Real, 7>& numbers, Real) {
    return rates_of(numbers, inverse);
  };
  const Numbers<Real, 7> start = numbers_of(top);
  set_numbers(top, after_step<Rule>(start, rates_at(start, 0), time_step, rates_at));
  top.orientation = renormalized(top.orientation);
}
//! [turn_by_runge_kutta]

/// A particle or a top under force or torque. `gather(body, time)` must leave in the body the sum
/// of what acts on it at that time (s). It has done so when the step begins, and when it ends.
//! [step_by_runge_kutta]
template <class Rule, class Body, class Gather, class Real>
[[gnu::flatten]] void step_by_runge_kutta(Body& body, const Gather& gather, Real time,
                                          Real time_step) {
  Body there = body;
  const auto rates_at = [&](const auto& numbers, Real ahead) {
    set_numbers(there, numbers);
    gather(there, time + ahead);
    return rates_of(numbers, there);
  };
  const auto start = numbers_of(body);
  set_numbers(body, after_step<Rule>(start, rates_of(start, body), time_step, rates_at));
  if constexpr (requires { body.orientation; }) body.orientation = renormalized(body.orientation);
  gather(body, time + time_step);
}
//! [step_by_runge_kutta]

}  // namespace tumble
