/// @file
/// Splittings of a top whose steps follow its pace, and that are symmetric in time nevertheless.
#pragma once

#include <tumble/kicked_steps.hpp>
#include <tumble/step_control.hpp>

namespace tumble {

/// Steps of h = angle/ρ, where ρ (1/s) follows the pace P of the top, P² = |ω|² + least². So each
/// step turns the top by about the same angle.
///
/// If each step were chosen from the pace at its start, the way back would take other steps than
/// the way there. Therefore ρ is carried along like a part of the state. In a time s in which steps
/// have the length `angle`, dt = ds/ρ and
///
///     dρ/ds = (dP/dt)/P = ω · ω'/P²,
///
/// so that ρ = P stays true but for the errors of the steps. One step is half of this change at its
/// start, the motion, and half of the change at its end: read backwards, the same (Hairer and
/// Söderlind 2005). Nothing has to be solved, and no evaluation is added.
//! [paced_steps]
template <class Row, class Gather, class Real>
class PacedSteps {
 public:
  /// `angle` (rad) is that of a step; `least` (rad/s) the pace of a top at rest.
  PacedSteps(const Top<Real>& top, const Gather& gather, Real time, Real angle, Real least = 0)
      : gather_(gather), top_(top), time_(time), angle_(angle), least_(least) {
    gather_(top_, time_);
    pace_ = std::sqrt(square_of_pace());
  }

  /// How long the next step is, s.
  Real next() const { return angle_ / (pace_ + angle_ / 2 * growth()); }

  void step() {
    const Real middle = pace_ + angle_ / 2 * growth();
    move(angle_ / middle);
    pace_ = middle + angle_ / 2 * growth();
  }
  //! [paced_steps]

  /// One step of h seconds, whatever the pace: to land.
  void move(Real h) {
    step_by_row<Row>(top_, gather_, time_, h);
    time_ += h;
  }

  /// From here on backwards, where torque does not depend on time.
  void turn_around() { top_.angular_momentum_body *= -1; }

  const Top<Real>& top() const { return top_; }
  Real pace() const { return pace_; }  ///< ρ, 1/s
  Real time() const { return time_; }  ///< s

 private:
  Real square_of_pace() const {
    return angular_velocity_body(top_).squaredNorm() + least_ * least_;
  }

  /// dρ/ds, 1/(rad s). It needs the torque of now, which a step leaves behind.
  Real growth() const {
    const Vec3<Real>&L = top_.angular_momentum_body, w = angular_velocity_body(top_);
    const Vec3<Real> torque = L.cross(w) + rotate_back(top_.orientation, top_.torque);
    return dot(w, top_.inverse_moments.cwiseProduct(torque).eval()) / square_of_pace();
  }

  const Gather& gather_;
  Top<Real> top_;  // with the torque of now
  Real time_, angle_, least_, pace_ = 0;
};

/// Takes a top from `time` (s) through `seconds` in steps that turn it by about `angle` (rad) each,
/// where the pace is its angular velocity and `least` (rad/s) together. The last step is cut so
/// that it ends where the journey does. A top at rest without a least pace stays at rest in one
/// step.
/// @throws std::invalid_argument unless the time and the least pace are 0 or more and the angle is
/// more than 0, all finite. @throws StepError if steps fall below what the clock can show.
//! [carry_paced]
template <class Row, class Gather, class Real>
Journey carry_paced(Top<Real>& top, const Gather& gather, Real time, Same<Real> seconds,
                    Same<Real> angle, Same<Real> least = 0) {
  require_not_negative("time", seconds, "s");
  require_not_negative("least pace", least, "rad/s");
  require_finite("angle", angle, "rad a step");
  if (!(angle > 0)) reject("angle", angle, "rad a step", "it must be greater than 0");
  PacedSteps<Row, Gather, Real> steps(top, gather, time, angle, least);
  Journey journey;
  Real gone = 0;
  while (gone < seconds) {
    const Real h = steps.next(), left = seconds - gone;
    ++journey.steps;
    if (!(h < left)) {
      steps.move(left);
      break;
    }
    steps.step();
    if (!(gone + h > gone)) fail_at(h, gone);
    gone += h;
  }
  top = steps.top();
  return journey;
}
//! [carry_paced]

}  // namespace tumble
