/// @file
/// The step without groups, in two ways, to judge the step by plan.
#pragma once

#include <tumble/body_flags.hpp>
#include <tumble/rotors.hpp>
#include <tumble/tumbling.hpp>
#include <tumble/work.hpp>

namespace tumble {

/// A step without groups, body after body. `visits(entry, body)` says whether an effect visits a
/// body that it is meant for; `moves`, with a Motion and a body, whether a motion does.
/// `index_of` gives the place of a handle.
template <class Real, class DoesVisit, class Moves, class IndexOf>
void step_without_groups(Bodies<Real>& bodies, const Work<Real>& work, const StepTime<Real>& moment,
                         const DoesVisit& visits, const Moves& moves, const IndexOf& index_of) {
  const auto for_each_visit = [&](const Entry<Real>& entry, const auto& run) {
    const EffectTraits<Real>& traits = entry.effect->traits();
    if (traits.finds_pairs) {
      run(Visits{});
    } else if (traits.joins_two()) {
      for (std::size_t i = 0; i < entry.targets.size(); i += 2)
        run(Visits{{}, {{index_of(entry.targets[i]), index_of(entry.targets[i + 1])}}});
    } else {
      const auto visit_one = [&](BodyIndex body) {
        Visits one;
        if (!visits(entry, body)) return;
        one.group.insert(traits.visits_tops() ? bodies.top_of[body] : body);
        run(one);
      };
      if (entry.everyone)
        for (BodyIndex body = 0; body < bodies.centres.size(); ++body) visit_one(body);
      for (const BodyHandle body : entry.targets) visit_one(index_of(body));
    }
  };
  const auto run_phase = [&](Phase phase, const StepTime<Real>& at) {
    for (const Entry<Real>& entry : work.effects)
      if (entry.effect->phase() == phase)
        for_each_visit(entry, [&](const Visits& one) { entry.effect->run(bodies, one, at); });
  };
  std::vector<std::size_t> rotors;
  for (std::size_t i = 0; i < work.effects.size(); ++i)
    if (work.effects[i].effect->phase() == Phase::turn) rotors.push_back(i);
  const auto for_centres = [&](const Motion& motion, const auto& change) {
    for (BodyIndex body = 0; body < bodies.centres.size(); ++body)
      if (moves(motion, body)) change(bodies.centres[body]);
  };
  const auto for_tops = [&](const Motion& motion, const auto& change) {
    for (BodyIndex top = 0; top < bodies.tops.size(); ++top)
      if (moves(motion, bodies.body_of[top])) change(bodies.tops[top]);
  };
  for (const Substep<Real>& substep : work.substeps) {
    const StepTime<Real> part = step_time_of(substep, moment);
    const Real h = part.time_step;
    if (substep.kind == SubstepKind::kick) {
      run_phase(Phase::force, part);
      add(work.inputs, bodies);
      run_phase(Phase::kick, part);
      for_centres(kick_motion, [&](auto& centre) { kick(centre, h), clear_force(centre); });
      for_tops(kick_of_spin, [&](auto& top) { kick(top, h), clear_torque(top); });
    } else if (substep.kind == SubstepKind::whole) {
      run_phase(Phase::impulse, moment);
      run_phase(Phase::damping, moment);
    } else {
      for_centres(drift_motion, [&](auto& centre) { drift(centre, h); });
      const auto rotor = [&](std::size_t i, RotorAct act) {
        const Entry<Real>& entry = work.effects[i];
        for_each_visit(entry, [&](const Visits& one) {
          run_rotor(*entry.effect, one.group, act, bodies.tops, part);
        });
      };
      with_rotors(rotors, rotor, [&] {
        for_tops(steady_turning, [&](auto& top) { turn_steadily(top, h); });
        for_tops(tumbling_motion, [&](auto& top) {
          IndexSet one;
          one.insert(0);
          std::vector<Top<Real>> alone = {top};
          work.rule->turn(alone, one, h);
          top = alone[0];
        });
      });
    }
  }
  run_phase(Phase::drift, moment);
}

/// The reference run: each predicate is asked for each body, and what is known of the bodies is
/// found anew in each step, from what they are alone.
//! [step_by_reference]
template <class Real, class IndexOf>
void step_by_reference(Bodies<Real>& bodies, const Work<Real>& work,
                       const std::vector<BodyFlags>& alone, const StepTime<Real>& moment,
                       const IndexOf& index_of) {
  std::vector<std::vector<const AnyEffect<Real>*>> meant(alone.size());
  for (const Entry<Real>& entry : work.effects) {
    if (entry.everyone)
      for (auto& effects : meant) effects.push_back(entry.effect.get());
    for (const BodyHandle target : entry.targets)
      meant[index_of(target)].push_back(entry.effect.get());
  }
  std::vector<BodyFlags> flags;
  for (std::size_t body = 0; body < alone.size(); ++body)
    flags.push_back(flags_under<Real>(alone[body], [&](const auto& ask) {
      for (const AnyEffect<Real>* effect : meant[body]) ask(*effect);
    }));
  step_without_groups(
      bodies, work, moment,
      [&](const Entry<Real>& entry, BodyIndex body) {
        return entry.effect->skip_reason(flags[body]).empty();
      },
      [&](const Motion& motion, BodyIndex body) { return motion.skip_reason(flags[body]).empty(); },
      index_of);
}
//! [step_by_reference]

/// The exhaustive run: nothing is known and nobody is asked. An effect visits every body that has
/// what it needs, every body is kicked and drifts, and every top turns: by the rule if its
/// moments differ, else steadily, for that is chapter 8's choice and no plan's.
//! [step_exhaustively]
template <class Real, class IndexOf>
void step_exhaustively(Bodies<Real>& bodies, const Work<Real>& work, const StepTime<Real>& moment,
                       const IndexOf& index_of) {
  step_without_groups(
      bodies, work, moment,
      [&](const Entry<Real>& entry, BodyIndex body) {
        const EffectTraits<Real>& traits = entry.effect->traits();
        if (traits.needs_top && is_point(bodies, body)) return false;
        const bool only_its_velocity = traits.writes == quantity::velocity;
        const bool only_its_force = traits.writes == quantity::force;
        // What has no mass to push keeps the velocity that its user gave it.
        return !(is_static(bodies.centres[body]) && (only_its_velocity || only_its_force));
      },
      [&](const Motion& motion, BodyIndex body) {
        const bool tumbles = is_gyroscopic(state_of(bodies, body).top);
        return motion.name == steady_turning.name    ? !tumbles
               : motion.name == tumbling_motion.name ? tumbles
                                                     : true;
      },
      index_of);
}
//! [step_exhaustively]

}  // namespace tumble
