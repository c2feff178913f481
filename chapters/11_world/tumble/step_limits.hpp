/// @file
/// Up to which time step springs, dampers, drag and controllers can't feed on themselves.
#pragma once

#include <cmath>
#include <numbers>
#include <string>
#include <tumble/responses.hpp>
#include <vector>

namespace tumble {

/// The longest step for which no small motion about an equilibrium can grow, as the bodies are now;
/// infinite if nothing limits it. Rotors count with what they hold at `time` (s).
///
/// In units of the inverse masses and moments all that holds the bodies together pulls back by at
/// most h² k + 2 h c, which must stay below 4. A body whose nutation turns by θ in a step counts
/// with its inverse moments times yielding(θ), and θ with less than half a turn. The page on the
/// limit has the proof, in its last section.
///
/// It is proved for Euler's scheme and Verlet's, and for tops that spin steadily about an axis of
/// symmetry between springs on that axis, without dampers or with dampers that act alike on all
/// motions. For other bodies and for Scheme::suzuki it is tried on random scenes. Springs or
/// inertia that turn with a body, and dampers in single directions, can let a motion grow in any
/// step.
//! [bound]
template <class Real>
StepLimit<Real> step_limit(const StepPlan<Real>& plan, const NamedBodies<Real>& bodies,
                           Same<Real> time) {
  const Responses<Real> responses(plan, bodies, time);
  const Real half_turn = std::numbers::pi_v<Real>;
  const StepLimit<Real> limit = responses.limit(1, half_turn, yielding<Real>);
  if (responses.is_damped() || plan.scheme != Scheme::suzuki) return limit;
  const StepLimit<Real> suzuki =
      responses.limit(static_cast<Real>(largest_stable_angle(plan.scheme) / 2),
                      half_turn / std::sqrt(Real(1.5)), [half_turn](Real angle) {
                        return 1 / (1 - Real(1.5) * (angle / half_turn) * (angle / half_turn));
                      });
  return suzuki.time_step > limit.time_step ? suzuki : limit;
}
//! [bound]

/// What may go wrong in the step at `at`, such as one that is too long for a spring: a sentence, or
/// none.
template <class Real>
std::vector<std::string> warnings(const StepPlan<Real>& plan, const NamedBodies<Real>& bodies,
                                  const StepTime<Real>& at) {
  const StepLimit<Real> limit = step_limit(plan, bodies, at.time);
  if (at.time_step <= limit.time_step) return {};
  const auto named = [&](BodyIndex body) { return "'" + bodies.registry.name_of(body) + "'"; };
  std::string warning = "'" + plan.effects[limit.effect].effect->name() + "' on " +
                        named(limit.body) + " may gain energy without bound: the time step is " +
                        text_of(at.time_step) + " s, and only up to " + text_of(limit.time_step) +
                        " s can this be excluded";
  if (at.time_step <= limit.at_rest) {
    const BodyIndex body = limit.spinning;
    const Vec3<Real> rotors =
        nutating_momentum(plan, bodies.top_of(body), bodies.body(body).top, at.time);
    warning +=
        ", since " +
        (rotors == Vec3<Real>::Zero() ? named(body) + " spins"
                                      : "a wheel spins in " + named(body)) +
        ", and its nutation turns by " +
        text_of(std::round(at.time_step * limit.nutation_rate * 180 / std::numbers::pi_v<Real>)) +
        " degrees in a step";
  }
  return {warning};
}

/// Of which effects step_limit() knows nothing, though they may feed on themselves: a sentence
/// each.
template <class Real>
std::vector<std::string> unknown_limits(const StepPlan<Real>& plan) {
  std::vector<std::string> sentences;
  for (const EffectInstance<Real>& instance : plan.effects)
    if (const EffectTraits<Real>& traits = instance.effect->traits();
        traits.may_feed_back && instance.members.size() > 0)
      sentences.push_back(
          "'" + traits.name + "' reads " + text_of(traits.reads & quantity::of_motion) +
          (traits.finds_pairs ? ", of pairs that it finds itself" : ", and has no response()"));
  return sentences;
}

}  // namespace tumble
