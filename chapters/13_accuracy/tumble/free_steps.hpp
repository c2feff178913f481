/// @file
/// A free top that chooses its own steps.
#pragma once

#include <tumble/embedded_steps.hpp>
#include <tumble/free_turn.hpp>

namespace tumble {

/// Steps of a free top by an embedded pair, for travel(): l and ψ of FreeTurn. The error of a step
/// is that of ψ and that of l, a part of |L|: two angles about axes that are perpendicular, so that
/// their squares add up. `tolerance` rad are allowed a second.
template <class Pair, class Real>
class FreeSteps {
 public:
  static constexpr int power = Pair::power - 1;  ///< of the error per second

  FreeSteps(const Top<Real>& top, Real tolerance)
      : free_(top), tolerance_(tolerance), start_(free_.direction()) {
    look_at_start();
  }

  //! [attempt_freely]
  [[gnu::flatten]] Real attempt(Real h) {
    step_ = h;
    look<Rule>(start_, h, rates_, [&]<std::size_t i>(const Numbers<Real, 3>& l, Real, Look<i>) {
      if constexpr (is_asked_for(i)) twists_[i][0] = free_.twist_rate(l);
      return free_.rates(l);
    });
    end_ = led<RowOfStep<Rule>>(start_, h, rates_);
    if constexpr (error_sees_end) look_at_end();
    return [&]<std::size_t... i>(std::index_sequence<i...>) {
      return together(std::array{error<i>()...});
    }
    (std::make_index_sequence<Pair::errors.size()>());
  }
  //! [attempt_freely]

  void accept() {
    twist_ += step_ * weighed<RowOfStep<Rule>>(twists_)[0];
    start_ = end_;
    if (free_.is_far(start_)) {
      start_ = free_.fold(start_, twist_);
      twist_ = 0;
    }
    look_at_start();
  }

  Real first_step(Real seconds) {
    const Real ahead = seconds / 10000;
    Numbers<Real, 3> there = start_;
    Real rate = 0, changes = 0;
    for (std::size_t n = 0; n < 3; ++n) there[n] += ahead * rates_[0][n];
    const Numbers<Real, 3> then = free_.rates(there);
    for (std::size_t n = 0; n < 3; ++n) {
      const Real change = (then[n] - rates_[0][n]) / ahead;
      rate += rates_[0][n] * rates_[0][n];
      changes += change * change;
    }
    return first_step_of<Real>(std::sqrt(rate) / tolerance_, std::sqrt(changes) / tolerance_, power,
                               seconds);
  }

  /// The top where the last step that was accepted ends.
  Top<Real> top() const { return free_.top_at(start_, twist_); }

 private:
  using Rule = typename Pair::Rule;
  static constexpr std::size_t looks = Rule::rule.nodes.size();
  static constexpr bool error_sees_end = Pair::errors[0][looks] != 0;

  /// Whether anything weighs ψ' of this look.
  static constexpr bool is_asked_for(std::size_t i) {
    bool is = i < looks && Rule::rule.weights[i] != 0;
    for (const auto& row : Pair::errors) is = is || row[i] != 0;
    return is;
  }

  void look_at_start() {
    rates_[0] = free_.rates(start_);
    twists_[0][0] = free_.twist_rate(start_);
  }
  void look_at_end() {
    rates_[looks] = free_.rates(end_);
    twists_[looks][0] = free_.twist_rate(end_);
  }

  template <std::size_t i>
  [[gnu::always_inline]] Real error() const {
    const Numbers<Real, 3> off = weighed<RowOfError<Pair, i>>(rates_);
    const Real twist = weighed<RowOfError<Pair, i>>(twists_)[0];
    const Real square = twist * twist + (off[0] * off[0] + off[1] * off[1] + off[2] * off[2]);
    const Real allowed = tolerance_ * step_ + 4 * std::numeric_limits<Real>::epsilon();
    return step_ * step_ * square / (allowed * allowed);
  }

  FreeTurn<Real> free_;
  Real tolerance_, step_ = 0, twist_ = 0;  // twist: ψ at the start of the step, rad
  Numbers<Real, 3> start_, end_ = {};
  std::array<Numbers<Real, 3>, looks + 1> rates_ = {};
  std::array<Numbers<Real, 1>, looks + 1> twists_ = {};
};

/// Takes a free top through `seconds`. `tolerance`: rad that may be lost in a second. A top that
/// turns steadily, locked axes and all, is turned at once, which is exact.
/// @throws std::invalid_argument unless the time is 0 or more and the tolerance more than 0, both
/// finite. @throws StepError if no step meets the tolerance.
//! [carry_freely]
template <class Pair, class Real>
Journey carry_freely(Top<Real>& top, Same<Real> seconds, Same<Real> tolerance) {
  require_journey<Real>(seconds, tolerance);
  if (!is_gyroscopic(top) || gyroscopic_torque(top).squaredNorm() == 0) {
    turn_steadily(top, seconds);
    return {.steps = 1};
  }
  FreeSteps<Pair, Real> steps(top, tolerance);
  const Journey journey = travel(steps, seconds, steps.first_step(seconds), [](Real, Real) {});
  top = steps.top();
  return journey;
}
//! [carry_freely]

}  // namespace tumble
