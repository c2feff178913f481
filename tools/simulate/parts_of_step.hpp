/// @file
/// The parts of a step of bodies that lie in plain arrays, each to be taken alone: what measures
/// their cost calls them.
#pragma once

#include <algorithm>
#include <tumble/world.hpp>

namespace tumble::simulate {

/// A line of the plan that visits somebody.
struct PartOfStep {
  std::string name;          ///< as the plan has it
  std::ptrdiff_t times = 0;  ///< in a step: Suzuki's has five kicks
  const StepPlan<double>* plan;
  std::vector<Pass<double>> passes;  ///< one, or all that a rotor does about the turning

  void act(Bodies<double>& bodies, const StepTime<double>& at) const {
    for (const Pass<double>& pass : passes) run(pass, *plan, members_of(pass, *plan), bodies, at);
  }
};

/// In the order of the plan's lines. `plan` must outlive them.
inline std::vector<PartOfStep> parts_of(const StepPlan<double>& plan) {
  std::vector<PartOfStep> parts;
  const auto part_of = [&](const Pass<double>& pass) {
    return std::find_if(parts.begin(), parts.end(), [&](const PartOfStep& part) {
      return &instance_of(part.passes[0], plan) == &instance_of(pass, plan);
    });
  };
  const std::vector<Substep<double>> of_one_kick = substeps_of<double>(Scheme::semi_implicit_euler);
  for (const Pass<double> pass : Passes(plan, of_one_kick, plan.in_phase, plan.motions_in_phase)) {
    if (pass.row.kind == PassKind::input) continue;
    const auto found = part_of(pass);
    if (found == parts.end())
      parts.push_back({instance_of(pass, plan).effect->name(), 0, &plan, {pass}});
    else
      found->passes.push_back(pass);
  }
  for (const Pass<double> pass : Passes(plan))
    if (pass.row.kind != PassKind::input && pass.row.act == RotorAct::join) ++part_of(pass)->times;
  return parts;
}

}  // namespace tumble::simulate
