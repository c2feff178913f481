/// @file
/// Splittings of a top whose steps follow its pace, and that are symmetric in time nevertheless.
#pragma once

#include <tumble/kicked_steps.hpp>
#include <tumble/step_control.hpp>

namespace tumble {

/// Steps of h = angle/ρ, where ρ (1/s) follows the pace P of the top, P² = |ω|² + least². To be
/// symmetric in time, ρ is carried along like a part of the state, by dρ/ds = ω · ω'/P² in a time s
/// with dt = ds/ρ: half of its change before the motion, and half after (Hairer and Söderlind
/// 2005).
///
/// A step is refused where P² is less than angle · |ω'|, or ρ less than P/2: own_steps.md says why.
/// So each is positive, and no longer than 2 angle/P.
//! [paced_steps]
template <class Row, class Forces, class Real>
class PacedSteps {
 public:
  /// `angle` (rad) is that of a step; `least` (rad/s) the pace of a top at rest. It may be 0 where
  /// the top never comes to rest, as without torque.
  PacedSteps(const Top<Real>& top, const Forces& evaluate_forces, Real time, Real angle, Real least)
      : evaluate_forces_(evaluate_forces), top_(top), time_(time), angle_(angle), least_(least) {
    evaluate_forces_(top_, time_);
    pace_ = std::sqrt(square_of_pace());
  }

  /// How long the next step is, s. @throws StepError as step().
  Real next() const { return angle_ / middle(); }

  /// @throws StepError, and changes nothing, if the step would be refused.
  void step() {
    const Real pace = middle();
    move(angle_ / pace);
    pace_ = pace + angle_ / 2 * growth();
  }
  //! [paced_steps]

  /// One step of h seconds, whatever the pace: to land.
  void move(Real h) {
    step_by_row<Row>(top_, evaluate_forces_, time_, h);
    time_ += h;
  }

  /// From here on backwards, where torque does not depend on time.
  void turn_around() { top_.angular_momentum_body *= -1; }

  const Top<Real>& top() const { return top_; }  ///< as it is now
  Real pace() const { return pace_; }            ///< ρ, 1/s
  Real time() const { return time_; }            ///< s

 private:
  /// ρ during the next step, 1/s.
  Real middle() const {
    const Real pace = pace_ + angle_ / 2 * growth(), square = square_of_pace(),
               change = acceleration().norm();
    if (!(pace > 0 && 4 * pace * pace >= square && angle_ * change <= square))
      throw StepError(
          "the pace ρ is " + text_of(pace) + " 1/s at " + text_of(time_) +
          " s, where the angular velocity of " + text_of(angular_velocity_body(top_).norm()) +
          " rad/s changes by " + text_of(change) + " rad/s²: take a least pace greater than " +
          text_of(least_) + " rad/s, or a smaller angle than " + text_of(angle_) + " rad a step");
    return pace;
  }

  Real square_of_pace() const {
    return angular_velocity_body(top_).squaredNorm() + least_ * least_;
  }

  /// ω', rad/s². It needs the torque of now, which a step leaves behind.
  Vec3<Real> acceleration() const {
    const Vec3<Real>&L = top_.angular_momentum_body, w = angular_velocity_body(top_);
    const Vec3<Real> torque = L.cross(w) + rotate_back(top_.orientation, top_.torque);
    return top_.inverse_moments.cwiseProduct(torque);
  }

  /// dρ/ds, 1/(rad s).
  Real growth() const {
    const Real square = square_of_pace();
    return square == 0 ? Real(0) : dot(angular_velocity_body(top_), acceleration()) / square;
  }

  const Forces& evaluate_forces_;
  Top<Real> top_;  // with the torque of now
  Real time_, angle_, least_, pace_ = 0;
};

/// Takes a top from `time` (s) through `seconds` in steps that turn it by about `angle` (rad) each,
/// where the pace is its angular velocity and `least` (rad/s) together, as of PacedSteps. The last
/// step is cut so that it ends where the integration does.
/// @throws std::invalid_argument unless the time and the least pace are 0 or more and the angle is
/// more than 0, all finite. @throws StepError if PacedSteps refuses a step, which a larger least
/// pace prevents, or if steps fall below what the clock can show.
template <class Row, class Forces, class Real>
StepCounts integrate_paced(Top<Real>& top, const Forces& evaluate_forces, Real time,
                           Same<Real> seconds, Same<Real> angle, Same<Real> least) {
  require_not_negative("time", seconds, "s");
  require_not_negative("least pace", least, "rad/s");
  require_finite("angle", angle, "rad a step");
  if (!(angle > 0)) reject("angle", angle, "rad a step", "it must be greater than 0");
  PacedSteps<Row, Forces, Real> steps(top, evaluate_forces, time, angle, least);
  StepCounts counts;
  Real gone = 0;
  while (gone < seconds) {
    const Real h = steps.next(), left = seconds - gone;
    ++counts.steps;
    if (!(h < left)) {
      steps.move(left);
      break;
    }
    steps.step();
    if (!(gone + h > gone)) fail_at(h, gone, "the top turns too fast for the clock");
    gone += h;
  }
  top = steps.top();
  return counts;
}

}  // namespace tumble
