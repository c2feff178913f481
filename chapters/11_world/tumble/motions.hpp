/// @file
/// The motions of every step: it kicks, drifts and turns, whatever effects a scene has. Another one
/// is written as these are, and given to World::add_motion().
#pragma once

#include <algorithm>
#include <tumble/semi_implicit_euler.hpp>
#include <tumble/step_plan.hpp>
#include <tumble/turning_methods.hpp>

namespace tumble {

/// Changes the velocity by the force that was summed, and empties the sum.
//! [kick]
struct Kick {
  static constexpr std::string_view name = "kick";
  static constexpr Phase phase = Phase::kick;
  static constexpr Quantities reads = quantity::mass | quantity::force, writes = quantity::velocity;
  template <class Real>
  void operator()(Particle<Real>& centre, const Real& time_step) const {
    kick(centre, time_step);
    clear_force(centre);
  }
  std::string_view skip_reason(const BodyFlags& flags) const {
    return flags.is_pushed ? "" : "no force acts on them";
  }
};
//! [kick]

/// Changes the angular momentum by the torque that was summed, and empties the sum.
struct KickOfSpin {
  static constexpr std::string_view name = "kick of the spin";
  static constexpr Phase phase = Phase::kick;
  static constexpr Quantities reads = quantity::torque | quantity::orientation,
                              writes = quantity::spin;
  template <class Real>
  void operator()(Top<Real>& top, const Real& time_step) const {
    kick(top, time_step);
    clear_torque(top);
  }
  std::string_view skip_reason(const BodyFlags& flags) const {
    return flags.is_torqued ? "" : "no torque acts on them";
  }
};

/// Moves the centre of mass on by its velocity.
struct Drift {
  static constexpr std::string_view name = "drift";
  static constexpr Phase phase = Phase::drift;
  static constexpr Quantities reads = quantity::velocity, writes = quantity::position;
  template <class Real>
  void operator()(Particle<Real>& centre, const Real& time_step) const {
    drift(centre, time_step);
  }
  std::string_view skip_reason(const BodyFlags& flags) const {
    return flags.moves       ? ""
           : flags.is_static ? "nothing can move them"
                             : "at rest, and nothing can move them";
  }
};

/// Turns a top whose spin stays as it is: one with equal moments, or with a locked axis.
struct SteadyTurning {
  static constexpr std::string_view name = "steady turning";
  static constexpr Phase phase = Phase::drift;
  static constexpr Quantities reads = quantity::spin, writes = quantity::orientation;
  template <class Real>
  void operator()(Top<Real>& top, const Real& time_step) const {
    turn_steadily(top, time_step);
  }
  std::string_view skip_reason(const BodyFlags& flags) const {
    return !flags.turns          ? "no spin and nothing that can give torque"
           : flags.is_gyroscopic ? "their moments differ: they tumble"
                                 : "";
  }
};

/// What the name of every Tumbling begins with; that of its rule follows.
inline constexpr std::string_view tumbling_prefix = "tumbling: ";

/// Turns a top whose moments differ, by one of the rules of turning_methods.hpp or by a user's own.
template <class Rule>
struct Tumbling {
  static constexpr Phase phase = Phase::drift;
  static constexpr Quantities reads = quantity::spin,
                              writes = quantity::orientation | quantity::spin;
  /// @cond
  static constexpr auto letters = [] {
    std::array<char, tumbling_prefix.size() + std::string_view(Rule::name).size()> text{};
    const auto end = std::copy(tumbling_prefix.begin(), tumbling_prefix.end(), text.begin());
    std::copy(Rule::name.begin(), Rule::name.end(), end);
    return text;
  }();
  /// @endcond
  static constexpr std::string_view name{letters.data(), letters.size()};
  Rule rule;  ///< by which it turns them
  template <class Real>
  requires TurningRule<Rule, Real>
  void operator()(Top<Real>& top, const Real& time_step) const { rule(top, time_step); }
  static constexpr std::optional<int> order() {
    if constexpr (requires { Rule::order; })
      return Rule::order;
    else
      return {};
  }
  static constexpr bool is_symmetric() {
    if constexpr (requires { Rule::is_symmetric; })
      return Rule::is_symmetric;
    else
      return false;
  }
  std::string_view skip_reason(const BodyFlags& flags) const {
    return !flags.turns           ? "no spin and nothing that can give torque"
           : !flags.is_gyroscopic ? "equal moments or a locked axis: they turn steadily"
                                  : "";
  }
};

/// How many motions every step has, and which of them turns those that tumble.
inline constexpr std::size_t own_motion_count = 5, tumbling_index = own_motion_count - 1;

/// These motions, in the form in which `Backend` runs them.
template <class Real, class Backend, class Rule>
std::vector<EffectInstance<Real>> motions_of(const Rule& rule) {
  std::vector<EffectInstance<Real>> motions;
  const auto add = [&](const auto& motion) {
    motions.push_back({.effect = Backend::erased(motion)});
  };
  add(Kick{});
  add(KickOfSpin{});
  add(Drift{});
  add(SteadyTurning{});
  add(Tumbling<Rule>{.rule = rule});
  return motions;
}

/// The motion of those that tumble.
template <class Real>
const EffectInstance<Real>& tumbling_of(const StepPlan<Real>& plan) {
  return plan.motions[tumbling_index];
}

/// The name of the rule by which they turn.
template <class Real>
std::string turning_method_of(const StepPlan<Real>& plan) {
  return tumbling_of(plan).effect->name().substr(tumbling_prefix.size());
}

}  // namespace tumble
