/// @file
/// The plan of a step: the scene's effects and the step's own motions, each with those it visits.
#pragma once

#include <array>
#include <tumble/any_effect.hpp>
#include <tumble/handles.hpp>
#include <tumble/scheme.hpp>

namespace tumble {

/// An effect of the scene, or a motion of the step's own, with the bodies that it is meant for and
/// those that it visits.
template <class Real>
struct EffectInstance {
  EffectHandle handle = {};                       ///< number 0 of a motion
  std::shared_ptr<const AnyEffect<Real>> effect;  ///< as it is now
  bool everyone = true;                           ///< every body is meant, also those added later
  std::vector<BodyHandle> targets = {};  ///< or else these; for pairs, first and second in turn
  Members members = {};                  ///< whom it visits

  /// How many bodies, or pairs, it is meant for in a world of so many bodies.
  std::size_t meant_for(std::size_t bodies) const {
    return everyone ? bodies : targets.size() / (effect->traits().joins_two() ? 2 : 1);
  }
};

/// A push for one step, which the user gave.
template <class Real>
struct Input {
  BodyIndex body;
  Push<Real> push;
};

/// Places in a list of effects, by their phase.
using EffectsByPhase = std::array<std::vector<std::size_t>, 6>;

/// What the steps of a world go through, in the order of step_order.hpp.
template <class Real>
struct StepPlan {
  std::vector<EffectInstance<Real>> effects;    ///< in the order in which they came
  std::vector<EffectInstance<Real>> motions;    ///< see motions.hpp
  EffectsByPhase in_phase;                      ///< those effects that visit any body
  EffectsByPhase motions_in_phase;              ///< and those motions
  std::vector<Input<Real>> inputs;              ///< pushes of this step alone
  IndexSet moving;                              ///< the centres that a step may change
  IndexSet turning;                             ///< the tops that it may change
  Scheme scheme = Scheme::semi_implicit_euler;  ///< see scheme.hpp
  std::vector<Substep<Real>> substeps = substeps_of<Real>(scheme);  ///< of a step, in their order
  std::uint64_t version = 0;  ///< a new number after each change
};

}  // namespace tumble
