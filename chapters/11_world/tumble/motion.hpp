/// @file
/// The effects that every world has: what clears the sums, what kicks, what drifts, what turns.
#pragma once

#include <tumble/effect.hpp>
#include <tumble/turning_methods.hpp>

namespace tumble {

//! [motion]
/// Empties the sum of forces.
template <class Real>
struct ClearForce {
  static constexpr std::string_view name = "clear the forces", reads{}, writes = "force";
  static constexpr Phase phase = Phase::force;
  std::string_view why_skipped(const Facts& facts) const {
    return facts.is_pushed ? "" : "no force acts on them";
  }
  void act(Particle<Real>& centre, const Moment<Real>&) const { clear_force(centre); }
  template <class Wide>
  ClearForce<Wide> widened() const {
    return {};
  }
};

/// Empties the sum of torques.
template <class Real>
struct ClearTorque {
  static constexpr std::string_view name = "clear the torques", reads{}, writes = "torque";
  static constexpr Phase phase = Phase::force;
  std::string_view why_skipped(const Facts& facts) const {
    return facts.is_torqued ? "" : "no torque acts on them";
  }
  void act(Top<Real>& top, const Moment<Real>&) const { clear_torque(top); }
  template <class Wide>
  ClearTorque<Wide> widened() const {
    return {};
  }
};

/// v ← v + h F/m.
template <class Real>
struct KickCentre {
  static constexpr std::string_view name = "kick", reads = "force", writes = "velocity";
  static constexpr Phase phase = Phase::kick;
  std::string_view why_skipped(const Facts& facts) const {
    return facts.is_static    ? "nothing can move them"
           : !facts.is_pushed ? "no force acts on them"
                              : "";
  }
  void act(Particle<Real>& centre, const Moment<Real>& moment) const {
    kick(centre, moment.time_step);
  }
  template <class Wide>
  KickCentre<Wide> widened() const {
    return {};
  }
};

/// L ← L + h τ.
template <class Real>
struct KickTop {
  static constexpr std::string_view name = "kick of the spin", reads = "torque, orientation";
  static constexpr Phase phase = Phase::kick;
  std::string_view why_skipped(const Facts& facts) const {
    return !facts.is_torqued ? "no torque acts on them"
           : !facts.can_turn ? "locked about every axis"
                             : "";
  }
  void act(Top<Real>& top, const Moment<Real>& moment) const { kick(top, moment.time_step); }
  template <class Wide>
  KickTop<Wide> widened() const {
    return {};
  }
};

/// x ← x + h v.
template <class Real>
struct DriftCentre {
  static constexpr std::string_view name = "drift", reads = "velocity", writes = "position";
  static constexpr Phase phase = Phase::drift;
  std::string_view why_skipped(const Facts& facts) const {
    return facts.moves       ? ""
           : facts.is_static ? "nothing can move them"
                             : "at rest, and nothing can move them";
  }
  void act(Particle<Real>& centre, const Moment<Real>& moment) const {
    drift(centre, moment.time_step);
  }
  template <class Wide>
  DriftCentre<Wide> widened() const {
    return {};
  }
};

/// Turns with steady ω the tops for which that is exact.
template <class Real>
struct TurnSteadily {
  static constexpr std::string_view name = "steady turning", reads = "angular momentum";
  static constexpr std::string_view writes = "orientation";
  static constexpr Phase phase = Phase::drift;
  std::string_view why_skipped(const Facts& facts) const {
    return !facts.turns          ? "no spin and nothing that can give torque"
           : facts.is_gyroscopic ? "their moments differ: they tumble"
                                 : "";
  }
  void act(Top<Real>& top, const Moment<Real>& moment) const {
    turn_steadily(top, moment.time_step);
  }
  template <class Wide>
  TurnSteadily<Wide> widened() const {
    return {};
  }
};

/// Turns by `rule`, a TurningRule, the tops whose L × ω can be other than zero.
template <class Real, class Rule>
struct Tumble {
  static constexpr std::string_view reads = "angular momentum";
  static constexpr std::string_view writes = "orientation, angular momentum";
  static constexpr Phase phase = Phase::drift;
  std::string name;
  Rule rule;
  std::string_view why_skipped(const Facts& facts) const {
    return !facts.turns           ? "no spin and nothing that can give torque"
           : !facts.is_gyroscopic ? "equal moments or a locked axis: they turn steadily"
                                  : "";
  }
  void act(Top<Real>& top, const Moment<Real>& moment) const { rule(top, moment.time_step); }
  template <class Wide>
  requires TurningRule<Rule, Wide> Tumble<Wide, Rule> widened()
  const { return {name, rule}; }
};
//! [motion]

}  // namespace tumble
