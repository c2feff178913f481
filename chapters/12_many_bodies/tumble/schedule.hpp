/// @file
/// In which order blocks of packs go through the work of a step.
#pragma once

#include <tumble/guard.hpp>
#include <tumble/pack_colouring.hpp>
#include <tumble/packed_effect.hpp>
#include <tumble/rotors.hpp>

namespace tumble {

/// What a pass does to each block.
enum class Act { remember, effect, inputs, kick, drift, rotor, turn_steadily, tumble, guard };

/// One thing that is done to the bodies of a group, sorted into packs.
template <class Real, int width>
struct PackedPass {
  Act act;
  Substep<Real> substep = whole_step<Real>;  ///< of the step, in which it is done
  PackedIndexSet<Real, width> group = {};
  std::size_t entry = 0;  ///< the number of the scene's effect, if it is one
  const PackedEffect<Real, width>* effect = nullptr;  ///< that one
  const PackedRule<Real, width>* rule = nullptr;      ///< for those that tumble
  RotorAct rotor_act = {};                            ///< what a rotor does
  PackColouring apart = {};  ///< for more threads than one, of an effect that sees centre and top
};

/// Passes that each block of one array can go through from first to last, and the blocks in which
/// any of them has members: by the number of their first pack.
template <class Real, int width>
struct Row {
  std::vector<PackedPass<Real, width>> passes;
  std::vector<std::uint32_t> blocks;
};

/// An effect on centres alone and one on tops alone do not affect each other, so a stage has a row
/// of passes for each. An effect that sees both must come after everything before it: it begins a
/// stage.
//! [stage]
template <class Real, int width>
struct Stage {
  std::vector<PackedPass<Real, width>> on_both;  ///< one or none
  Row<Real, width> on_centres, on_tops;
};
//! [stage]

/// The work of a step for packs.
template <class Real, int width>
class Schedule {
 public:
  /// A block's particles and tops together are about as large as the smallest cache: 24 kB where a
  /// register has 32 bytes, and twice as much where it has 64.
  static constexpr std::uint32_t packs_in_block = 32;

  /// Work of another version than this needs another schedule.
  std::uint64_t version = 0;
  std::vector<Stage<Real, width>> stages;

  Schedule() = default;
  //! [schedule]
  explicit Schedule(const Work<Real>& work) : version(work.version), stages(1) {
    on_centres(Act::remember, work.movers);
    on_tops(Act::remember, work.steady);
    on_tops(Act::remember, work.tumbling);
    for (const Substep<Real>& substep : work.substeps) {
      now_ = substep;
      if (substep.kind == SubstepKind::kick) {
        add_effects(work, Phase::force);
        if (!work.inputs.empty()) on_both({Act::inputs});
        add_effects(work, Phase::kick);
        on_centres(Act::kick, work.pushed);
        on_tops(Act::kick, work.torqued);
      } else if (substep.kind == SubstepKind::whole) {
        add_effects(work, Phase::impulse);
        add_effects(work, Phase::damping);
      } else {
        on_centres(Act::drift, work.movers);
        const auto rotor = [&](std::size_t i, RotorAct act) {
          on_tops(Act::rotor, work.effects[i].visits.group);
          stages.back().on_tops.passes.back().entry = i;
          stages.back().on_tops.passes.back().rotor_act = act;
        };
        with_rotors(rotors_of(work), rotor, [&] {
          on_tops(Act::turn_steadily, work.steady);
          on_tops(Act::tumble, work.tumbling);
          if (!work.tumbling.empty())
            stages.back().on_tops.passes.back().rule =
                dynamic_cast<const PackedRule<Real, width>*>(work.rule.get());
        });
      }
    }
    now_ = whole_step<Real>;
    add_effects(work, Phase::drift);
    on_centres(Act::guard, work.movers);
    on_tops(Act::guard, work.steady);
    on_tops(Act::guard, work.tumbling);
    for (Stage<Real, width>& stage : stages)
      for (Row<Real, width>* row : {&stage.on_centres, &stage.on_tops}) find_blocks(*row);
  }
  //! [schedule]

  /// Makes it fit for more threads than one.
  void keep_threads_apart(const PackedBodies<Real, width>& bodies) {
    for (Stage<Real, width>& stage : stages)
      for (PackedPass<Real, width>& pass : stage.on_both)
        if (pass.act == Act::effect) pass.apart = pack_colouring(pass.group, bodies);
  }

 private:
  void on_centres(Act act, const IndexSet& group) { add(stages.back().on_centres, act, group); }
  void on_tops(Act act, const IndexSet& group) { add(stages.back().on_tops, act, group); }
  void on_both(PackedPass<Real, width> pass) {
    stages.emplace_back().on_both.push_back(std::move(pass));
  }
  void add(Row<Real, width>& row, Act act, const IndexSet& group) {
    if (!group.empty()) row.passes.push_back({act, now_, packed_index_set<Real, width>(group)});
  }

  void add_effects(const Work<Real>& work, Phase phase) {
    for (const std::size_t i : work.in_phase[static_cast<std::size_t>(phase)]) {
      const Entry<Real>& entry = work.effects[i];
      PackedPass<Real, width> pass{
          Act::effect, now_, packed_index_set<Real, width>(entry.visits.group), i,
          dynamic_cast<const PackedEffect<Real, width>*>(entry.effect.get())};
      const Sees sees = entry.effect->traits().sees;
      if (sees == Sees::centre)
        stages.back().on_centres.passes.push_back(std::move(pass));
      else if (sees == Sees::top)
        stages.back().on_tops.passes.push_back(std::move(pass));
      else
        on_both(std::move(pass));
    }
  }

  Substep<Real> now_ = whole_step<Real>;  // that of the passes which are being added

  static void find_blocks(Row<Real, width>& row) {
    std::vector<std::uint32_t>& blocks = row.blocks;
    for (const PackedPass<Real, width>& pass : row.passes) {
      const std::size_t known = blocks.size();
      const auto add_block = [&](std::uint32_t pack) {
        const std::uint32_t first = pack / packs_in_block * packs_in_block;
        if (blocks.size() == known || blocks.back() != first) blocks.push_back(first);
      };
      for (const WholePacks& packs : pass.group.whole)
        for (std::uint32_t pack = packs.begin / packs_in_block * packs_in_block; pack < packs.end;
             pack += packs_in_block)
          add_block(pack);
      for (const auto& part : pass.group.parts) add_block(part.pack);
    }
    std::sort(blocks.begin(), blocks.end());
    blocks.erase(std::unique(blocks.begin(), blocks.end()), blocks.end());
  }
};

/// True if one of the group's members in the packs from `begin` to before `end` is no longer whole.
template <class Real, int width, class Packed>
bool any_diverged(const std::vector<Packed>& array, const PackedIndexSet<Real, width>& group,
                  std::uint32_t begin, std::uint32_t end) {
  typename PackMask<Real, width>::Lanes diverged{};
  for_each_whole(group, begin, end, [&](std::uint32_t first, std::uint32_t last) {
    for (std::uint32_t pack = first; pack < last; ++pack)
      diverged |= (!is_finite(array[pack])).lanes;
  });
  for_each_part(group, begin, end, [&](std::uint32_t pack, const auto& members) {
    diverged |= (members && !is_finite(array[pack])).lanes;
  });
  for (int lane = 0; lane < width; ++lane)
    if (diverged[lane]) return true;
  return false;
}

}  // namespace tumble
