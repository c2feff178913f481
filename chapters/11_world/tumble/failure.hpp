/// @file
/// Why a step could not be taken, found by taking it once more on a copy, pass by pass.
#pragma once

#include <stdexcept>
#include <tumble/guard.hpp>
#include <tumble/sine_cosine.hpp>
#include <tumble/step_order.hpp>

namespace tumble {

/// A step could not be taken. The world is as it was before.
class SimulationError : public std::runtime_error {
 public:
  SimulationError(const std::string& sentence, std::string body_name, std::string effect_name,
                  double at_time)
      : std::runtime_error(sentence),
        body(std::move(body_name)),
        effect(std::move(effect_name)),
        time(at_time) {}
  std::string body;    ///< whose motion could not be computed
  std::string effect;  ///< which effect is to blame; empty if no single one is
  double time;         ///< s, at the start of the step
};

/// The end of a sentence about a turn that is too far: the angle |ω| h (rad), and the range of
/// sine_cosine().
template <class Real>
std::string turn_too_far(const Top<Real>& top, Same<Real> time_step) {
  const Vec3<Real> omega = angular_velocity_body(top);
  const Real angle =
      std::abs(time_step) * std::hypot(omega[0], omega[1], omega[2]);  // no square overflows
  return joined({text_of(angle), " rad in this step, and no finite orientation was found; at most ",
                 text_of(2 * SineCosineConstants<Real>::limit), " rad can be turned"});
}

namespace detail {

/// Which quantity of a body is not finite, as the middle of a sentence; empty if all are.
template <class Real>
std::string not_finite_in(const Particle<Real>& centre, const Top<Real>& top) {
  const auto said = [](const char* what, const Vec3<Real>& value, const char* unit) {
    return joined({what, text_of(value), unit});
  };
  const Quaternion<Real>& q = top.orientation;
  if (!is_finite(centre.force)) return said("a force of ", centre.force, " N");
  if (!is_finite(top.torque)) return said("a torque of ", top.torque, " N m");
  if (!is_finite(centre.velocity)) return said("a velocity of ", centre.velocity, " m/s");
  if (!is_finite(top.angular_momentum_body))
    return said("an angular momentum of ", top.angular_momentum_body, " kg m^2/s, body axes,");
  if (!is_finite(centre.position)) return said("a position of ", centre.position, " m");
  if (!is_finite(q.imaginary) || !std::isfinite(q.real)) return "an orientation that is no number";
  return {};
}

}  // namespace detail

/// The step in which a body diverged, once more.
template <class Real>
class Replay {
 public:
  /// `bodies` are as they were before the step.
  Replay(Bodies<Real> bodies, const StepPlan<Real>& plan, const StepTime<Real>& step,
         BodyIndex diverged)
      : bodies_(std::move(bodies)), plan_(plan), step_(step), diverged_(diverged) {}

  /// What went wrong, as a sentence; `culprit` becomes the effect to blame, if it is one. The first
  /// pass to blame is the one after which that body has a number that is not finite. A sum of
  /// forces that overflows is nobody's alone: the kick that follows tells of it.
  std::string find(const AnyEffect<Real>*& culprit) {
    for (const Pass<Real> pass : Passes(plan_)) {
      const Bodies<Real> before = bodies_;
      run(pass, plan_, members_of(pass, plan_), bodies_, step_);
      if (fault_in(bodies_).empty() || pass.row.kind == PassKind::input) continue;
      if (pass.row.kind == PassKind::motion && pass.place < own_motion_count) {
        const BodyState<Real> now = state_of(bodies_, diverged_);
        if (is_finite(now.centre) && is_finite(now.top)) continue;  // its kick is to come
        const bool is_drift = pass.substep.kind == SubstepKind::drift;
        return reason(is_drift ? before : bodies_, step_time_of(pass, step_).time_step);
      }
      const std::string what = fault_alone(pass, before);
      if (what.empty()) continue;
      culprit = instance_of(pass, plan_).effect.get();
      return pass.row.kind == PassKind::rotor
                 ? blame_of_rotor(pass, what)
                 : joined({culprit->name(), " gives ", what, must_be_finite});
    }
    return reason(bodies_, step_.time_step);
  }

 private:
  static constexpr const char* must_be_finite = "; every component must be finite";

  std::string fault_in(const Bodies<Real>& bodies) const {
    const BodyState<Real> body = state_of(bodies, diverged_);
    return detail::not_finite_in(body.centre, body.top);
  }

  /// What is not finite of the body once the pass alone has run, on empty sums; empty if all is.
  std::string fault_alone(const Pass<Real>& pass, Bodies<Real> before) const {
    for (Particle<Real>& centre : before.centres) clear_force(centre);
    for (Top<Real>& top : before.tops) clear_torque(top);
    run(pass, plan_, members_of(pass, plan_), before, step_);
    return fault_in(before);
  }

  std::string blame_of_rotor(const Pass<Real>& pass, const std::string& what) const {
    const AnyEffect<Real>& effect = *instance_of(pass, plan_).effect;
    const StepTime<Real> at = step_time_of(pass, step_);
    Top<Real> turned =
        state_of(bodies_, diverged_).top;  // with the spin that the rotor turns it by
    const Vec3<Real> H = turned.angular_momentum_body = effect.rotor_angular_momentum_body(at.time);
    if (!is_finite(H))
      return joined(
          {effect.name(), " holds a momentum of ", text_of(H), " kg m^2/s", must_be_finite});
    if (pass.row.act == RotorAct::turn_before || pass.row.act == RotorAct::turn_after)
      return joined({effect.name(), " would turn it by ", turn_too_far(turned, at.time_step / 2)});
    return joined({effect.name(), " gives ", what, must_be_finite});
  }

  /// Why a body diverged that no effect alone has spoilt, judged by its state before the drift.
  std::string reason(const Bodies<Real>& kicked, Real h) const {
    const BodyState<Real> body = state_of(kicked, diverged_);
    if (!is_finite(Vec3<Real>(body.centre.position + h * body.centre.velocity)))
      return joined({"with a velocity of ", text_of(body.centre.velocity),
                     " m/s the step would lead to no finite position"});
    return joined({"it would turn by ", turn_too_far(body.top, h)});
  }

  Bodies<Real> bodies_;
  const StepPlan<Real>& plan_;
  StepTime<Real> step_;
  BodyIndex diverged_;
};

/// The error for a body that diverged. `bodies` are as they were before the step.
template <class Real>
SimulationError failure(const std::string& name, BodyIndex diverged, const Bodies<Real>& bodies,
                        const StepPlan<Real>& plan, std::int64_t tick, const StepTime<Real>& at) {
  const AnyEffect<Real>* culprit = nullptr;
  const std::string why = Replay<Real>(bodies, plan, at, diverged).find(culprit);
  return {joined({"'", name, "' at ", text_of(at.time), " s (step ", std::to_string(tick),
                  "): ", why, "; the world is as it was before this step"}),
          name, culprit ? culprit->name() : std::string(), static_cast<double>(at.time)};
}

}  // namespace tumble
