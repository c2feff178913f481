/// @file
/// What a step in packs consists of.
#pragma once

#include <string>
#include <tumble/schedule.hpp>

namespace tumble {

/// One thing that a step does, and how many bodies, or pairs, it does it to.
struct PackedPart {
  std::string name;
  std::size_t bodies;
};

/// The pass as a part of the step; of those on tops and on centres alike, `of_tops` tells which.
template <class Real, int width>
PackedPart packed_part_of(const StepPlan<Real>& plan, const PackedPass<Real, width>& pass,
                          bool of_tops) {
  if (pass.task != Task::run)
    return {std::string(pass.task == Task::guard ? "guard of " : "memory of ")
                .append(of_tops ? "tops" : "centres"),
            count_of(pass.indices)};
  if (pass.row.kind == PassKind::input) return {"input", plan.inputs.size()};
  const EffectInstance<Real>& instance = instance_of(pass, plan);
  return {instance.effect->name(), instance.members.size()};
}

}  // namespace tumble
