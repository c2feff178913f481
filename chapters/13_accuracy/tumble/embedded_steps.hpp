/// @file
/// A particle or a top that chooses its own steps, by an embedded pair of Runge–Kutta rules.
#pragma once

#include <tumble/embedded_pairs.hpp>
#include <tumble/runge_kutta.hpp>
#include <tumble/stops.hpp>

namespace tumble {

/// One of a pair's rows of weights: of its errors, of the stages beyond the step, or of the parts
/// of the state within it.
template <const auto& rows, std::size_t i>
struct RowOf {
  static constexpr auto& row = rows[i];
};

namespace detail {
template <class Real>
ParticleTolerance<Real> tolerance_for(const Particle<Real>&);
template <class Real>
Real tolerance_for(const Top<Real>&);
}  // namespace detail

/// What a body may lose in a second: ParticleTolerance; of a top rad, and as large a part of |L|.
template <class Body>
using ToleranceOf = decltype(detail::tolerance_for(std::declval<const Body&>()));

/// The square of the error at the end of a step, relative to what is allowed: the tolerances of
/// position and velocity for each second of the step, and a few roundings on top, for no step can
/// be better.
template <class Real>
[[gnu::always_inline]] inline Real square_of_error(const StateVector<Real, 6>& error,
                                                   const StateVector<Real, 6>& start,
                                                   const StateVector<Real, 6>&,
                                                   const ParticleTolerance<Same<Real>>& tolerance,
                                                   Same<Real> time_step) {
  const Real rounding = 4 * std::numeric_limits<Real>::epsilon();
  const auto part = [&](std::size_t i, Real allowed) {
    const Vec3<Real> off(error[i], error[i + 1], error[i + 2]),
        size(start[i], start[i + 1], start[i + 2]);
    return off.squaredNorm() / (allowed * allowed + rounding * rounding * size.squaredNorm());
  };
  return part(0, tolerance.position * time_step) + part(3, tolerance.velocity * time_step);
}

/// The same for a top: the orientation is off by an angle, for which `tolerance` rad are allowed a
/// second, and L by a part of its size. The four numbers of a quaternion q that is off by δ are off
/// by the angle 2 |Im(q* δ)|; along q itself they have no meaning. The size of L is that at the
/// start, since an L that a bad step has blown up would excuse its own error.
//! [error_of_top]
template <class Real>
[[gnu::always_inline]] inline Real square_of_error(const StateVector<Real, 7>& error,
                                                   const StateVector<Real, 7>& start,
                                                   const StateVector<Real, 7>& end,
                                                   Same<Real> tolerance, Same<Real> time_step) {
  const Quaternion<Real> q = {end[0], {end[1], end[2], end[3]}},
                         off = {error[0], {error[1], error[2], error[3]}};
  const auto momentum = [](const StateVector<Real, 7>& state) {
    return Vec3<Real>(state[4], state[5], state[6]).squaredNorm();
  };
  const Real angle = 4 * (conjugate(q) * off).imaginary.squaredNorm();
  const Real size = momentum(start) == 0 ? momentum(end) : momentum(start);
  const Real part = momentum(error) == 0 ? Real(0) : momentum(error) / size;
  const Real allowed = tolerance * time_step + 4 * std::numeric_limits<Real>::epsilon();
  return (angle + part) / (allowed * allowed);
}
//! [error_of_top]

/// Combines several estimates, all as squares: a single one is returned as it is; two, of which the
/// second falls more slowly, give e₁²/√(e₁² + e₂²/100).
template <class Real, std::size_t count>
[[gnu::always_inline]] inline Real combined_square(const std::array<Real, count>& squares) {
  if constexpr (count == 1) return squares[0];
  return squares[0] == 0 ? Real(0) : squares[0] * squares[0] / (squares[0] + squares[1] / 100);
}

/// Steps of a body by an embedded pair, for integrate_adaptively().
template <class Pair, class Body, class Forces, class Real>
class EmbeddedSteps {
 public:
  static constexpr int power = Pair::power - 1;  ///< of the error per second

  EmbeddedSteps(const Body& body, const Forces& evaluate_forces, Real time,
                ToleranceOf<Body> tolerance)
      : evaluate_forces_(evaluate_forces),
        there_(body),
        time_(time),
        tolerance_(tolerance),
        start_(state_of(body)) {
    rates_[0] = rates_under(evaluate_forces_, start_, time_, there_);
  }

  /// Makes a step of h seconds. @return the square of its error, with 1 allowed
  //! [attempt]
  [[gnu::flatten]] Real attempt(Real h) {
    step_ = h;
    evaluate_stages<typename Pair::Rule>(
        start_, h, rates_, [&](const auto& state, Real ahead, auto) {
          return rates_under(evaluate_forces_, state, time_ + ahead, there_);
        });
    end_ = combine<RowOfStep<typename Pair::Rule>>(start_, h, rates_);
    if constexpr (count == 7) {
      const Real factor = 1 / std::sqrt(end_[0] * end_[0] + end_[1] * end_[1] + end_[2] * end_[2] +
                                        end_[3] * end_[3]);
      end_ = each<Real, count>([&](auto n) { return n < 4 ? factor * end_[n] : end_[n]; });
    }
    if constexpr (error_sees_end) evaluate_end();
    return combined_square(each<Real, Pair::errors.size()>([&](auto i) { return error<i>(); }));
  }
  //! [attempt]

