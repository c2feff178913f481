/// @file
/// The step without the plan's sets, in two ways, to judge the step by plan.
#pragma once

#include <tumble/body_flags.hpp>
#include <tumble/body_registry.hpp>
#include <tumble/step_order.hpp>

namespace tumble {

/// A step that keeps no sets: in each pass `does_visit(pass, body)` is asked again of each body
/// that the pass is meant for. An effect that joins two always visits its pairs.
template <class Real, class DoesVisit>
void step_without_sets(Bodies<Real>& bodies, const StepPlan<Real>& plan, const StepTime<Real>& at,
                       const DoesVisit& does_visit, const BodyRegistry& registry) {
  for (const Pass<Real>& pass : all_passes(plan, plan.substeps)) {
    Members members;
    if (pass.row.kind == PassKind::input) {
      run(pass, plan, members, bodies, at);
      continue;
    }
    const EffectInstance<Real>& instance = instance_of(pass, plan);
    const EffectTraits<Real>& traits = instance.effect->traits();
    const auto ask = [&](BodyIndex body) {
      const BodyIndex member = traits.visits_tops() ? bodies.top_of[body] : body;
      if (member != no_index && does_visit(pass, body)) members.indices.insert(member);
    };
    if (traits.joins_two()) {  // one that finds its pairs has no targets
      for (std::size_t i = 0; i < instance.targets.size(); i += 2)
        members.pairs.push_back(
            {registry.index_of(instance.targets[i]), registry.index_of(instance.targets[i + 1])});
    } else {
      if (instance.everyone)
        for (BodyIndex body = 0; body < bodies.centres.size(); ++body) ask(body);
      for (const BodyHandle body : instance.targets) ask(registry.index_of(body));
    }
    run(pass, plan, members, bodies, at);
  }
}

/// The reference run: each predicate is asked for each body, and what is known of the bodies is
/// found anew in each step, from what they are alone.
//! [step_by_reference]
template <class Real>
void step_by_reference(Bodies<Real>& bodies, const StepPlan<Real>& plan,
                       const std::vector<BodyFlags>& alone, const StepTime<Real>& at,
                       const BodyRegistry& registry) {
  std::vector<std::vector<const AnyEffect<Real>*>> meant(alone.size());
  for (std::size_t i = own_motion_count; i < plan.motions.size(); ++i)
    for (auto& effects : meant) effects.push_back(plan.motions[i].effect.get());
  for (const EffectInstance<Real>& instance : plan.effects) {
    if (instance.everyone)
      for (auto& effects : meant) effects.push_back(instance.effect.get());
    for (const BodyHandle target : instance.targets)
      meant[registry.index_of(target)].push_back(instance.effect.get());
  }
  std::vector<BodyFlags> flags;
  for (std::size_t body = 0; body < alone.size(); ++body)
    flags.push_back(flags_under<Real>(alone[body], [&](const auto& ask) {
      for (const AnyEffect<Real>* effect : meant[body]) ask(*effect);
    }));
  step_without_sets(
      bodies, plan, at,
      [&](const Pass<Real>& pass, BodyIndex body) {
        return instance_of(pass, plan).effect->skip_reason(flags[body]).empty();
      },
      registry);
}
//! [step_by_reference]

/// Whether the exhaustive run visits a body that a pass is meant for. An effect visits every body
/// that has what it needs. Motions are asked about a body that everything pushes and turns, so that
/// each is kicked, drifts and turns: by the rule if its moments differ, else steadily, for that is
/// chapter 8's choice and no plan's.
//! [step_exhaustively]
template <class Real>
bool is_visited_exhaustively(const AnyEffect<Real>& effect, PassKind kind,
                             const Bodies<Real>& bodies, BodyIndex body) {
  if (kind == PassKind::motion)
    return effect
        .skip_reason({.is_point = is_point(bodies, body),
                      .can_turn = true,
                      .is_gyroscopic = is_gyroscopic(state_of(bodies, body).top),
                      .is_pushed = true,
                      .is_torqued = true,
                      .moves = true,
                      .turns = true})
        .empty();
  const EffectTraits<Real>& traits = effect.traits();
  if (traits.needs_top && is_point(bodies, body)) return false;
  const bool only_its_velocity = traits.writes == quantity::velocity;
  const bool only_its_force = traits.writes == quantity::force;
  // What nothing can move keeps the velocity that its user gave it.
  return !(is_static(bodies.centres[body]) && (only_its_velocity || only_its_force));
}

/// The exhaustive run: nothing is known of what acts on a body or how it moves, and no effect's
/// predicate is asked.
template <class Real>
void step_exhaustively(Bodies<Real>& bodies, const StepPlan<Real>& plan, const StepTime<Real>& at,
                       const BodyRegistry& registry) {
  step_without_sets(
      bodies, plan, at,
      [&](const Pass<Real>& pass, BodyIndex body) {
        const AnyEffect<Real>& effect = *instance_of(pass, plan).effect;
        return is_visited_exhaustively(effect, pass.row.kind, bodies, body);
      },
      registry);
}
//! [step_exhaustively]

}  // namespace tumble
