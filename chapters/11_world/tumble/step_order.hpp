/// @file
/// The order of a step. It stands here and nowhere else: the step, and all that explains, judges or
/// measures it, go through this list.
#pragma once

#include <tumble/motions.hpp>

namespace tumble {

/// What a pass is: an effect of the scene, the pushes of this step alone, a motion of the step's
/// own, or a rotor, which shares its momentum about the turning.
enum class PassKind { effect, input, motion, rotor };

/// In which substeps, and of which phase, passes of a kind are run.
struct OrderRow {
  SubstepKind in;                 ///< of which kind of substep it is a part
  PassKind kind;                  ///< effects, motions, rotors, or what a program pushed
  Phase phase;                    ///< of its effects or motions
  RotorAct act = RotorAct::join;  ///< of rotors
};

/// All rotors have joined before any of them turns a body, and after the turning all goes the other
/// way round, so that a drift back undoes a drift forth.
//! [step_order]
inline constexpr std::array<OrderRow, 12> step_order = {{
    {SubstepKind::kick, PassKind::effect, Phase::force},  // forces and torques are summed
    {SubstepKind::kick, PassKind::input, Phase::force},   // and the user's pushes
    {SubstepKind::kick, PassKind::effect, Phase::kick},   // accelerations, and what is set
    {SubstepKind::kick, PassKind::motion, Phase::kick},   // the sums change velocities and spins
    {SubstepKind::whole, PassKind::effect, Phase::impulse},
    {SubstepKind::whole, PassKind::effect, Phase::damping},
    {SubstepKind::drift, PassKind::rotor, Phase::turn, RotorAct::join},
    {SubstepKind::drift, PassKind::rotor, Phase::turn, RotorAct::turn_before},
    {SubstepKind::drift, PassKind::motion, Phase::drift},  // bodies move on, and turn
    {SubstepKind::drift, PassKind::rotor, Phase::turn, RotorAct::turn_after},
    {SubstepKind::drift, PassKind::rotor, Phase::turn, RotorAct::leave},
    {SubstepKind::end, PassKind::effect, Phase::drift},  // what puts bodies somewhere itself
}};
//! [step_order]

/// One thing that a step does to all bodies that call for it.
template <class Real>
struct Pass {
  OrderRow row = step_order[0];  ///< in which row it stands
  Substep<Real> substep = {};    ///< and of which substep it is a part
  std::size_t place = 0;  ///< an index into the effects of the plan, or into its motions, so that a
                          ///< copied world may keep what it has made of its passes
};

/// What runs in a pass, and on whom. The inputs have none.
template <class Real>
const EffectInstance<Real>& instance_of(const Pass<Real>& pass, const StepPlan<Real>& plan) {
  return (pass.row.kind == PassKind::motion ? plan.motions : plan.effects)[pass.place];
}

/// Calls `visit` with one pass after another, for these substeps. `effects` and `motions` have the
/// places of those that take part, by phase.
template <class Real, class Visit>
void for_each_pass(const StepPlan<Real>& plan, const std::vector<Substep<Real>>& substeps,
                   const EffectsByPhase& effects, const EffectsByPhase& motions,
                   const Visit& visit) {
  for (const Substep<Real>& substep : substeps)
    for (const OrderRow& row : step_order) {
      if (row.in != substep.kind) continue;
      if (row.kind == PassKind::input) {
        if (!plan.inputs.empty()) visit(Pass<Real>{row, substep, 0});
        continue;
      }
      const auto& places =
          (row.kind == PassKind::motion ? motions : effects)[std::size_t(row.phase)];
      const bool backwards = row.kind == PassKind::rotor && row.act >= RotorAct::turn_after;
      for (std::size_t n = 0; n < places.size(); ++n)
        visit(Pass<Real>{row, substep, places[backwards ? places.size() - 1 - n : n]});
    }
}

/// The passes of a step that visit anybody.
template <class Real, class Visit>
void for_each_pass(const StepPlan<Real>& plan, const Visit& visit) {
  for_each_pass(plan, plan.substeps, plan.in_phase, plan.motions_in_phase, visit);
}

/// All of them, those that visit nobody too.
template <class Real, class Visit>
void for_each_pass_even_idle(const StepPlan<Real>& plan, const std::vector<Substep<Real>>& substeps,
                             const Visit& visit) {
  const auto by_phase = [](const std::vector<EffectInstance<Real>>& instances) {
    EffectsByPhase all;
    for (std::size_t i = 0; i < instances.size(); ++i)
      all[static_cast<std::size_t>(instances[i].effect->phase())].push_back(i);
    return all;
  };
  for_each_pass(plan, substeps, by_phase(plan.effects), by_phase(plan.motions), visit);
}

/// When a pass happens in a step. Rotors act with what they hold at their end of the drift.
template <class Real>
StepTime<Real> step_time_of(const Pass<Real>& pass, const StepTime<Real>& step) {
  const StepTime<Real> at = step_time_of(pass.substep, step);
  return pass.row.kind == PassKind::rotor ? StepTime<Real>{time_of(pass.row.act, at), at.time_step}
                                          : at;
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

/// Whom the plan lets a pass visit; the inputs name their bodies themselves.
template <class Real>
const Members& members_of(const Pass<Real>& pass, const StepPlan<Real>& plan) {
  static const Members nobody;
  return pass.row.kind == PassKind::input ? nobody : instance_of(pass, plan).members;
}

/// Runs a pass on these members, in plain arrays.
template <class Real>
void run(const Pass<Real>& pass, const StepPlan<Real>& plan, const Members& members,
         Bodies<Real>& bodies, const StepTime<Real>& step) {
  if (pass.row.kind == PassKind::input) return add(plan.inputs, bodies);
  instance_of(pass, plan).effect->run(bodies, members, step_time_of(pass, step), pass.row.act);
}

}  // namespace tumble
