/// @file
/// With which power of the time step a world's error falls, and what limits it.
#pragma once

#include <algorithm>
#include <string>
#include <tumble/motions.hpp>
#include <vector>

namespace tumble {

/// The order that a step of a world is sure of where no force or torque jumps. Where one of them
/// does, as when a thruster ends or a tether with a damper becomes taut, it is 1 in that step.
struct Accuracy {
  Scheme scheme = Scheme::semi_implicit_euler;  ///< by which the world steps
  int order = 1;                                ///< the error falls as h to this power
  std::vector<std::string> limits = {};         ///< why it is less than the scheme's, a clause each
};

/// Why an effect leaves any scheme only the first order, as a clause; empty if it does not.
///
/// A kick takes the velocities and spins that it is about to change as those of its whole length,
/// which is right to first order. Blows, damping and what acts at the end of a step act for
/// themselves once a step, and not in its middle: that is of first order as well. What sets a
/// velocity or a place with a kick sets it for the time of the kick, and half a drift still
/// follows.
template <class Real>
std::string why_first_order(const AnyEffect<Real>& effect) {
  const EffectTraits<Real>& traits = effect.traits();
  if (traits.phase == Phase::impulse || traits.phase == Phase::damping ||
      traits.phase == Phase::drift)
    return "'" + traits.name + "' acts apart from the kicks";
  if (traits.replaces) return "'" + traits.name + "' sets a velocity, a spin or a place itself";
  return traits.depends_on_speed ? "'" + traits.name + "' depends on a velocity or a spin" : "";
}

/// What a world's step is sure of.
///
/// In the step in which derivative number s + 1 of a force jumps, the scheme takes the force for
/// one that is off by up to h^(s+1), and so the velocity by h^(s+2). However few such steps there
/// are, they leave no higher order than s + 2.
template <class Real>
Accuracy accuracy_of(const StepPlan<Real>& plan) {
  Accuracy accuracy{plan.scheme, order_of(plan.scheme)};
  const int wanted = accuracy.order;
  const auto limit_to = [&](int order, const std::string& why) {
    if (order >= wanted) return;
    accuracy.order = std::min(accuracy.order, order);
    accuracy.limits.push_back(why);
  };
  for (const EffectInstance<Real>& instance : plan.effects)
    if (instance.members.size() > 0) {
      const EffectTraits<Real>& traits = instance.effect->traits();
      if (const std::string why = why_first_order(*instance.effect); !why.empty())
        limit_to(1, why);
      else
        limit_to(traits.smoothness + 2, "'" + traits.name + "' has a kink");
    }
  for (std::size_t i = own_motion_count; i < plan.motions.size(); ++i)
    if (plan.motions[i].members.size() > 0)
      limit_to(1, "'" + plan.motions[i].effect->name() + "' does not say its order");
  if (tumbling_of(plan).members.size() == 0) return accuracy;
  const EffectTraits<Real>& rule = tumbling_of(plan).effect->traits();
  const std::string turning = "turning by " + turning_method_of(plan);
  if (!rule.order)
    limit_to(0, turning + " does not say its order");
  else if (*rule.order < 2 || !rule.is_symmetric)  // else it gets the scheme's, see Suzuki
    limit_to(*rule.order, turning + " is of order " + std::to_string(*rule.order));
  return accuracy;
}

/// "order 2: Verlet", or "order 1 in place of 2 (Verlet): 'air' depends on a velocity or a spin".
inline std::string text_of(const Accuracy& accuracy) {
  const std::string scheme(name_of(accuracy.scheme));
  std::string text = "order " + std::to_string(accuracy.order);
  if (accuracy.limits.empty()) return text.append(": ").append(scheme);
  text.append(" in place of ").append(std::to_string(order_of(accuracy.scheme)));
  text.append(" (").append(scheme).append(")");
  for (std::size_t i = 0; i < accuracy.limits.size(); ++i)
    text.append(i == 0 ? ": " : "; ").append(accuracy.limits[i]);
  return text;
}

}  // namespace tumble
