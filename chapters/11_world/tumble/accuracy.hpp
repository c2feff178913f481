/// @file
/// With which power of the time step a world's error falls, and what limits it.
#pragma once

#include <algorithm>
#include <string>
#include <tumble/work.hpp>
#include <vector>

namespace tumble {

/// The order that a step of a world is sure of where no force or torque jumps. Where one of them
/// does, as when a thruster ends or a tether with a damper becomes taut, it is 1 in that step.
struct Accuracy {
  Scheme scheme = Scheme::semi_implicit_euler;
  int order = 1;
  std::vector<std::string> limits = {};  ///< why it is less than the scheme's, a clause each
};

/// The order that an effect leaves to a scheme, as a clause if that is less than the scheme's.
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
Accuracy accuracy_of(const Work<Real>& work) {
  Accuracy accuracy{work.scheme, order_of(work.scheme)};
  const int wanted = accuracy.order;
  const auto limit_to = [&](int order, const std::string& why) {
    if (order >= wanted) return;
    accuracy.order = std::min(accuracy.order, order);
    accuracy.limits.push_back(why);
  };
  for (const Entry<Real>& entry : work.effects)
    if (entry.visits.size() > 0) {
      const EffectTraits<Real>& traits = entry.effect->traits();
      if (const std::string why = why_first_order(*entry.effect); !why.empty())
        limit_to(1, why);
      else
        limit_to(traits.smoothness + 2, "'" + traits.name + "' has a kink");
    }
  if (work.tumbling.empty()) return accuracy;
  const AnyRule<Real>& rule = *work.rule;
  const std::string turning = "turning by " + rule.name();
  if (!rule.order())
    limit_to(0, turning + " does not say its order");
  else if (*rule.order() < 2 || !rule.is_symmetric())  // else it gets the scheme's, see Suzuki
    limit_to(*rule.order(), turning + " is of order " + std::to_string(*rule.order()));
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
