/// @file
/// Effects that see centre and top, or join two bodies, on several threads.
#pragma once

#include <tumble/packed_state.hpp>
#include <tumble/thread_pool.hpp>

namespace tumble {

/// Adds what pairs give to those bodies whose centres, and to those whose tops, lie in the share of
/// one thread. Each sum grows in the order of the pairs.
//! [add_pushes]
template <class Real, int width>
[[gnu::flatten]] void add_pushes(PackedBodies<Real, width>& bodies, std::span<const BodyPair> pairs,
                                 std::span<const PairPush<Real>> pushes, int thread, int threads) {
  const auto is_mine = [&](std::size_t pack, std::size_t count) {
    return share_of(count, thread, threads) <= pack && pack < share_of(count, thread + 1, threads);
  };
  const auto add = [&](BodyIndex body, const Push<Real>& push) {
    auto& centres = bodies.centres.packs();
    if (is_mine(body / width, centres.size())) {
      Particle<Real> centre = bodies.centres[body];
      Top<Real> none;
      add_push(centre, none, push);
      set_lane(centres[body / width].force, static_cast<int>(body % width), centre.force);
    }
    auto& tops = bodies.tops.packs();
    const BodyIndex top_index = bodies.top_of[body];
    if (top_index != no_index && is_mine(top_index / width, tops.size())) {
      Particle<Real> none;
      Top<Real> top = bodies.tops[top_index];
      add_push(none, top, push);
      set_lane(tops[top_index / width].torque, static_cast<int>(top_index % width), top.torque);
    }
  };
  for (std::size_t n = 0; n < pairs.size(); ++n) {
    const PairPush<Real>& push = pushes[n];
    add(pairs[n].first, {push.force_on_first, push.torque_on_first});
    add(pairs[n].second, {-push.force_on_first, push.torque_on_second});
  }
}
//! [add_pushes]

/// Runs effects that see centre and top, or pairs, and keeps their buffers.
template <class Real, int width>
class OnBoth {
 public:
  /// With fewer pairs or bodies than this for each thread, waking one would take longer than doing
  /// its work.
  static constexpr std::size_t smallest_share_of_pairs = 64;

  /// Forces between pairs are found first, each by some thread, and then added, each body's by one
  /// thread. A blow meets the speeds that the blows before it have left: one thread deals them all.
  //! [on_both]
  void run(PackedState<Real, width>& state, const StepPlan<Real>& plan,
           const PackedPass<Real, width>& pass, const StepTime<Real>& step, ThreadPool& pool) {
    if (pool.size() == 1 || !pass.effect) return state.run_on_both(plan, pass, step);
    const EffectInstance<Real>& instance = instance_of(pass, plan);
    const StepTime<Real> at = step_time_of(pass, step);
    const auto threads = static_cast<std::size_t>(pool.size());
    if (!instance.effect->traits().joins_two()) {
      for (const std::vector<std::uint32_t>& packs : pass.apart)
        pool.parallel_for(
            packs.size() * width >= smallest_share_of_pairs * threads, [&](int thread, int of) {
              const std::size_t end = share_of(packs.size(), thread + 1, of);
              for (std::size_t n = share_of(packs.size(), thread, of); n < end; ++n)
                pass.effect->run_on_packs(state.bodies, instance.members, pass.indices, packs[n],
                                          packs[n] + 1, at, {});
            });
    } else if (instance.effect->phase() != Phase::force) {
      state.run_on_both(plan, pass, step);
    } else {
      const std::span<const BodyPair> pairs =
          pass.effect->pairs(state.bodies, instance.members, found_);
      const bool worth_it = pairs.size() >= smallest_share_of_pairs * threads;
      pushes_.resize(pairs.size());
      pool.parallel_for(worth_it, [&](int thread, int of) {
        const std::size_t begin = share_of(pairs.size(), thread, of);
        const std::size_t count = share_of(pairs.size(), thread + 1, of) - begin;
        pass.effect->find_pushes(state.bodies, pairs.subspan(begin, count),
                                 std::span(pushes_).subspan(begin, count), at.time);
      });
      pool.parallel_for(worth_it, [&](int thread, int of) {
        add_pushes<Real, width>(state.bodies, pairs, pushes_, thread, of);
      });
    }
  }
  //! [on_both]

 private:
  std::vector<BodyPair> found_;
  std::vector<PairPush<Real>> pushes_;
};

}  // namespace tumble
