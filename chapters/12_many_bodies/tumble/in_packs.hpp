/// @file
/// Keeps the bodies of a world in packs, and takes each block of them through a step while it is in
/// the cache.
#pragma once

#include <tumble/on_both.hpp>
#include <tumble/packed_parts.hpp>
#include <tumble/world.hpp>

namespace tumble {

/// Says how a World keeps its bodies, in place of OneByOne: `width` side by side, stepped by as
/// many threads as you ask for. Every bit of the motion stays the same.
template <class Real, int width = natural_width<Real>>
class InPacks final : public BodyStore<Real> {
 public:
  /// With fewer bodies than this for each thread, waking one would take longer than doing its
  /// work.
  static constexpr std::size_t smallest_share = 512;

  Bodies<Real> bodies() const { return unpacked(acts_.bodies); }
  void set_bodies(const Bodies<Real>& bodies) { acts_.bodies = packed<Real, width>(bodies); }

  const BodyMap& map() const override { return acts_.bodies; }
  RigidBody<Real> body(BodyIndex body) const override { return body_at(acts_.bodies, body); }
  void set_body(BodyIndex body, const RigidBody<Real>& state) override {
    set_body_at(acts_.bodies, body, state);
  }
  void append(const Particle<Real>& centre, const Top<Real>* top) override {
    tumble::append(acts_.bodies, centre, top);
  }
  void take_out(BodyIndex body) override { tumble::take_out(acts_.bodies, body); }

  /// The form in which its steps run an effect or a rule.
  template <class Effect>
  static std::shared_ptr<const AnyEffect<Real>> erased(const Effect& effect) {
    return std::make_shared<const PackedEffectOf<Real, width, Effect>>(effect);
  }
  template <class Rule>
  static std::shared_ptr<const AnyRule<Real>> erased_rule(const Rule& rule) {
    return std::make_shared<const PackedRuleOf<Real, width, Rule>>(rule);
  }

  /// So many threads take part in each step from now on; without a call, one.
  /// @throws std::invalid_argument if it is not from 1 to 1024; as many as before then do.
  void use_threads(int count) {
    pool_ = ThreadPool(count);
    schedule_ = {};  // for several threads it knows more than for one
  }

  /// See OneByOne::step(). The stages one after another; each thread takes the blocks of its own
  /// share one by one through a whole stage.
  //! [step]
  std::optional<BodyIndex> step(const Work<Real>& work, const StepTime<Real>& moment) {
    prepare(work);
    std::atomic<bool> diverged = false;
    try {
      for (const Stage<Real, width>& stage : schedule_.stages) {
        for (const Pass& pass : stage.on_both) on_both_.run(acts_, work, pass, moment, pool_);
        pool_.parallel_for(!is_small(stage), [&](int member, int members) {
          std::exception_ptr thrown;
          const bool centres = run_row(work, stage.on_centres, acts_.bodies.centres, moment, member,
                                       members, thrown);
          const bool tops =
              run_row(work, stage.on_tops, acts_.bodies.tops, moment, member, members, thrown);
          if (thrown) std::rethrow_exception(thrown);
          if (centres || tops) diverged = true;
        });
      }
    } catch (...) {  // an effect has thrown
      (void)acts_.rolled_back(work);
      throw;
    }
    return diverged ? acts_.rolled_back(work) : std::nullopt;
  }
  //! [step]

  /// What a step consists of; and one part alone, to measure what it costs.
  std::vector<PackedPart> parts(const Work<Real>& work) {
    std::vector<PackedPart> parts;
    for_each_pass(work, [&](const Pass& pass, bool of_tops, const Stage<Real, width>&) {
      parts.push_back(packed_part_of(work, pass, of_tops));
    });
    return parts;
  }
  void run_part(const Work<Real>& work, std::size_t part, const StepTime<Real>& moment) {
    std::size_t n = 0;
    for_each_pass(work, [&](const Pass& pass, bool of_tops, const Stage<Real, width>& stage) {
      if (n++ != part) return;
      if (!stage.on_both.empty() && &pass == &stage.on_both[0])
        acts_.act_on_both(work, pass, moment);
      else if (of_tops)
        acts_.act(work, pass, acts_.bodies.tops, 0, no_index, moment);
      else
        acts_.act(work, pass, acts_.bodies.centres, 0, no_index, moment);
    });
  }

 private:
  using Pass = PackedPass<Real, width>;
  static constexpr std::uint32_t packs_in_block = Schedule<Real, width>::packs_in_block;

  void prepare(const Work<Real>& work) {
    if (schedule_.version == work.version) return;
    schedule_ = Schedule<Real, width>(work);
    if (pool_.size() > 1) schedule_.keep_threads_apart(acts_.bodies);
    acts_.undo.resize(acts_.bodies.centres.packs().size(), acts_.bodies.tops.packs().size());
  }

  bool is_small(const Stage<Real, width>& stage) const {
    const auto bodies_in = [](const auto& row, const auto& array) {
      return std::min(row.blocks.size() * packs_in_block * width, array.size());
    };
    return std::max(bodies_in(stage.on_centres, acts_.bodies.centres),
                    bodies_in(stage.on_tops, acts_.bodies.tops)) <
           smallest_share * static_cast<std::size_t>(pool_.size());
  }

  /// One thread's share of the blocks of a row. Once an effect has `thrown`, the blocks to come are
  /// remembered and not stepped, so that all can be put back. @return whether a body was led
  /// nowhere
  //! [run_row]
  template <class Array>
  bool run_row(const Work<Real>& work, const Row<Real, width>& row, Array& array,
               const StepTime<Real>& moment, int member, int members, std::exception_ptr& thrown) {
    const std::size_t end = share_of(row.blocks.size(), member + 1, members);
    bool diverged = false;
    for (std::size_t n = share_of(row.blocks.size(), member, members); n < end; ++n)
      for (const Pass& pass : row.passes) {
        if (thrown && pass.act != Act::remember) continue;
        const std::uint32_t begin = row.blocks[n];
        try {
          diverged |= acts_.act(work, pass, array, begin, begin + packs_in_block, moment);
        } catch (...) {
          thrown = std::current_exception();
        }
      }
    return diverged;
  }
  //! [run_row]

  template <class Visit>
  void for_each_pass(const Work<Real>& work, const Visit& visit) {
    prepare(work);
    for (const Stage<Real, width>& stage : schedule_.stages) {
      for (const Pass& pass : stage.on_both) visit(pass, false, stage);
      for (const Pass& pass : stage.on_centres.passes) visit(pass, false, stage);
      for (const Pass& pass : stage.on_tops.passes) visit(pass, true, stage);
    }
  }

  PackedActs<Real, width> acts_;
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