  /// What was attempted last counts as a step.
  void accept() {
    if constexpr (!error_sees_end) evaluate_end();
    time_ += step_;
    start_ = end_;
    rates_[0] = rates_[stage_count];
  }

  /// See first_step_of().
  [[gnu::flatten]] Real first_step(Real seconds) {
    const Real ahead = seconds / 10000;
    State there = start_;
    for (std::size_t n = 0; n < there.size(); ++n) there[n] += ahead * rates_[0][n];
    State change = rates_under(evaluate_forces_, there, time_ + ahead, there_);
    for (std::size_t n = 0; n < change.size(); ++n) change[n] -= rates_[0][n];
    return first_step_of<Real>(
        std::sqrt(square_of_error(rates_[0], start_, start_, tolerance_, Real(1))),
        std::sqrt(square_of_error(change, start_, start_, tolerance_, Real(1))) / ahead, power,
        seconds);
  }

  /// The body where the last step that was accepted ends.
  Body body() const { return in_state(start_); }

  /// The body within the step just attempted, at a `part` of it from 0 to 1: a cubic through both
  /// ends with their rates, and what the stages know beyond it. Stages that the step itself did not
  /// need are evaluated now.
  //! [within]
  Body within(Real part) {
    if constexpr (!error_sees_end) evaluate_end();
    evaluate_more_stages();
    const Real rest = 1 - part;
    const auto beyond = each<State, Pair::dense.size()>(
        [&](auto i) { return weighed<RowOf<Pair::dense, i>>(rates_); });
    State state;
    for (std::size_t n = 0; n < state.size(); ++n) {
      Real more = 0;  // d₀ + p (d₁ + (1 − p) (d₂ + p d₃)), from the last on
      for (std::size_t i = beyond.size(); i-- > 0;)
        more = beyond[i][n] + (i % 2 == 0 ? part : rest) * more;
      const Real change = end_[n] - start_[n], first = step_ * rates_[0][n] - change,
                 last = change - step_ * rates_[stage_count][n] - first;
      state[n] =
          start_[n] + part * (change + rest * (first + part * (last + rest * (step_ * more))));
    }
    return in_state(state);
  }
  //! [within]

 private:
  using Rule = typename Pair::Rule;
  using State = decltype(state_of(std::declval<const Body&>()));
  static constexpr std::size_t stage_count = Rule::rule.nodes.size(),
                               count = std::tuple_size_v<State>;
  static constexpr bool error_sees_end = Pair::errors[0][stage_count] != 0;

  Body in_state(const State& state) const {
    Body body = there_;
    set_state(body, state);
    if constexpr (requires { body.orientation; }) body.orientation = normalized(body.orientation);
    return body;
  }

  void evaluate_end() {
    rates_[stage_count] = rates_under(evaluate_forces_, end_, time_ + step_, there_);
  }

  void evaluate_more_stages() {
    for_each_index<Pair::more_nodes.size()>([&](auto i) {
      const auto state = combine<RowOf<Pair::more_coefficients, i>>(start_, step_, rates_);
      const Real ahead = static_cast<Real>(Pair::more_nodes[i]) * step_;
      rates_[stage_count + 1 + i] = rates_under(evaluate_forces_, state, time_ + ahead, there_);
    });
  }

  template <std::size_t i>
  [[gnu::always_inline]] Real error() const {
    const State off = each<Real, count>(
        [&](auto n) { return step_ * weighed_number<RowOf<Pair::errors, i>, n>(rates_); });
    return square_of_error(off, start_, end_, tolerance_, step_);
  }

  const Forces& evaluate_forces_;
  Body there_;  // to ask for its force or torque
  Real time_, step_ = 0;
  ToleranceOf<Body> tolerance_;
  State start_, end_ = {};
  std::array<State, stage_count + 1 + Pair::more_nodes.size()> rates_ = {};
};

/// Takes a particle or a top from `time` (s) through `seconds` by an embedded pair, such as
/// DormandPrince54, or DormandPrince853 for small tolerances; see embedded_pairs.hpp.
/// `evaluate_forces` is a function (Body&, Real time) that sets the sum of what acts then:
/// particle.force, or top.torque. `tolerance` is what may be lost in a second: of a particle {m,
/// m/s}; of a top rad, and as large a part of |L|. That is what is added to the error, which the
/// motion then carries on and may spread: it can end larger than tolerance times seconds. The
/// squares of |L| and of the part of it that may be lost must be normal numbers: of a smaller error
/// the choice of the step sees nothing, and a larger |L| has no such part. No step passes over one
/// of the `stops`. What acts at the end is left in the body; if anything is thrown, the body is as
/// it was.
/// @return how many steps it took, and how many were rejected
/// @throws std::invalid_argument unless the seconds are 0 or more and the tolerance more than 0,
/// both finite, and as require_stops(). @throws StepError if no step meets the tolerance.
template <class Pair, class Body, class Forces, class Real>
StepCounts integrate(Body& body, const Forces& evaluate_forces, Real time, Same<Real> seconds,
                     ToleranceOf<Body> tolerance, const Stops<Same<Real>>& stops = {}) {
  require_tolerance<Real>(seconds, tolerance);
  return in_legs(body, evaluate_forces, time, seconds, stops,
                 [&](auto& there, const auto& within, Real begin, Real length) {
                   EmbeddedSteps<Pair, Body, std::decay_t<decltype(within)>, Real> steps(
                       there, within, begin, tolerance);
                   return integrate_leg(there, steps, length, stops.longest);
                 });
}

}  // namespace tumble
