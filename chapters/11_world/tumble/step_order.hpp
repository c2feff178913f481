/// @file
/// What a step does, in its order: the scene's effects among those that every world has.
#pragma once

#include <array>
#include <memory>
#include <string_view>
#include <tumble/motion.hpp>
#include <tumble/planner.hpp>

namespace tumble {

/// By which rule the bodies turn whose moments differ.
//! [turning_method]
enum class TurningMethod {
  splitting,               ///< sphere + axial + residual splitting: the world's own choice
  splitting_without_sine,  ///< the same in a third of the time, for angles that are small
  axis_by_axis,
  carrying_momentum,
  implicit_newton,
  restoring_momentum,
  explicit_euler,
  steady  ///< without gyroscopic motion
};
//! [turning_method]

/// The methods' names, in the order of TurningMethod.
inline constexpr std::array<std::string_view, 8> turning_method_names = {
    "splitting",       "splitting without sine", "axis by axis",   "carrying momentum",
    "implicit Newton", "restoring momentum",     "explicit Euler", "steady"};

/// The effect that turns by a method, in the form that `Keeping` runs.
template <class Real, class Keeping>
std::shared_ptr<const AnyEffect<Real>> tumbling_effect(TurningMethod method) {
  const std::string name =
      "tumbling: " + std::string(turning_method_names[static_cast<std::size_t>(method)]);
  const auto by = [&]<class Rule>(Rule rule) {
    return Keeping::erased(Tumble<Real, Rule>{name, rule});
  };
  switch (method) {
    case TurningMethod::splitting_without_sine:
      return by([](auto& top, auto time_step) { turn_by_splitting_without_sine(top, time_step); });
    case TurningMethod::axis_by_axis:
      return by([](auto& top, auto time_step) { turn_axis_by_axis(top, time_step); });
    case TurningMethod::carrying_momentum:
      return by([](auto& top, auto time_step) { turn_carrying_momentum(top, time_step); });
    case TurningMethod::implicit_newton:
      return by([](auto& top, auto time_step) { turn_implicitly(top, time_step); });
    case TurningMethod::restoring_momentum:
      return by([](auto& top, auto time_step) { turn_restoring_momentum(top, time_step); });
    case TurningMethod::explicit_euler:
      return by([](auto& top, auto time_step) { turn_explicitly(top, time_step); });
    case TurningMethod::steady:
      return by([](auto& top, auto time_step) { turn_steadily(top, time_step); });
    case TurningMethod::splitting:
      break;
  }
  return by([](auto& top, auto time_step) { turn_by_splitting(top, time_step); });
}

/// The scene's effects, in the order in which they came, and the motion that every world has, in
/// the order of a step.
//! [in_order]
template <class Real, class Keeping>
std::vector<Entry<Real>> in_order(const std::vector<Entry<Real>>& scene, TurningMethod method) {
  std::vector<Entry<Real>> entries;
  const auto add_scene = [&](Phase phase) {
    for (const Entry<Real>& entry : scene)
      if (entry.effect->phase() == phase) entries.push_back(entry);
  };
  const auto add = [&]<class Effect>(const Effect& effect) {
    entries.push_back({{}, Keeping::erased(effect)});
  };
  add(ClearForce<Real>{});
  add(ClearTorque<Real>{});
  add_scene(Phase::force);
  add_scene(Phase::kick);
  add(KickCentre<Real>{});
  add(KickTop<Real>{});
  add_scene(Phase::impulse);
  add_scene(Phase::damping);
  add(DriftCentre<Real>{});
  add(TurnSteadily<Real>{});
  entries.push_back({{}, tumbling_effect<Real, Keeping>(method)});
  add_scene(Phase::drift);
  return entries;
}
//! [in_order]

}  // namespace tumble
