/// @file
/// Why a step could not be taken, found by taking it once more on a copy, effect by effect.
#pragma once

#include <stdexcept>
#include <tumble/guard.hpp>
#include <tumble/rotors.hpp>
#include <tumble/sine_cosine.hpp>
#include <tumble/tumbling.hpp>

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
  const Vec3<Real> spin = angular_velocity_body(top);
  const Real angle = time_step * std::hypot(spin[0], spin[1], spin[2]);  // no square overflows
  return text_of(angle) + " rad in this step, and no finite orientation was found; at most " +
         text_of(2 * SineCosineConstants<Real>::limit) + " rad can be turned";
}

namespace detail {

/// Which quantity of a body is not finite, as the middle of a sentence; empty if all are.
template <class Real>
std::string not_finite_in(const Particle<Real>& centre, const Top<Real>& top) {
  const auto said = [](const char* what, const Vec3<Real>& value, const char* unit) {
    return std::string(what).append(text_of(value)).append(unit);
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
  Replay(Bodies<Real> bodies, const Work<Real>& work, BodyIndex diverged)
      : bodies_(std::move(bodies)), work_(work), diverged_(diverged) {}

  /// What went wrong, as a sentence; `culprit` becomes the effect to blame, if it is one.
  std::string find(const StepTime<Real>& step, const AnyEffect<Real>*& culprit) {
    Bodies<Real> before_drift = bodies_;
    for (const Substep<Real>& substep : work_.substeps) {
      const StepTime<Real> part = step_time_of(substep, step);
      if (substep.kind == SubstepKind::kick) {
        if (const std::string why = fault_of_kick(part, culprit); !why.empty()) return why;
      } else if (substep.kind == SubstepKind::whole) {
        for (const Phase phase : {Phase::impulse, Phase::damping})
          if (ask_each(phase, step, culprit, false)) return sentence_;
      } else {
        before_drift = bodies_;
        const Real h = part.time_step;
        for_each_of(work_.movers, bodies_.centres, [&](auto& one) { drift(one, h); });
        if (has_diverged()) return reason(before_drift, h);
        const auto rotor = [&](std::size_t i, RotorAct act) {
          run_rotor(work_, i, act, bodies_.tops, part);
          if (!sentence_.empty() || !has_diverged()) return;
          culprit = work_.effects[i].effect.get();
          sentence_ = fault_of_rotor(*culprit, act, part);
        };
        with_rotors(rotors_of(work_), rotor, [&] {
          before_drift.tops = bodies_.tops;
          for_each_of(work_.steady, bodies_.tops, [&](auto& one) { turn_steadily(one, h); });
          work_.rule->turn(bodies_.tops, work_.tumbling, h);
          if (sentence_.empty() && has_diverged()) sentence_ = reason(before_drift, h);
        });
        if (!sentence_.empty()) return sentence_;
      }
    }
    if (ask_each(Phase::drift, step, culprit, false)) return sentence_;
    return reason(before_drift, step.time_step);
  }

 private:
  bool has_diverged() const {
    const BodyState<Real> body = state_of(bodies_, diverged_);
    return !detail::not_finite_in(body.centre, body.top).empty();
  }

  std::string fault_of_rotor(const AnyEffect<Real>& rotor, RotorAct act,
                             const StepTime<Real>& drift) const {
    Top<Real> turned = state_of(bodies_, diverged_).top;
    const Vec3<Real> H = turned.angular_momentum_body =
        rotor.rotor_momentum_body(time_of(act, drift));
    return is_finite(H) ? rotor.name() + " would turn it by " +
                              turn_too_far<Real>(turned, drift.time_step / 2)
                        : rotor.name() + " holds a momentum of " + text_of(H) +
                              " kg m^2/s; every component must be finite";
  }

  /// What went wrong in a kick, or nothing.
  std::string fault_of_kick(const StepTime<Real>& moment, const AnyEffect<Real>*& culprit) {
    const Real h = moment.time_step;
    const Bodies<Real> before = bodies_;
    if (ask_each(Phase::force, moment, culprit, true)) return sentence_;
    bodies_ = before;  // what writes a velocity itself has acted by now
    run(work_, Phase::force, bodies_, moment);
    add(work_.inputs, bodies_);
    if (has_diverged())  // a sum that overflows is nobody's alone
      run(work_, Phase::kick, bodies_, moment);
    else if (ask_each(Phase::kick, moment, culprit, false))
      return sentence_;
    for_each_of(work_.pushed, bodies_.centres, [&](auto& one) { kick(one, h), clear_force(one); });
    for_each_of(work_.torqued, bodies_.tops, [&](auto& one) { kick(one, h), clear_torque(one); });
    return has_diverged() ? reason(bodies_, h) : std::string();
  }

  /// Runs the effects of a phase until one gives the body that diverged a number that is not
  /// finite. `alone`: each by itself, for those that add to a sum.
  bool ask_each(Phase phase, const StepTime<Real>& moment, const AnyEffect<Real>*& culprit,
                bool alone) {
    for (const std::size_t i : work_.in_phase[static_cast<std::size_t>(phase)]) {
      const Entry<Real>& entry = work_.effects[i];
      entry.effect->run(bodies_, entry.visits, moment);
      const BodyState<Real> body = state_of(bodies_, diverged_);
      const std::string what = detail::not_finite_in(body.centre, body.top);
      if (alone) {
        for (Particle<Real>& centre : bodies_.centres) clear_force(centre);
        for (Top<Real>& top : bodies_.tops) clear_torque(top);
      }
      if (what.empty()) continue;
      culprit = entry.effect.get();
      sentence_ = culprit->name() + " gives " + what + "; every component must be finite";
      return true;
    }
    return false;
  }

  /// Why a body diverged that no effect alone has spoilt, judged by its state before the drift.
  std::string reason(const Bodies<Real>& kicked, Real h) const {
    const BodyState<Real> body = state_of(kicked, diverged_);
    if (!is_finite(Vec3<Real>(body.centre.position + h * body.centre.velocity)))
      return "with a velocity of " + text_of(body.centre.velocity) +
             " m/s the step would lead to no finite position";
    return "it would turn by " + turn_too_far(body.top, h);
  }

  Bodies<Real> bodies_;
  const Work<Real>& work_;
  BodyIndex diverged_;
  std::string sentence_;
};

/// The error for a body that diverged. `bodies` are as they were before the step.
template <class Real>
SimulationError failure(const std::string& name, BodyIndex diverged, const Bodies<Real>& bodies,
                        const Work<Real>& work, std::int64_t tick, Real time_step) {
  const StepTime<Real> moment = step_time_of(tick, time_step);
  const AnyEffect<Real>* culprit = nullptr;
  const std::string why = Replay<Real>(bodies, work, diverged).find(moment, culprit);
  return {"'" + name + "' at " + text_of(moment.time) + " s (step " + std::to_string(tick) +
              "): " + why + "; the world is as it was before this step",
          name, culprit ? culprit->name() : std::string(), static_cast<double>(moment.time)};
}

}  // namespace tumble
