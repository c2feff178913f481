/// @file
/// The work of a step: the scene's effects, each with the bodies that it visits, and the groups of
/// those that are kicked, drift and turn.
#pragma once

#include <array>
#include <tumble/any_effect.hpp>
#include <tumble/handles.hpp>
#include <tumble/rule.hpp>
#include <tumble/scheme.hpp>

namespace tumble {

/// An effect of the scene, with the bodies that it is meant for and those that it visits.
template <class Real>
struct Entry {
  EffectHandle handle;
  std::shared_ptr<const AnyEffect<Real>> effect;
  bool everyone = true;
  std::vector<BodyHandle> targets = {};  ///< else these; for joins, first and second in turn
  Visits visits = {};
};

/// A push for one step, which the user gave.
template <class Real>
struct Input {
  BodyIndex body;
  Push<Real> push;
};

/// What the steps of a world go through: what the planner has made of the scene.
template <class Real>
struct Work {
  std::vector<Entry<Real>> effects;  ///< in the order in which they came
  /// Those that visit any body, by phase: indices into `effects`.
  std::array<std::vector<std::size_t>, 6> in_phase;
  std::vector<Input<Real>> inputs;            ///< pushes of this step alone
  IndexSet pushed, movers;                    ///< centres
  IndexSet torqued, steady, tumbling;         ///< tops
  std::shared_ptr<const AnyRule<Real>> rule;  ///< turns those that tumble
  Scheme scheme = Scheme::semi_implicit_euler;
  std::vector<Substep<Real>> substeps = substeps_of<Real>(scheme);  ///< of the scheme
  std::uint64_t version = 0;  ///< a new number after each change
};

/// Runs the effects of a phase.
template <class Real>
void run(const Work<Real>& work, Phase phase, Bodies<Real>& bodies, const StepTime<Real>& moment) {
  for (const std::size_t i : work.in_phase[static_cast<std::size_t>(phase)])
    work.effects[i].effect->run(bodies, work.effects[i].visits, moment);
}

/// Adds the pushes of this step alone.
template <class Real>
void add(const std::vector<Input<Real>>& inputs, Bodies<Real>& bodies) {
  for (const Input<Real>& input : inputs) {
    Top<Real> none;
    const BodyIndex top = bodies.top_of[input.body];
    add_push(bodies.centres[input.body], top == no_index ? none : bodies.tops[top], input.push);
  }
}

/// The motions that every world has. Each has a sentence for bodies that do not need it.
struct Motion {
  std::string_view name;
  Phase phase;
  Quantities reads, writes;
  std::string_view (*skip_reason)(const BodyFlags&);
};

inline constexpr Motion kick_motion = {
    "kick", Phase::kick, quantity::force, quantity::velocity, [](const BodyFlags& flags) {
      return flags.is_static    ? std::string_view("nothing can move them")
             : !flags.is_pushed ? "no force acts on them"
                                : "";
    }};
inline constexpr Motion kick_of_spin = {
    "kick of the spin", Phase::kick, quantity::torque | quantity::orientation, quantity::spin,
    [](const BodyFlags& flags) {
      return flags.is_point      ? std::string_view("points do not turn")
             : !flags.can_turn   ? "locked about every axis"
             : !flags.is_torqued ? "no torque acts on them"
                                 : "";
    }};
inline constexpr Motion drift_motion = {
    "drift", Phase::drift, quantity::velocity, quantity::position, [](const BodyFlags& flags) {
      return flags.moves       ? std::string_view("")
             : flags.is_static ? "nothing can move them"
                               : "at rest, and nothing can move them";
    }};
inline constexpr Motion steady_turning = {
    "steady turning", Phase::drift, quantity::spin, quantity::orientation,
    [](const BodyFlags& flags) {
      return flags.is_point        ? std::string_view("points do not turn")
             : !flags.turns        ? "no spin and nothing that can give torque"
             : flags.is_gyroscopic ? "their moments differ: they tumble"
                                   : "";
    }};
inline constexpr Motion tumbling_motion = {
    "tumbling", Phase::drift, quantity::spin, quantity::orientation | quantity::spin,
    [](const BodyFlags& flags) {
      return flags.is_point         ? std::string_view("points do not turn")
             : !flags.turns         ? "no spin and nothing that can give torque"
             : !flags.is_gyroscopic ? "equal moments or a locked axis: they turn steadily"
                                    : "";
    }};

}  // namespace tumble
