/// @file
/// Steps that choose themselves, for a top whose motion is reduced to a few unknowns.
#pragma once

#include <algorithm>
#include <tumble/axis_turn.hpp>
#include <tumble/embedded_steps.hpp>
#include <tumble/free_turn.hpp>

namespace tumble {

/// Steps by an embedded pair, for integrate_adaptively(), of a top that a few numbers and the
/// integral ψ describe completely: FreeTurn or AxisTurn. The error of a step is that of the
/// numbers, as the motion counts it, and that of ψ, an angle: two turns about perpendicular axes,
/// so that their squares add. `tolerance` rad are allowed a second, and as large a fraction of |L|.
template <class Pair, class Motion, class Real>
class ReducedSteps {
 public:
  static constexpr int power = Pair::power - 1;  ///< of the error per second

  ReducedSteps(const Motion& motion, Real time, Real tolerance)
      : motion_(motion), time_(time), tolerance_(tolerance), start_(motion_.state()) {
    evaluate_start();
  }

  [[gnu::flatten]] Real attempt(Real h) {
    step_ = h;
    evaluate_stages<Rule>(start_, h, rates_,
                          [&]<std::size_t i>(const State& state, Real ahead, StageNumber<i>) {
                            if constexpr (is_asked_for<i>)
                              twists_[i][0] = motion_.twist_rate(state);
                            return motion_.rates(state, time_ + ahead);
                          });
    end_ = combine<RowOfStep<Rule>>(start_, h, rates_);
    if constexpr (error_sees_end) evaluate_end();
    return combined_square(each<Real, Pair::errors.size()>([&](auto i) { return square<i>(); }));
  }

  void accept() {
    time_ += step_;
    twist_ += step_ * weighed_number<RowOfStep<Rule>, 0>(twists_);
    start_ = end_;
    if (motion_.is_far(start_)) {
      motion_.change_chart(start_, twist_);
      start_ = motion_.state();
      twist_ = 0;
    }
    evaluate_start();
  }

  /// See first_step_of().
  Real first_step(Real seconds) {
    const Real ahead = seconds / 10000;
    const State there = each<Real, count>([&](auto n) { return start_[n] + ahead * rates_[0][n]; });
    const State then = motion_.rates(there, time_ + ahead);
    const State change = each<Real, count>([&](auto n) { return then[n] - rates_[0][n]; });
    const auto size = [&](const State& off) {
      return std::sqrt(motion_.square(off, start_)) / tolerance_;
    };
    return first_step_of<Real>(size(rates_[0]), size(change) / ahead, power, seconds);
  }

  /// The top where the last step that was accepted ends.
  Top<Real> body() const { return motion_.top_at(start_, twist_); }

 private:
  using Rule = typename Pair::Rule;
  using State = decltype(std::declval<const Motion&>().state());
  static constexpr std::size_t stage_count = Rule::rule.nodes.size(),
                               count = std::tuple_size_v<State>;
  static constexpr bool error_sees_end = Pair::errors[0][stage_count] != 0;

  /// Whether ψ' has a weight at this stage.
  template <std::size_t i>
  static constexpr bool is_asked_for = [] {
    bool is = i < stage_count && Rule::rule.weights[i] != 0;
    for (const auto& row : Pair::errors) is = is || row[i] != 0;
    return is;
  }();

  void evaluate_start() {
    rates_[0] = motion_.rates(start_, time_);
    twists_[0][0] = motion_.twist_rate(start_);
  }
  void evaluate_end() {
    rates_[stage_count] = motion_.rates(end_, time_ + step_);
    twists_[stage_count][0] = motion_.twist_rate(end_);
  }

  template <std::size_t i>
  [[gnu::always_inline]] Real square() const {
    const State off = weighed<RowOf<Pair::errors, i>>(rates_);
    const Real twist = weighed_number<RowOf<Pair::errors, i>, 0>(twists_);
    const Real allowed = tolerance_ * step_ + 4 * std::numeric_limits<Real>::epsilon();
    return step_ * step_ * (twist * twist + motion_.square(off, start_)) / (allowed * allowed);
  }

