/// @file
/// An effect that acts on packs of bodies, and a turning rule for packs.
#pragma once

#include <span>
#include <tumble/any_effect.hpp>
#include <tumble/packed_visits.hpp>
#include <tumble/rule.hpp>

namespace tumble {

/// An effect of any type that can visit packs. Each body gets the bits that AnyEffect::run() would
/// have given it.
template <class Real, int width>
class PackedEffect {
 public:
  virtual ~PackedEffect() = default;
  /// Runs the effect's function on those bodies of the group that lie in the packs from `begin` to
  /// before `end`; on all pairs if it joins two.
  virtual void run_on_packs(PackedBodies<Real, width>& bodies, const Visits& visits,
                            const PackedIndexSet<Real, width>& packs, std::uint32_t begin,
                            std::uint32_t end, const StepTime<Real>& moment) const = 0;
  /// The pairs that it joins, of an effect on two: those that it visits or, put into `found`, those
  /// that it finds.
  virtual std::span<const BodyPair> pairs(const PackedBodies<Real, width>& bodies,
                                          const Visits& visits,
                                          std::vector<BodyPair>& found) const = 0;
  /// What an effect of the force phase gives to each of these pairs, without giving it to them.
  virtual void find_pushes(const PackedBodies<Real, width>& bodies, std::span<const BodyPair> pairs,
                           std::span<PairPush<Real>> pushes, Real time) const = 0;
};

/// The effect with each of its numbers `width` times over. An effect of the user's that has no
/// broadcast() stays as it is, and visits the lanes one by one.
//! [broadcast]
template <class Real, int width, class Effect>
auto broadcast(const Effect& effect) {
  if constexpr (requires { effect.template broadcast<Pack<Real, width>>(); })
    return effect.template broadcast<Pack<Real, width>>();
  else
    return effect;
}
//! [broadcast]

/// @cond the base classes say what it does
/// PackedEffect for one type of effect.
template <class Real, int width, class Effect>
class PackedEffectOf final : public EffectOf<Real, Effect>, public PackedEffect<Real, width> {
  using Packed = Pack<Real, width>;
  using Kernel = decltype(broadcast<Real, width>(std::declval<const Effect&>()));
  static constexpr bool is_widened = !std::is_same_v<Kernel, Effect>;
  static constexpr Sees sees = form_of<Effect, Real>().sees;

 public:
  explicit PackedEffectOf(const Effect& effect)
      : EffectOf<Real, Effect>(effect), kernel_(broadcast<Real, width>(effect)) {}

  void run_on_packs(PackedBodies<Real, width>& bodies, const Visits& visits,
                    const PackedIndexSet<Real, width>& packs, std::uint32_t begin,
                    std::uint32_t end, const StepTime<Real>& moment) const override {
    if constexpr (sees == Sees::pair) {
      std::vector<BodyPair> found;
      for (const BodyPair& pair : pairs(bodies, visits, found)) run_on_pair(bodies, pair, moment);
    } else if constexpr (sees == Sees::body) {
      const bool changes_tops =
          this->traits().writes.has_any(quantity::torque | quantity::spin | quantity::orientation);
      visit_bodies(
          bodies, packs, begin, end, changes_tops,
          [&](Particle<Packed>& centre, Top<Packed>& top, [[maybe_unused]] const auto& members) {
            if constexpr (is_widened)
              visit(kernel_, centre, top, StepTime<Packed>{moment.time, moment.time_step});
            else
              visit_lanes(centre, top, members, moment);
          });
    } else {
      auto& array = [&]() -> auto& {
        if constexpr (sees == Sees::centre)
          return bodies.centres;
        else
          return bodies.tops;
      }
      ();
      if constexpr (is_widened)
        visit_packs(array, packs, begin, end,
                    [kernel = kernel_, wide = StepTime<Packed>{moment.time, moment.time_step}](
                        auto& element) { visit(kernel, element, wide); });
      else
        visit_lanes_of(array, packs, begin, end,
                       [&](auto& element) { visit(kernel_, element, moment); });
    }
  }

  std::span<const BodyPair> pairs([[maybe_unused]] const PackedBodies<Real, width>& bodies,
                                  const Visits& visits,
                                  [[maybe_unused]] std::vector<BodyPair>& found) const override {
    if constexpr (FindsPairs<Effect, Real>) {
      found.clear();
      this->effect().find_pairs(unpacked(bodies), found);
      return found;
    }
    return visits.pairs;
  }

  void find_pushes([[maybe_unused]] const PackedBodies<Real, width>& bodies,
                   [[maybe_unused]] std::span<const BodyPair> pairs,
                   [[maybe_unused]] std::span<PairPush<Real>> pushes,
                   [[maybe_unused]] Real time) const override {
    if constexpr (PushBetween<Effect, Real>)
      for (std::size_t n = 0; n < pairs.size(); ++n) {
        const RigidBody<Real> first = body_at(bodies, pairs[n].first);
        const RigidBody<Real> second = body_at(bodies, pairs[n].second);
        pushes[n] =
            this->effect().push({first.centre, first.top}, {second.centre, second.top}, time);
      }
  }

 private:
  void visit_lanes(Particle<Packed>& centre, Top<Packed>& top, const PackMask<Real, width>& members,
                   const StepTime<Real>& moment) const {
    for (int lane = 0; lane < width; ++lane) {
      if (!members[lane]) continue;
      Particle<Real> one = lane_of(centre, lane);
      Top<Real> its_top = lane_of(top, lane);
      visit(this->effect(), one, its_top, moment);
      set_lane(centre, lane, one);
      set_lane(top, lane, its_top);
    }
  }

  void run_on_pair(PackedBodies<Real, width>& bodies, const BodyPair& pair,
                   const StepTime<Real>& moment) const {
    RigidBody<Real> first = body_at(bodies, pair.first), second = body_at(bodies, pair.second);
    visit<Effect, Real>(this->effect(), {first.centre, first.top}, {second.centre, second.top},
                        moment);
    set_body_at(bodies, pair.first, first);
    set_body_at(bodies, pair.second, second);
  }

  Kernel kernel_;
};

/// A rule that turns packs of tops, where it takes them; else their lanes.
template <class Real, int width>
class PackedRule {
 public:
  virtual ~PackedRule() = default;
  virtual void turn_packs(PackedArray<Top, Real, width>& tops,
                          const PackedIndexSet<Real, width>& packs, std::uint32_t begin,
                          std::uint32_t end, Real time_step) const = 0;
};

template <class Real, int width, class Rule>
class PackedRuleOf final : public RuleOf<Real, Rule>, public PackedRule<Real, width> {
 public:
  using RuleOf<Real, Rule>::RuleOf;
  void turn_packs(PackedArray<Top, Real, width>& tops, const PackedIndexSet<Real, width>& packs,
                  std::uint32_t begin, std::uint32_t end, Real time_step) const override {
    if constexpr (TurningRule<Rule, Pack<Real, width>>)
      visit_packs(
          tops, packs, begin, end,
          [rule = this->rule(), h = Pack<Real, width>(time_step)](auto& top) { rule(top, h); });
    else
      visit_lanes_of(tops, packs, begin, end,
                     [&](Top<Real>& top) { this->rule()(top, time_step); });
  }
};
/// @endcond

}  // namespace tumble
