/// @file
/// Keeps the bodies of a world in packs, and takes each block of them through a step while it is in
/// the cache.
#pragma once

#include <tumble/schedule.hpp>
#include <tumble/thread_team.hpp>
#include <tumble/world.hpp>

namespace tumble {

/// Says how a World keeps its bodies, in place of OneByOne: `width` side by side, stepped by as
/// many threads as one likes. Every bit of the motion stays the same.
template <class Real, int width = natural_width<Real>>
class InPacks {
 public:
  /// After so many steps the bodies are copied, so that a step that fails can be taken back.
  static constexpr std::int64_t steps_to_repeat = 64;
  /// With fewer bodies than this for each thread, to wake one would take longer than to do its
  /// work.
  static constexpr std::size_t smallest_share = 512;

  std::size_t body_count() const { return bodies_.centres.size(); }
  std::size_t top_count() const { return bodies_.tops.size(); }
  bool is_point(BodyIndex body) const { return tumble::is_point(bodies_, body); }
  Bodies<Real> bodies() const { return unpacked(bodies_); }
  void set_bodies(const Bodies<Real>& bodies) {
    bodies_ = packed<Real, width>(bodies);
    past_.reset();
  }
  RigidBody<Real> body(BodyIndex body) const {
    return {.centre = bodies_.centres[body],
            .top = is_point(body) ? Top<Real>{} : bodies_.tops[bodies_.top_of[body]]};
  }
  void set_body(BodyIndex body, const RigidBody<Real>& state) {
    bodies_.centres.set(body, state.centre);
    if (!is_point(body)) bodies_.tops.set(bodies_.top_of[body], state.top);
    if (past_) past_->changes.push_back({next_tick_, body, state});
  }
  BodyIndex append(const Particle<Real>& centre, const Top<Real>* top) {
    past_.reset();
    return tumble::append(bodies_, centre, top);
  }
  void take_out(BodyIndex body) {
    past_.reset();
    tumble::take_out(bodies_, body);
  }

  template <class Effect>
  static std::shared_ptr<const AnyEffect<Real>> erased(const Effect& effect) {
    return std::make_shared<const PackedEffectOf<Real, width, Effect>>(effect);
  }

  void plan_changed(const Planned<Real>& planned) {
    schedule_ = schedule_of<Real, width>(planned, body_count(), top_count());
  }

  /// So many threads take part in each step from now on; without a call, one.
  /// @throws std::invalid_argument if it is not from 1 to 1024; as many as before then do.
  void use_threads(int count) { team_ = ThreadTeam(count); }

  /// See OneByOne::step(). `after_pass` other than Silence makes one pass end before the next
  /// begins, where otherwise a block of bodies goes through many.
  template <class AfterPass>
  std::optional<Stopped<Real>> step(const Planned<Real>& planned, std::int64_t tick, Real time_step,
                                    const AfterPass& after_pass) {
    if (!past_ || tick - past_->tick >= steps_to_repeat) past_ = Past{tick, bodies_, {}};
    next_tick_ = tick + 1;
    const Moment<Real> moment = moment_of(tick, time_step);
    bool lost = false;
    if constexpr (std::is_same_v<AfterPass, Silence>)
      lost = run_in_blocks(planned, moment);
    else
      lost = run_pass_by_pass(planned, moment, after_pass);
    return lost ? take_back(planned, tick, time_step) : std::nullopt;
  }

  /// One pass of the plan alone, to measure what it costs.
  void run_pass(const Planned<Real>& planned, std::size_t pass, const Moment<Real>& moment) {
    for (const Stage<Real, width>& stage : schedule_.stages)
      for (const auto* row : {&stage.on_centres, &stage.on_tops, &stage.on_both})
        for (const PackedPass<Real, width>& candidate : *row)
          if (candidate.pass == pass) act(planned, candidate, 0, no_index, moment);
  }

 private:
  using Packs = PackedBodies<Real, width>;
  /// A block's particles and tops together fit the smallest cache: some 20 kB.
  static constexpr std::uint32_t packs_in_block = 32;

