/// @file
/// Keeps the bodies of a world in packs, and takes each block of them through a step while it is in
/// the cache.
#pragma once

#include <tumble/on_both.hpp>
#include <tumble/packed_parts.hpp>
#include <tumble/world.hpp>

namespace tumble {

/// Keeps the bodies of a World, in place of OneByOne: `width` side by side, stepped by as
/// many threads as you ask for. Every bit of the motion stays the same.
template <class Real, int width = natural_width<Real>>
class InPacks final : public BodyStore<Real> {
 public:
  /// With fewer bodies than this for each thread, waking one would take longer than doing its
  /// work.
  static constexpr std::size_t smallest_share = 512;

  /// All bodies, copied out of the packs.
  Bodies<Real> bodies() const { return unpacked(state_.bodies); }
  /// Other bodies in their place.
  void set_bodies(const Bodies<Real>& bodies) { state_.bodies = packed<Real, width>(bodies); }

  const BodyMap& map() const override { return state_.bodies; }
  RigidBody<Real> body(BodyIndex body) const override { return body_at(state_.bodies, body); }
  void set_body(BodyIndex body, const RigidBody<Real>& state) override {
    set_body_at(state_.bodies, body, state);
  }
  void append(const Particle<Real>& centre, const Top<Real>* top) override {
    tumble::append(state_.bodies, centre, top);
  }
  void take_out(BodyIndex body) override { tumble::take_out(state_.bodies, body); }

  /// The form in which its steps run an effect or a motion.
  template <class Effect>
  static std::shared_ptr<const AnyEffect<Real>> erased(const Effect& effect) {
    return shared_as<PackedEffectOf<Real, width, Effect>, Real>(effect);
  }

  /// See World::use_threads().
  void use_threads(int count) {
    pool_ = ThreadPool(count);
    schedule_ = {};  // for several threads it knows more than for one
  }

  /// See OneByOne::step(). The stages one after another; each thread takes the blocks of its own
  /// share one by one through a whole stage.
  //! [step]
  std::optional<BodyIndex> step(const StepPlan<Real>& plan, const StepTime<Real>& at) {
    prepare(plan);
    std::atomic<bool> diverged = false;
    try {
      for (const Stage<Real, width>& stage : schedule_.stages) {
        for (const PackedPass<Real, width>& pass : stage.on_both)
          on_both_.run(state_, plan, pass, at, pool_);
        pool_.parallel_for(!is_small(stage), [&](int thread, int threads) {
          std::exception_ptr thrown;
          const bool centres = run_blocks(plan, stage.on_centres, state_.bodies.centres, at, thread,
                                          threads, thrown);
          const bool tops =
              run_blocks(plan, stage.on_tops, state_.bodies.tops, at, thread, threads, thrown);
          if (thrown) std::rethrow_exception(thrown);
          if (centres || tops) diverged = true;
        });
      }
    } catch (...) {  // an effect has thrown
      state_.restore(plan);
      throw;
    }
    if (!diverged) return std::nullopt;
    const std::optional<BodyIndex> body = first_diverged<Real>(state_.bodies, plan);
    state_.restore(plan);
    return body;
  }
  //! [step]

  /// What a step consists of; and one part alone, to measure what it costs.
  std::vector<PackedPart> parts(const StepPlan<Real>& plan) {
    std::vector<PackedPart> parts;
    for_each_pass(
        plan, [&](const PackedPass<Real, width>& pass, bool of_tops, const Stage<Real, width>&) {
          parts.push_back(packed_part_of(plan, pass, of_tops));
        });
    return parts;
  }
  void run_part(const StepPlan<Real>& plan, std::size_t part, const StepTime<Real>& at) {
    std::size_t n = 0;
    for_each_pass(plan, [&](const PackedPass<Real, width>& pass, bool of_tops,
                            const Stage<Real, width>& stage) {
      if (n++ != part) return;
      if (!stage.on_both.empty() && &pass == &stage.on_both[0])
        state_.run_on_both(plan, pass, at);
      else if (of_tops)
        state_.run_task(plan, pass, state_.bodies.tops, 0, no_index, at);
      else
        state_.run_task(plan, pass, state_.bodies.centres, 0, no_index, at);
    });
  }

 private:
  static constexpr std::uint32_t packs_in_block = Schedule<Real, width>::packs_in_block;

  void prepare(const StepPlan<Real>& plan) {
    if (schedule_.version == plan.version) return;
    schedule_ = Schedule<Real, width>(plan);
    if (pool_.size() > 1) schedule_.keep_threads_apart(state_.bodies);
    state_.undo.resize(state_.bodies.centres.packs().size(), state_.bodies.tops.packs().size());
  }

  bool is_small(const Stage<Real, width>& stage) const {
    const auto bodies_in = [](const auto& row, const auto& array) {
      return std::min(row.blocks.size() * packs_in_block * width, array.size());
    };
    return std::max(bodies_in(stage.on_centres, state_.bodies.centres),
                    bodies_in(stage.on_tops, state_.bodies.tops)) <
           smallest_share * static_cast<std::size_t>(pool_.size());
  }

  /// One thread's share of the blocks of a row. Once an effect has `thrown`, the blocks to come are
  /// remembered and not stepped, so that all can be put back. @return whether a
  /// body diverged
  //! [run_blocks]
  template <class Array>
  bool run_blocks(const StepPlan<Real>& plan, const BlockedPasses<Real, width>& row, Array& array,
                  const StepTime<Real>& at, int thread, int threads, std::exception_ptr& thrown) {
    const std::size_t end = share_of(row.blocks.size(), thread + 1, threads);
    bool diverged = false;
    for (std::size_t n = share_of(row.blocks.size(), thread, threads); n < end; ++n)
      for (const PackedPass<Real, width>& pass : row.passes) {
        if (thrown && pass.task != Task::remember) continue;
        const std::uint32_t begin = row.blocks[n];
        try {
          diverged |= state_.run_task(plan, pass, array, begin, begin + packs_in_block, at);
        } catch (...) {
          thrown = std::current_exception();
        }
      }
    return diverged;
  }
  //! [run_blocks]

  template <class Visit>
  void for_each_pass(const StepPlan<Real>& plan, const Visit& visit) {
    prepare(plan);
    for (const Stage<Real, width>& stage : schedule_.stages) {
      for (const PackedPass<Real, width>& pass : stage.on_both) visit(pass, false, stage);
      for (const PackedPass<Real, width>& pass : stage.on_centres.passes) visit(pass, false, stage);
      for (const PackedPass<Real, width>& pass : stage.on_tops.passes) visit(pass, true, stage);
    }
  }

  PackedState<Real, width> state_;
  OnBoth<Real, width> on_both_;
  Schedule<Real, width> schedule_;
  ThreadPool pool_;
};

/// A world for many bodies: it does what World does, to the bit.
template <class Real>
using ManyBodies = World<Real, InPacks<Real>>;

}  // namespace tumble

#ifdef TUMBLE_COMPILED_MANY_BODIES  // inside the course alone
#include <support/compiled_many_bodies.hpp>
#endif
