/// @file
/// The parts of a step of bodies that lie in plain arrays, each to be taken alone: what measures
/// their cost calls them.
#pragma once

#include <algorithm>
#include <functional>
#include <tumble/world.hpp>

namespace tumble::simulate {

/// A line of the plan that visits somebody.
struct PartOfStep {
  std::string name;      ///< as the plan has it
  std::ptrdiff_t times;  ///< in a step: Suzuki's has five kicks
  std::function<void(Bodies<double>&, const StepTime<double>&)> act;
};

/// In the order of the plan's lines. `work` must outlive them.
inline std::vector<PartOfStep> parts_of(const Work<double>& work) {
  using Every = Bodies<double>;
  using At = StepTime<double>;
  std::vector<PartOfStep> parts;
  const auto times_of = [&work](Phase phase) {
    const SubstepKind stroke = phase == Phase::drift ? SubstepKind::drift : SubstepKind::kick;
    return std::count_if(work.substeps.begin(), work.substeps.end(),
                         [&](const auto& substep) { return substep.kind == stroke; });
  };
  const auto add_scene = [&](Phase phase, std::ptrdiff_t times) {
    for (const std::size_t i : work.in_phase[static_cast<std::size_t>(phase)]) {
      const Entry<double>& entry = work.effects[i];
      parts.push_back({entry.effect->name(), times, [&entry](Every& bodies, const At& moment) {
                         entry.effect->run(bodies, entry.visits, moment);
                       }});
    }
  };
  const auto add_motion = [&](const Motion& motion, const IndexSet& group, const auto& act) {
    if (!group.empty())
      parts.push_back(
          {&group == &work.tumbling ? "tumbling: " + work.rule->name() : std::string(motion.name),
           times_of(motion.phase), act});
  };
  add_scene(Phase::force, times_of(Phase::force));
  add_scene(Phase::kick, times_of(Phase::kick));
  add_motion(kick_motion, work.pushed, [&work](Every& bodies, const At& moment) {
    for_each_of(work.pushed, bodies.centres,
                [&](auto& centre) { kick(centre, moment.time_step), clear_force(centre); });
  });
  add_motion(kick_of_spin, work.torqued, [&work](Every& bodies, const At& moment) {
    for_each_of(work.torqued, bodies.tops,
                [&](auto& top) { kick(top, moment.time_step), clear_torque(top); });
  });
  add_scene(Phase::impulse, 1);
  add_scene(Phase::damping, 1);
  for (const std::size_t i : rotors_of(work))  // what they do on both sides of the turning is one
    parts.push_back({work.effects[i].effect->name(), times_of(Phase::drift),
                     [&work, i](Every& bodies, const At& moment) {
                       for (const RotorAct act : {RotorAct::join, RotorAct::turn_before,
                                                  RotorAct::turn_after, RotorAct::leave})
                         run_rotor(work, i, act, bodies.tops, moment);
                     }});
  add_motion(drift_motion, work.movers, [&work](Every& bodies, const At& moment) {
    for_each_of(work.movers, bodies.centres,
                [&](auto& centre) { drift(centre, moment.time_step); });
  });
  add_motion(steady_turning, work.steady, [&work](Every& bodies, const At& moment) {
    for_each_of(work.steady, bodies.tops, [&](auto& top) { turn_steadily(top, moment.time_step); });
  });
  add_motion(tumbling_motion, work.tumbling, [&work](Every& bodies, const At& moment) {
    work.rule->turn(bodies.tops, work.tumbling, moment.time_step);
  });
  add_scene(Phase::drift, 1);
  return parts;
}

}  // namespace tumble::simulate