  Motion motion_;
  Real time_, tolerance_, step_ = 0, twist_ = 0;  // twist: ψ at the start of the step, rad
  State start_, end_ = {};
  std::array<State, stage_count + 1> rates_ = {};
  std::array<StateVector<Real, 1>, stage_count + 1> twists_ = {};
};

/// The integration of such steps, none longer than `longest` (s).
template <class Pair, class Real, class Motion>
StepCounts integrate_reduced(Top<Real>& top, const Motion& motion, Same<Real> time,
                             Same<Real> seconds, Same<Real> tolerance,
                             Same<Real> longest = std::numeric_limits<Real>::infinity()) {
  ReducedSteps<Pair, Motion, Real> steps(motion, time, tolerance);
  return integrate_leg(top, steps, seconds, longest);
}

/// Takes a free top through `seconds`. `tolerance`: rad that may be lost in a second. A top that
/// turns steadily, locked axes and all, is turned at once, which is exact.
/// @throws std::invalid_argument unless the seconds are 0 or more and the tolerance more than 0,
/// both finite. @throws StepError if no step meets the tolerance.
template <class Pair, class Real>
StepCounts integrate_free_top(Top<Real>& top, Same<Real> seconds, Same<Real> tolerance) {
  require_tolerance<Real>(seconds, tolerance);
  if (is_gyroscopic(top) && !top.angular_momentum_body.isZero(0)) {
    const FreeTurn<Real> motion(top);
    if (motion.rates(motion.state()) != StateVector<Real, 3>{})
      return integrate_reduced<Pair, Real>(top, motion, 0, seconds, tolerance);
  }
  turn_steadily(top, seconds);
  return {.steps = 1};
}

/// Takes a symmetric top from `time` (s) through `seconds`, where the torque depends on time and on
/// where the axis points, and has no part along it: `evaluate_forces` returns it (N m, world axes)
/// by torque_on_axis(axis, time). `tolerance`: rad, and parts of |L|, that may be lost in a second.
/// No step passes over one of the `stops`.
/// @throws std::invalid_argument unless two moments are equal and none is locked, and as
/// integrate(). @throws StepError if no step meets the tolerance.
template <class Pair, class Forces, class Real>
StepCounts integrate_axis(Top<Real>& top, const Forces& evaluate_forces, Real time,
                          Same<Real> seconds, Same<Real> tolerance,
                          const Stops<Same<Real>>& stops = {}) {
  require_tolerance<Real>(seconds, tolerance);
  return in_legs(top, evaluate_forces, time, seconds, stops,
                 [&](auto& there, const auto& within, Real begin, Real length) {
                   const AxisTurn<std::decay_t<decltype(within)>, Real> motion(there, within);
                   return integrate_reduced<Pair, Real>(there, motion, begin, length, tolerance,
                                                        stops.longest);
                 });
}

/// The same in so many steps of one length.
/// @throws std::invalid_argument unless the seconds are 0 or more and finite, there is at least one
/// step, and two moments are equal and none is locked.
template <class Rule, class Forces, class Real>
[[gnu::flatten]] void integrate_axis_evenly(Top<Real>& top, const Forces& evaluate_forces,
                                            Real time, Same<Real> seconds, long steps) {
  require_not_negative("time", seconds, "s");
  if (steps < 1) reject("number of steps", steps, "", "it must be 1 or more");
  AxisTurn<Forces, Real> motion(top, evaluate_forces);
  StateVector<Real, 6> state = motion.state();
  Real twist = 0;
  const Real h = seconds / static_cast<Real>(steps);
  for (long n = 0; n < steps; ++n) {
    step_reduced<Rule>(motion, state, twist, time + static_cast<Real>(n) * h, h);
    if (motion.is_far(state)) {
      motion.change_chart(state, twist);
      state = motion.state();
      twist = 0;
    }
  }
  top = motion.top_at(state, twist);
  evaluate_forces(top, time + seconds);
}

}  // namespace tumble
