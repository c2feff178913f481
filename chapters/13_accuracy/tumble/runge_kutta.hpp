/// @file
/// Runge–Kutta rules for a particle and for a top: the state as plain numbers, and their rates.
#pragma once

#include <tumble/force.hpp>
#include <tumble/tableaux.hpp>
#include <tumble/tumbling.hpp>
#include <utility>

namespace tumble {

/// Numbers that a rule weighs alike: a particle's position and velocity, a top's orientation and L,
/// the unknowns of a reduced motion, or the rates of any of these.
template <class Real, std::size_t count>
using StateVector = std::array<Real, count>;

template <class Real>
StateVector<Real, 6> state_of(const Particle<Real>& particle) {
  const Vec3<Real>&x = particle.position, &v = particle.velocity;
  return {x[0], x[1], x[2], v[0], v[1], v[2]};
}

template <class Real>
void set_state(Particle<Real>& particle, const StateVector<Real, 6>& state) {
  particle.position = {state[0], state[1], state[2]};
  particle.velocity = {state[3], state[4], state[5]};
}

/// How they change: the velocity, m/s, and the acceleration by the force of now, m/s².
template <class Real>
[[gnu::always_inline]] inline StateVector<Real, 6> rates_of(const StateVector<Real, 6>& state,
                                                            const Particle<Real>& particle) {
  const Vec3<Real>& F = particle.force;
  const Real i = particle.inverse_mass;
  return {state[3], state[4], state[5], i * F[0], i * F[1], i * F[2]};
}

template <class Real>
StateVector<Real, 7> state_of(const Top<Real>& top) {
  const Vec3<Real>&u = top.orientation.imaginary, &L = top.angular_momentum_body;
  return {top.orientation.real, u[0], u[1], u[2], L[0], L[1], L[2]};
}

template <class Real>
void set_state(Top<Real>& top, const StateVector<Real, 7>& state) {
  top.orientation = {state[0], {state[1], state[2], state[3]}};
  top.angular_momentum_body = {state[4], state[5], state[6]};
}

/// Chapter 7's rate of the orientation, ½ q ω, and L × ω. Number by number, and inlined before all
/// else, so that the numbers stay in registers: a vector made on the way costs more than the sums.
template <class Real>
[[gnu::always_inline]] inline StateVector<Real, 7> rates_of(const StateVector<Real, 7>& state,
                                                            const Vec3<Same<Real>>& inverse) {
  const Real w = state[0], x = state[1], y = state[2], z = state[3];
  const Real L0 = state[4], L1 = state[5], L2 = state[6];
  const Real w0 = inverse[0] * L0, w1 = inverse[1] * L1, w2 = inverse[2] * L2;
  return {-(x * w0 + y * w1 + z * w2) / 2,
          (w * w0 + y * w2 - z * w1) / 2,
          (w * w1 + z * w0 - x * w2) / 2,
          (w * w2 + x * w1 - y * w0) / 2,
          L1 * w2 - L2 * w1,
          L2 * w0 - L0 * w2,
          L0 * w1 - L1 * w0};
}

/// The rates of a free top, and `torque` (N m, body axes). About a locked axis L stays 0: whatever
/// locks it bears the torque and L × ω.
template <class Real>
[[gnu::always_inline]] inline StateVector<Real, 7> with_torque_body(
    const StateVector<Real, 7>& rates, const Top<Real>& top, const Vec3<Same<Real>>& torque) {
  const auto free = [&](int axis) { return select(top.inverse_moments[axis] == 0, Real(0), 1); };
  return {rates[0],
          rates[1],
          rates[2],
          rates[3],
          free(0) * (rates[4] + torque[0]),
          free(1) * (rates[5] + torque[1]),
          free(2) * (rates[6] + torque[2])};
}

/// The same with the torque of now, which is given in world axes.
template <class Real>
[[gnu::always_inline]] inline StateVector<Real, 7> rates_of(const StateVector<Real, 7>& state,
                                                            const Top<Real>& top) {
  const Vec3<Real> torque = rotate_back(top.orientation, top.torque);
  return with_torque_body<Real>(rates_of(state, top.inverse_moments), top, torque);
}

/// Calls `visit` with 0, 1, … count − 1, each known when the program is compiled.
template <std::size_t count, class Visit>
[[gnu::always_inline]] inline void for_each_index(const Visit& visit) {
  [&]<std::size_t... i>(std::index_sequence<i...>) {
    (visit(std::integral_constant<std::size_t, i>()), ...);
  }
  (std::make_index_sequence<count>());
}

/// Σ weight_j rate_j for number n, with the weights that Row::row lists. They are known when the
/// program is compiled, so that nothing is spent on those that are 0. The stage just evaluated
/// comes last, so that the processor adds up the others while it waits for it.
template <class Row, std::size_t n, class Real, std::size_t count, std::size_t s>
[[gnu::always_inline]] inline Real weighed_number(
    const std::array<StateVector<Real, count>, s>& rates) {
  Real sum = 0;
  bool is_begun = false;  // known to the compiler too: nothing is added to the 0
  for_each_index<Row::row.size()>([&](auto j) {
    constexpr long double weight = Row::row[j];
    if constexpr (weight != 0) {
      const Real part = static_cast<Real>(weight) * rates[j][n];
      sum = is_begun ? sum + part : part;
      is_begun = true;
    }
  });
  return sum;
}

/// of(0), of(1), …, one by one and not in a loop. Out of a loop g++ would make sums of two or four
/// numbers at once, and such a sum has to wait until the single numbers of the last stage have all
/// arrived in memory, which made a step take twice as long.
//! [each]
template <class Real, std::size_t count, class Of>
[[gnu::always_inline]] inline StateVector<Real, count> each(const Of& of) {
  return [&]<std::size_t... n>(std::index_sequence<n...>) {
    return StateVector<Real, count>{of(std::integral_constant<std::size_t, n>())...};
  }
  (std::make_index_sequence<count>());
}
//! [each]

/// Σ weight_j rate_j.
template <class Row, class Real, std::size_t count, std::size_t s>
[[gnu::always_inline]] inline StateVector<Real, count> weighed(
    const std::array<StateVector<Real, count>, s>& rates) {
  return each<Real, count>([&](auto n) { return weighed_number<Row, n>(rates); });
}

/// The rows of a rule's tableau: that of stage i, and that of the whole step.
template <class Rule, std::size_t i>
struct RowOfStage {
  static constexpr auto& row = Rule::rule.coefficients[i];
};
template <class Rule>
struct RowOfStep {
  static constexpr auto& row = Rule::rule.weights;
};

/// start + h Σ weight_j rate_j.
template <class Row, class Real, std::size_t count, std::size_t s>
[[gnu::always_inline]] inline StateVector<Real, count> combine(
    const StateVector<Real, count>& start, Same<Real> time_step,
    const std::array<StateVector<Real, count>, s>& rates) {
  return each<Real, count>(
      [&](auto n) { return start[n] + time_step * weighed_number<Row, n>(rates); });
}

/// The state of a stage: the same, added up from the start on with the weights times h, so that it
/// is one product and one sum away from the stage before. This rounds a little more than the step
/// itself may.
template <class Row, class Real, std::size_t count, std::size_t s>
[[gnu::always_inline]] inline StateVector<Real, count> combine_for_stage(
    const StateVector<Real, count>& start, Same<Real> time_step,
    const std::array<StateVector<Real, count>, s>& rates) {
  return each<Real, count>([&](auto n) {
    Real sum = start[n];
    for_each_index<Row::row.size()>([&](auto j) {
      constexpr long double weight = Row::row[j];
      if constexpr (weight != 0) sum += (static_cast<Real>(weight) * time_step) * rates[j][n];
    });
    return sum;
  });
}

/// The number of a stage, known when the program is compiled.
template <std::size_t i>
using StageNumber = std::integral_constant<std::size_t, i>;

/// Evaluates all stages of a rule but the first, which `rates` holds already. `rates_at(state,
/// ahead, StageNumber<i>())` gives the rates of a state `ahead` seconds after the start. `rates`
/// may have room for more.
template <class Rule, class Real, std::size_t count, std::size_t room, class RatesAt>
[[gnu::always_inline]] inline void evaluate_stages(
    const StateVector<Real, count>& start, Same<Real> time_step,
    std::array<StateVector<Real, count>, room>& rates, const RatesAt& rates_at) {
  static constexpr auto& rule = Rule::rule;
  for_each_index<rule.nodes.size() - 1>([&](auto before) {
    constexpr StageNumber<before + 1> i;
    const auto there = combine_for_stage<RowOfStage<Rule, i>>(start, time_step, rates);
    rates[i] = rates_at(there, static_cast<Real>(rule.nodes[i]) * time_step, i);
  });
}

/// The state after one step: all stages, then their weighted sum. `first` is what
/// rates_at() would return for the start.
//! [after_step]
template <class Rule, class Real, std::size_t count, class RatesAt>
StateVector<Real, count> after_step(const StateVector<Real, count>& start,
                                    const StateVector<Real, count>& first, Same<Real> time_step,
                                    const RatesAt& rates_at) {
  std::array<StateVector<Real, count>, Rule::rule.nodes.size()> rates;
  rates[0] = first;
  evaluate_stages<Rule>(start, time_step, rates, rates_at);
  return combine<RowOfStep<Rule>>(start, time_step, rates);
}
//! [after_step]

/// A free top by such a rule, flattened so that the numbers stay in registers, its quaternion
/// normalised afterwards.
/// Neither the energy nor L is kept, but both to the order of the rule, as long as |ω| h is small.
template <class Rule, class Real>
[[gnu::flatten]] void turn_by_runge_kutta(Top<Real>& top, Same<Real> time_step) {
  const Vec3<Real> inverse = top.inverse_moments;
  const auto rates_at = [inverse](const StateVector<Real, 7>& state, Real, auto) {
    return rates_of(state, inverse);
  };
  const StateVector<Real, 7> start = state_of(top);
  set_state(top, after_step<Rule>(start, rates_of(start, inverse), time_step, rates_at));
  top.orientation = renormalized(top.orientation);
}

/// One step of a motion that a few numbers describe but for an integral ψ, which no stage needs:
/// FreeTurn or AxisTurn. It advances the `state` of `time` (s), and ψ = `twist` (rad).
//! [step_reduced]
template <class Rule, class Motion, class Real, std::size_t count>
[[gnu::always_inline]] inline void step_reduced(const Motion& motion,
                                                StateVector<Real, count>& state, Real& twist,
                                                Same<Real> time, Same<Real> time_step) {
  std::array<StateVector<Real, count>, Rule::rule.nodes.size()> rates;
  rates[0] = motion.rates(state, time);
  Real twist_rate = static_cast<Real>(Rule::rule.weights[0]) * motion.twist_rate(state);
  const auto rates_at = [&]<std::size_t i>(const auto& there, Real ahead, StageNumber<i>) {
    constexpr auto weight = static_cast<Real>(Rule::rule.weights[i]);
    if constexpr (weight != 0) twist_rate += weight * motion.twist_rate(there);
    return motion.rates(there, time + ahead);
  };
  evaluate_stages<Rule>(state, time_step, rates, rates_at);
  state = combine<RowOfStep<Rule>>(state, time_step, rates);
  twist += time_step * twist_rate;
}
//! [step_reduced]

/// What a particle or a top changes by at `time` (s), with `state` for its numbers; `there` is a
/// body that the force or the torque may be left in. An `evaluate_forces` that drifts by a law of
/// its own says by in_full(body, time) what acts together with that, and one that knows its torque
/// (N m) in body axes by torque_body(orientation, time).
template <class Real, class Forces>
[[gnu::always_inline]] inline StateVector<Real, 6> rates_under(const Forces& evaluate_forces,
                                                               const StateVector<Real, 6>& state,
                                                               Same<Real> time,
                                                               Particle<Real>& there) {
  set_state(there, state);
  if constexpr (requires { evaluate_forces.in_full(there, time); })
    evaluate_forces.in_full(there, time);
  else
    evaluate_forces(there, time);
  return rates_of(state, there);
}

template <class Real, class Forces>
[[gnu::always_inline]] inline StateVector<Real, 7> rates_under(const Forces& evaluate_forces,
                                                               const StateVector<Real, 7>& state,
                                                               Same<Real> time, Top<Real>& there) {
  if constexpr (requires { evaluate_forces.torque_body(there.orientation, time); }) {
    const Quaternion<Real> q = {state[0], {state[1], state[2], state[3]}};
    return with_torque_body(rates_of(state, there.inverse_moments), there,
                            evaluate_forces.torque_body(q, time));
  } else {
    set_state(there, state);
    evaluate_forces(there, time);
    return rates_of(state, there);
  }
}

/// A particle or a top under force or torque. `evaluate_forces(body, time)` must leave in the body
/// the sum of what acts on it at that time (s). It has done so when the step begins, and when it
/// ends.
template <class Rule, class Body, class Forces, class Real>
[[gnu::flatten]] void step_by_runge_kutta(Body& body, const Forces& evaluate_forces, Real time,
                                          Real time_step) {
  Body there = body;
  const auto rates_at = [&](const auto& state, Real ahead, auto) {
    return rates_under(evaluate_forces, state, time + ahead, there);
  };
  const auto start = state_of(body);
  const auto first = [&] {
    if constexpr (requires { evaluate_forces.in_full(body, time); })
      return rates_under(evaluate_forces, start, time, there);
    else
      return rates_of(start, body);  // evaluated when the step before ended
  }();
  set_state(body, after_step<Rule>(start, first, time_step, rates_at));
  if constexpr (requires { body.orientation; }) body.orientation = renormalized(body.orientation);
  evaluate_forces(body, time + time_step);
}

}  // namespace tumble
