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
PackedPart packed_part_of(const Work<Real>& work, const PackedPass<Real, width>& pass,
                          bool of_tops) {
  const std::size_t bodies = count_of(pass.group);
  switch (pass.act) {
    case Act::effect:
      return {work.effects[pass.entry].effect->name(), work.effects[pass.entry].visits.size()};
    case Act::rotor:
      return {work.effects[pass.entry].effect->name(), bodies};
    case Act::inputs:
      return {"input", work.inputs.size()};
    case Act::kick:
      return {std::string(of_tops ? kick_of_spin.name : kick_motion.name), bodies};
    case Act::drift:
      return {std::string(drift_motion.name), bodies};
    case Act::turn_steadily:
      return {std::string(steady_turning.name), bodies};
    case Act::tumble:
      return {"tumbling: " + work.rule->name(), bodies};
    default:
      return {std::string(pass.act == Act::guard ? "guard of " : "memory of ")
                  .append(of_tops ? "tops" : "centres"),
              bodies};
  }
}

}  // namespace tumble
