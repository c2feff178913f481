/// @file
/// An effect or a motion that acts on packs of bodies.
#pragma once

#include <span>
#include <tumble/any_effect.hpp>
#include <tumble/packed_visits.hpp>

namespace tumble {

/// An effect of any type that can visit packs. Each body gets the bits that AnyEffect::run() would
/// have given it.
template <class Real, int width>
class PackedEffect {
 public:
  /// Runs the effect's function on those bodies of `packs` that lie in the packs from `begin` to
  /// before `end`; on all pairs if it joins two. `act` says which part of its work a rotor does.
  virtual void run_on_packs(PackedBodies<Real, width>& bodies, const Members& members,
                            const PackedIndexSet<Real, width>& packs, std::uint32_t begin,
                            std::uint32_t end, const StepTime<Real>& at, RotorAct act) const = 0;
  /// The pairs that it joins, of an effect on two: those that it visits or, put into `found`, those
  /// that it finds.
  virtual std::span<const BodyPair> pairs(const PackedBodies<Real, width>& bodies,
                                          const Members& members,
                                          std::vector<BodyPair>& found) const = 0;
  /// What an effect of the force phase gives to each of these pairs, without giving it to them.
  virtual void find_pushes(const PackedBodies<Real, width>& bodies, std::span<const BodyPair> pairs,
                           std::span<PairPush<Real>> pushes, Real time) const = 0;

 protected:
  ~PackedEffect() = default;  // the world owns it as an AnyEffect
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
  using Broadcast = decltype(broadcast<Real, width>(std::declval<const Effect&>()));
  static constexpr bool takes_packs = !std::is_same_v<Broadcast, Effect> ||
                                      MovesInPlace<Effect, Particle<Packed>, Packed> ||
                                      MovesInPlace<Effect, Top<Packed>, Packed>;
  static constexpr Sees sees = form_of<Effect, Real>().sees;

 public:
  explicit PackedEffectOf(const Effect& effect)
      : EffectOf<Real, Effect>(effect), broadcast_(broadcast<Real, width>(effect)) {}

  void run_on_packs(PackedBodies<Real, width>& bodies, const Members& members,
                    const PackedIndexSet<Real, width>& packs, std::uint32_t begin,
                    std::uint32_t end, const StepTime<Real>& at,
                    [[maybe_unused]] RotorAct act) const override {
    if constexpr (HoldsRotor<Effect, Real>) {
      const Vec3<Packed> H =
          this->effect().rotor_angular_momentum_body(at.time).template cast<Packed>();
      visit_packs(bodies.tops, packs, begin, end, [H, act, h = Packed(at.time_step)](auto& top) {
        act_on<Packed>(top, act, H, h);
      });
    } else if constexpr (sees == Sees::pair) {
      std::vector<BodyPair> found;
      for (const BodyPair& pair : pairs(bodies, members, found)) run_on_pair(bodies, pair, at);
    } else if constexpr (sees == Sees::body) {
      const bool changes_tops =
          this->traits().writes.has_any(quantity::torque | quantity::spin | quantity::orientation);
      visit_bodies(
          bodies, packs, begin, end, changes_tops,
          [&](Particle<Packed>& centre, Top<Packed>& top, [[maybe_unused]] const auto& mask) {
            if constexpr (takes_packs)
              give_to_both(centre, top, broadcast_, StepTime<Packed>{at.time, at.time_step});
            else
              visit_lanes(centre, top, mask, at);
          });
    } else {
      auto& array = [&]() -> auto& {
        if constexpr (sees == Sees::centre)
          return bodies.centres;
        else
          return bodies.tops;
      }
      ();
      if constexpr (takes_packs)
        visit_packs(array, packs, begin, end,
                    [own = broadcast_, wide = StepTime<Packed>{at.time, at.time_step}](
                        auto& element) { give_to(element, own, element, wide); });
      else
        visit_lanes_of(array, packs, begin, end,
                       [&](auto& element) { give_to(element, broadcast_, element, at); });
    }
  }

  std::span<const BodyPair> pairs([[maybe_unused]] const PackedBodies<Real, width>& bodies,
                                  const Members& members,
                                  [[maybe_unused]] std::vector<BodyPair>& found) const override {
    if constexpr (FindsPairs<Effect, Real>) {
      found.clear();
      if constexpr (requires { this->effect().find_pairs(bodies, found); })
        this->effect().find_pairs(bodies, found);
      else
        this->effect().find_pairs(unpacked(bodies), found);
      return found;
    }
    return members.pairs;
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

  std::shared_ptr<const AnyEffect<Real>> prepared(Real time_step) const override {
    return prepared_as<PackedEffectOf>(this->effect(), time_step);
  }

 private:
  void visit_lanes(Particle<Packed>& centre, Top<Packed>& top, const PackMask<Real, width>& mask,
                   const StepTime<Real>& at) const {
    for (int lane = 0; lane < width; ++lane) {
      if (!mask[lane]) continue;
      Particle<Real> one = lane_of(centre, lane);
      Top<Real> its_top = lane_of(top, lane);
      give_to_both(one, its_top, this->effect(), at);
      set_lane(centre, lane, one);
      set_lane(top, lane, its_top);
    }
  }

  void run_on_pair(PackedBodies<Real, width>& bodies, const BodyPair& pair,
                   const StepTime<Real>& at) const {
    RigidBody<Real> first = body_at(bodies, pair.first), second = body_at(bodies, pair.second);
    give_to_pair<Real>({first.centre, first.top}, {second.centre, second.top}, this->effect(), at);
    set_body_at(bodies, pair.first, first);
    set_body_at(bodies, pair.second, second);
  }

  Broadcast broadcast_;
};

/// @endcond

}  // namespace tumble
