/// @file
/// In which order blocks of packs go through the passes of a plan.
#pragma once

#include <tumble/guard.hpp>
#include <tumble/packed_effect.hpp>

namespace tumble {

/// A pass of a plan, sorted into packs.
template <class Real, int width>
struct PackedPass {
  std::size_t pass;  ///< which of the plan's
  const PackedEffect<Real, width>* effect;
  PackGroup<Real, width> group;
};

/// Passes that each block of bodies can go through from first to last without regard to others.
///
/// An effect on centres alone and one on tops alone do not meet, so a stage has a row of passes for
/// each. An effect that sees both must come after everything before it: it is a stage of its own.
//! [stage]
template <class Real, int width>
struct Stage {
  std::vector<PackedPass<Real, width>> on_centres, on_tops;
  std::vector<PackedPass<Real, width>> on_both;  ///< one or none
};
//! [stage]

/// A plan for packs.
template <class Real, int width>
struct Schedule {
  std::vector<Stage<Real, width>> stages;
  PackGroup<Real, width> movers, turners;
};

/// Sorts the passes of a plan into stages, in their order.
//! [schedule]
template <class Real, int width>
Schedule<Real, width> schedule_of(const Planned<Real>& planned, std::size_t body_count,
                                  std::size_t top_count) {
  Schedule<Real, width> schedule;
  schedule.stages.emplace_back();
  for (std::size_t i = 0; i < planned.passes.size(); ++i) {
    const Pass<Real>& pass = planned.passes[i];
    const auto* effect = dynamic_cast<const PackedEffect<Real, width>*>(pass.effect.get());
    const bool tops = pass.effect->traits().visits_tops;
    PackedPass<Real, width> packed{i, effect, {}};
    if (!pass.effect->traits().joins_two)
      packed.group = pack_group<Real, width>(pass.group.everyone, pass.group.members,
                                             tops ? top_count : body_count);
    if (effect->sees_both()) {
      schedule.stages.emplace_back().on_both.push_back(std::move(packed));
      schedule.stages.emplace_back();
    } else {
      Stage<Real, width>& stage = schedule.stages.back();
      (tops ? stage.on_tops : stage.on_centres).push_back(std::move(packed));
    }
  }
  schedule.movers = pack_group<Real, width>(false, planned.movers, body_count);
  schedule.turners = pack_group<Real, width>(false, planned.turners, top_count);
  return schedule;
}
//! [schedule]

/// True if one of the group's members in the packs from `begin` to before `end` is no longer whole.
template <class Real, int width, class Packed>
bool any_lost(const std::vector<Packed>& array, const PackGroup<Real, width>& group,
              std::uint32_t begin, std::uint32_t end) {
  typename PackMask<Real, width>::Lanes lost{};
  for_each_whole(group, begin, end, [&](std::uint32_t first, std::uint32_t last) {
    for (std::uint32_t pack = first; pack < last; ++pack) lost |= (!is_whole(array[pack])).lanes;
  });
  for_each_part(group, begin, end, [&](std::uint32_t pack, const auto& members) {
    lost |= (members && !is_whole(array[pack])).lanes;
  });
  for (int lane = 0; lane < width; ++lane)
    if (lost[lane]) return true;
  return false;
}

}  // namespace tumble