  /// Which part of the packs is one thread's: whole blocks, as many for each as for the others.
  struct Share {
    int member, members;
    std::array<std::uint32_t, 2> of(std::size_t packs) const {
      const std::size_t blocks = (packs + packs_in_block - 1) / packs_in_block;
      const auto begin_of = [&](int m) {
        const std::size_t block =
            blocks * static_cast<std::size_t>(m) / static_cast<std::size_t>(members);
        return static_cast<std::uint32_t>(std::min(block * packs_in_block, packs));
      };
      return {begin_of(member), begin_of(member + 1)};
    }
  };

  /// Where the last steps began: a step is a function of its beginning, so what led here can be
  /// computed again. It costs one copy in so many steps, and not one in each.
  //! [past]
  struct Change {
    std::int64_t tick;
    BodyIndex index;
    RigidBody<Real> body;
  };
  struct Past {
    std::int64_t tick;
    Packs bodies;
    std::vector<Change> changes;  ///< what the user has done since
  };

  /// The world as it was before step number `tick`, and the body that it lost: the steps
  /// since the last copy once more, one body after another.
  std::optional<Stopped<Real>> take_back(const Planned<Real>& planned, std::int64_t tick,
                                         Real time_step) {
    OneByOne<Real> again;
    again.set_bodies(unpacked(past_->bodies));
    std::optional<Stopped<Real>> stopped;
    auto change = past_->changes.begin();
    for (std::int64_t now = past_->tick; now <= tick; ++now) {
      for (; change != past_->changes.end() && change->tick <= now; ++change)
        again.set_body(change->index, change->body);
      stopped = again.step(planned, now, time_step, Silence{});
    }
    set_bodies(again.bodies());
    return stopped;
  }
  //! [past]

  /// The stages one after another. Each thread takes the blocks of its own share one by one through
  /// a whole stage. @return whether a body was led nowhere
  //! [run_in_blocks]
  bool run_in_blocks(const Planned<Real>& planned, const Moment<Real>& moment) {
    std::atomic<bool> lost = false;
    const auto run_share = [&](const auto& passes, const auto& packs, const auto& drifters,
                               Share share) {
      if (passes.empty()) return;
      for (auto [begin, last] = share.of(packs.size()); begin < last; begin += packs_in_block) {
        const std::uint32_t end = std::min(begin + packs_in_block, last);
        for (const PackedPass<Real, width>& pass : passes) act(planned, pass, begin, end, moment);
        if (phase_of(planned, passes.back()) >= Phase::drift &&
            any_lost(packs, drifters, begin, end))
          lost = true;
      }
    };
    for (const Stage<Real, width>& stage : schedule_.stages) {
      for (const PackedPass<Real, width>& pass : stage.on_both)
        act(planned, pass, 0, no_index, moment);
      const auto run_stage = [&](Share share) {
        run_share(stage.on_centres, bodies_.centres.packs(), schedule_.movers, share);
        run_share(stage.on_tops, bodies_.tops.packs(), schedule_.turners, share);
      };
      if (body_count() < smallest_share * static_cast<std::size_t>(team_.size()))
        run_stage({0, 1});
      else
        team_.run([&](int member) { run_stage({member, team_.size()}); });
    }
    return lost;
  }
  //! [run_in_blocks]

  template <class AfterPass>
  bool run_pass_by_pass(const Planned<Real>& planned, const Moment<Real>& moment,
                        const AfterPass& after_pass) {
    for (std::size_t i = 0; i < planned.passes.size(); ++i) {
      run_pass(planned, i, moment);
      after_pass(*planned.passes[i].effect);
    }
    return any_lost(bodies_.centres.packs(), schedule_.movers, 0, no_index) ||
           any_lost(bodies_.tops.packs(), schedule_.turners, 0, no_index);
  }

  static Phase phase_of(const Planned<Real>& planned, const PackedPass<Real, width>& pass) {
    return planned.passes[pass.pass].effect->phase();
  }

  void act(const Planned<Real>& planned, const PackedPass<Real, width>& pass, std::uint32_t begin,
           std::uint32_t end, const Moment<Real>& moment) {
    pass.effect->act_on_packs(bodies_, planned.passes[pass.pass].group, pass.group, begin, end,
                              moment);
  }

  Packs bodies_;
  Schedule<Real, width> schedule_;
  std::optional<Past> past_;
  std::int64_t next_tick_ = 0;
  ThreadTeam team_;
};

/// A world for many bodies: it does what World does, to the bit.
template <class Real>
using ManyBodies = World<Real, InPacks<Real>>;

}  // namespace tumble
