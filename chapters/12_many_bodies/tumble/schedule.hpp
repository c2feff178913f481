/// @file
/// In which order blocks of packs go through the passes of a step.
#pragma once

#include <tumble/guard.hpp>
#include <tumble/pack_colouring.hpp>
#include <tumble/packed_effect.hpp>
#include <tumble/step_order.hpp>

namespace tumble {

/// What is done to each block.
enum class Task { remember, run, guard };

/// A pass of the step, or what comes before and after all of them (see Task), with those that it
/// visits sorted into packs.
template <class Real, int width>
struct PackedPass : Pass<Real> {
  Task task = Task::run;                     ///< what is to be done
  PackedIndexSet<Real, width> indices = {};  ///< for whom
  const PackedEffect<Real, width>* effect =
      nullptr;  ///< its form for packs; null of the inputs and of another task than run
  PackColouring apart = {};  ///< for more threads than one, of an effect that sees centre and top
};

/// Passes that each block of one array can go through from first to last, and the blocks in which
/// any of them has members: by the number of their first pack.
template <class Real, int width>
struct BlockedPasses {
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
  BlockedPasses<Real, width> on_centres, on_tops;
};
//! [stage]

/// The passes of a step, for packs.
template <class Real, int width>
class Schedule {
 public:
  /// A block's particles and tops together are about as large as the smallest cache: 24 kB where a
  /// register has 32 bytes, and twice as much where it has 64.
  static constexpr std::uint32_t packs_in_block = 32;

  /// A plan of another version than this needs another schedule.
  std::uint64_t version = 0;
  std::vector<Stage<Real, width>> stages;

  Schedule() = default;
  //! [schedule]
  explicit Schedule(const StepPlan<Real>& plan) : version(plan.version), stages(1) {
    on_all(Task::remember, plan);
    for (const Pass<Real> pass : Passes(plan)) add(pass, plan);
    on_all(Task::guard, plan);
    for (Stage<Real, width>& stage : stages)
      for (BlockedPasses<Real, width>* row : {&stage.on_centres, &stage.on_tops}) find_blocks(*row);
  }
  //! [schedule]

  /// Makes it fit for more threads than one.
  void keep_threads_apart(const PackedBodies<Real, width>& bodies) {
    for (Stage<Real, width>& stage : stages)
      for (PackedPass<Real, width>& pass : stage.on_both)
        if (pass.effect) pass.apart = pack_colouring(pass.indices, bodies);
  }

 private:
  void on_all(Task task, const StepPlan<Real>& plan) {
    if (!plan.moving.empty())
      stages.back().on_centres.passes.push_back(
          {{}, task, packed_index_set<Real, width>(plan.moving)});
    if (!plan.turning.empty())
      stages.back().on_tops.passes.push_back(
          {{}, task, packed_index_set<Real, width>(plan.turning)});
  }

  void add(const Pass<Real>& pass, const StepPlan<Real>& plan) {
    Sees sees = Sees::body;
    PackedPass<Real, width> packed{pass};
    if (pass.row.kind != PassKind::input) {
      const EffectInstance<Real>& instance = instance_of(pass, plan);
      packed.indices = packed_index_set<Real, width>(instance.members.indices);
      packed.effect = dynamic_cast<const PackedEffect<Real, width>*>(instance.effect.get());
      sees = instance.effect->traits().sees;
    }
    if (sees == Sees::centre)
      stages.back().on_centres.passes.push_back(std::move(packed));
    else if (sees == Sees::top)
      stages.back().on_tops.passes.push_back(std::move(packed));
    else
      stages.emplace_back().on_both.push_back(std::move(packed));
  }

  static void find_blocks(BlockedPasses<Real, width>& row) {
    std::vector<std::uint32_t>& blocks = row.blocks;
    for (const PackedPass<Real, width>& pass : row.passes) {
      const std::size_t known = blocks.size();
      const auto add_block = [&](std::uint32_t pack) {
        const std::uint32_t first = pack / packs_in_block * packs_in_block;
        if (blocks.size() == known || blocks.back() != first) blocks.push_back(first);
      };
      for (const WholePacks& packs : pass.indices.whole)
        for (std::uint32_t pack = packs.begin / packs_in_block * packs_in_block; pack < packs.end;
             pack += packs_in_block)
          add_block(pack);
      for (const auto& part : pass.indices.parts) add_block(part.pack);
    }
    std::sort(blocks.begin(), blocks.end());
    blocks.erase(std::unique(blocks.begin(), blocks.end()), blocks.end());
  }
};

}  // namespace tumble
