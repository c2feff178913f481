/// @file
/// What a step does, in its order: the scene's effects among those that every world has.
#pragma once

#include <memory>
#include <tumble/motion.hpp>
#include <tumble/planner.hpp>

namespace tumble {

/// The effect that turns by a rule, in the form that `Keeping` runs.
template <class Real, class Keeping, class Rule>
std::shared_ptr<const AnyEffect<Real>> tumbling_effect(const Rule& rule) {
  return Keeping::erased(Tumble<Real, Rule>{std::string("tumbling: ").append(Rule::name), rule});
}

/// The scene's effects, in the order in which they came, and the motion that every world has, in
/// the order of a step; `tumbling` turns those whose moments differ.
//! [in_order]
template <class Real, class Keeping>
std::vector<Entry<Real>> in_order(const std::vector<Entry<Real>>& scene,
                                  const std::shared_ptr<const AnyEffect<Real>>& tumbling) {
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
  entries.push_back({{}, tumbling});
  add_scene(Phase::drift);
  return entries;
}
//! [in_order]

}  // namespace tumble
