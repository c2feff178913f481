/// @file
/// An effect that acts on packs of bodies.
#pragma once

#include <tumble/pack_group.hpp>
#include <tumble/packed_bodies.hpp>

namespace tumble {

/// An effect of any type that can visit packs. What it makes of a body has the bits that
/// AnyEffect::act() would have given it.
template <class Real, int width>
class PackedEffect {
 public:
  virtual ~PackedEffect() = default;
  /// Runs the kernel on those bodies of the pass that lie in the packs from `begin` to before
  /// `end`; on all of them if the effect joins two.
  virtual void act_on_packs(PackedBodies<Real, width>& bodies, const Group& group,
                            const PackGroup<Real, width>& packs, std::uint32_t begin,
                            std::uint32_t end, const Moment<Real>& moment) const = 0;
  /// The effect sees more of a body than its centre alone or its top alone.
  virtual bool sees_both() const = 0;
};

/// The effect with every number of its own `width` times over. One of the user's that can't be had
/// so stays as it is, and visits the lanes one by one.
//! [widened]
template <class Real, int width, class Effect>
auto widened(const Effect& effect) {
  if constexpr (requires { effect.template widened<Pack<Real, width>>(); })
    return effect.template widened<Pack<Real, width>>();
  else
    return effect;
}
//! [widened]

/// Takes over from `changed` what a kernel can change, where the body is a member.
template <class Real, int width>
void take_over(Particle<Pack<Real, width>>& pack, const Particle<Pack<Real, width>>& changed,
               const PackMask<Real, width>& members) {
  for (int axis = 0; axis < 3; ++axis) {
    pack.position[axis] = select(members, changed.position[axis], pack.position[axis]);
    pack.velocity[axis] = select(members, changed.velocity[axis], pack.velocity[axis]);
    pack.force[axis] = select(members, changed.force[axis], pack.force[axis]);
  }
}

template <class Real, int width>
void take_over(Top<Pack<Real, width>>& pack, const Top<Pack<Real, width>>& changed,
               const PackMask<Real, width>& members) {
  Quaternion<Pack<Real, width>>& q = pack.orientation;
  Vec3<Pack<Real, width>>& L = pack.angular_momentum_body;
  q.real = select(members, changed.orientation.real, q.real);
  for (int axis = 0; axis < 3; ++axis) {
    q.imaginary[axis] = select(members, changed.orientation.imaginary[axis], q.imaginary[axis]);
    L[axis] = select(members, changed.angular_momentum_body[axis], L[axis]);
    pack.torque[axis] = select(members, changed.torque[axis], pack.torque[axis]);
  }
}

/// The tops of the bodies of a pack, side by side; a point shows one that can't turn.
template <class Real, int width>
Top<Pack<Real, width>> tops_of(const PackedBodies<Real, width>& bodies, std::uint32_t pack) {
  const std::size_t first = std::size_t{pack} * width;
  const std::size_t last = std::min(first + width, bodies.centres.size());
  const BodyIndex top = bodies.top_of[first];
  bool side_by_side = top != no_index && top % width == 0;
  for (std::size_t body = first; body < last; ++body)
    side_by_side = side_by_side && bodies.top_of[body] == top + (body - first);
  if (side_by_side) return bodies.tops.packs()[top / width];
  Top<Pack<Real, width>> tops;
  for (std::size_t body = first; body < last; ++body)
    if (const BodyIndex one = bodies.top_of[body]; one != no_index)
      set_lane(tops, static_cast<int>(body - first), bodies.tops[one]);
  return tops;
}

/// @cond the base classes say what it does
/// PackedEffect for one type of effect.
template <class Real, int width, class Effect>
class PackedEffectOf final : public EffectOf<Real, Effect>, public PackedEffect<Real, width> {
  using Packed = Pack<Real, width>;
  using Kernel = decltype(widened<Real, width>(std::declval<const Effect&>()));
  static constexpr bool is_widened = !std::is_same_v<Kernel, Effect>;
  static constexpr bool on_centre = ForceOnCentre<Effect, Real> ||
                                    AccelerationOfCentre<Effect, Real> ||
                                    ActsOnCentre<Effect, Real>;
  static constexpr bool on_top = ActsOnTop<Effect, Real> || TorqueOnTop<Effect, Real>;

 public:
  explicit PackedEffectOf(const Effect& effect)
      : EffectOf<Real, Effect>(effect), kernel_(widened<Real, width>(effect)) {}

  bool sees_both() const override { return !on_centre && !on_top; }

  void act_on_packs(PackedBodies<Real, width>& bodies, const Group& group,
                    const PackGroup<Real, width>& packs, std::uint32_t begin, std::uint32_t end,
                    const Moment<Real>& moment) const override {
    if constexpr (PushBetween<Effect, Real>) {
      for (std::size_t i = 0; i < group.members.size(); i += 2)
        push_pair(bodies, group.members[i], group.members[i + 1], moment.time);
    } else if constexpr (on_centre) {
      visit_packs(bodies.centres, packs, begin, end, moment);
    } else if constexpr (on_top) {
      visit_packs(bodies.tops, packs, begin, end, moment);
    } else {
      constexpr PackMask<Real, width> all{~typename PackMask<Real, width>::Lanes{}};
      for_each_whole(packs, begin, end, [&](std::uint32_t first, std::uint32_t last) {
        for (std::uint32_t pack = first; pack < last; ++pack) push(bodies, pack, all, moment.time);
      });
      for_each_part(packs, begin, end, [&](std::uint32_t pack, const auto& members) {
        push(bodies, pack, members, moment.time);
      });
    }
  }

 private:
  /// The loop in which nearly all of the time is spent. The kernel and all that it calls must
  /// become one piece here: a function of its own would hand over its vectors through memory.
  //! [visit_row]
  template <class Packs>
  [[gnu::flatten]] static void visit_row(const Kernel& kernel, Packs* begin, const Packs* end,
                                         const Moment<Packed>& moment) {
    // NOLINTNEXTLINE(performance-unnecessary-copy-initialization): see what stands behind it
    const Kernel own_kernel = kernel;  // nobody else can change these two meanwhile, so that their
    const Moment<Packed> own_moment = moment;  // numbers can stay in registers
    for (Packs* packs = begin; packs != end; ++packs) visit(own_kernel, *packs, own_moment);
  }
  //! [visit_row]

  /// An effect on centres alone, or on tops alone.
  //! [visit_packs]
  template <class Array>
  void visit_packs(Array& array, const PackGroup<Real, width>& group, std::uint32_t begin,
                   std::uint32_t end, const Moment<Real>& moment) const {
    if constexpr (is_widened) {
      const Moment<Packed> wide{moment.time, moment.time_step};
      for_each_whole(group, begin, end, [&](std::uint32_t first, std::uint32_t last) {
        visit_row(kernel_, array.packs().data() + first, array.packs().data() + last, wide);
      });
      for_each_part(group, begin, end, [&](std::uint32_t pack, const auto& members) {
        auto changed = array.packs()[pack];
        visit(kernel_, changed, wide);
        take_over(array.packs()[pack], changed, members);
      });
      //! [visit_packs]
    } else {
      const auto visit_lane = [&](std::uint32_t pack, int lane) {
        auto element = lane_of(array.packs()[pack], lane);
        visit(kernel_, element, moment);
        set_lane(array.packs()[pack], lane, element);
      };
      for_each_whole(group, begin, end, [&](std::uint32_t first, std::uint32_t last) {
        const std::size_t all = std::min(std::size_t{last} * width, array.size());
        for (std::size_t i = std::size_t{first} * width; i < all; ++i)
          visit_lane(static_cast<std::uint32_t>(i / width), static_cast<int>(i % width));
      });
      for_each_part(group, begin, end, [&](std::uint32_t pack, const auto& members) {
        for (int lane = 0; lane < width; ++lane)
          if (members[lane]) visit_lane(pack, lane);
      });
    }
  }

  /// An effect that sees centre and top.
  void push(PackedBodies<Real, width>& bodies, std::uint32_t pack,
            const PackMask<Real, width>& members, Real time) const {
    Particle<Packed>& centre = bodies.centres.packs()[pack];
    const Top<Packed> tops = tops_of(bodies, pack);
    Push<Packed> pushes;
    if constexpr (is_widened) {
      const BodyState<Packed> state{centre, tops};
      if constexpr (ForceOnBody<Effect, Real>)
        pushes.force = kernel_.force(state, time);
      else
        pushes = kernel_.push(state, time);
    } else {
      for (int lane = 0; lane < width; ++lane) {
        if (!members[lane] ||
            std::size_t{pack} * width + static_cast<std::size_t>(lane) >= bodies.centres.size())
          continue;
        const Particle<Real> one = lane_of(centre, lane);
        const Top<Real> top = lane_of(tops, lane);
        const Push<Real> push = this->push_on({one, top}, time);
        set_lane(pushes.force, lane, push.force);
        set_lane(pushes.torque, lane, push.torque);
      }
    }
    for (int axis = 0; axis < 3; ++axis)
      centre.force[axis] =
          select(members, centre.force[axis] + pushes.force[axis], centre.force[axis]);
    if constexpr (PushOnBody<Effect, Real>)
      for (int lane = 0; lane < width; ++lane)
        if (members[lane])
          add_torque(bodies, pack * width + static_cast<BodyIndex>(lane),
                     lane_of(pushes.torque, lane));
  }

  void push_pair(PackedBodies<Real, width>& bodies, BodyIndex first, BodyIndex second,
                 Real time) const {
    const Particle<Real> a = bodies.centres[first], b = bodies.centres[second];
    const Top<Real> top_a = top_at(bodies, first), top_b = top_at(bodies, second);
    const PairPush<Real> push = this->push_on({a, top_a}, {b, top_b}, time);
    add_force(bodies, first, push.force_on_first);
    add_torque(bodies, first, push.torque_on_first);
    add_force(bodies, second, -push.force_on_first);
    add_torque(bodies, second, push.torque_on_second);
  }

  static Top<Real> top_at(const PackedBodies<Real, width>& bodies, BodyIndex body) {
    return is_point(bodies, body) ? Top<Real>{} : bodies.tops[bodies.top_of[body]];
  }

  static void add_lane(Vec3<Packed>& sum, BodyIndex i, const Vec3<Real>& push) {
    for (int axis = 0; axis < 3; ++axis) sum[axis].lanes[i % width] += push[axis];
  }
  static void add_force(PackedBodies<Real, width>& bodies, BodyIndex body,
                        const Vec3<Real>& force) {
    add_lane(bodies.centres.packs()[body / width].force, body, force);
  }
  static void add_torque(PackedBodies<Real, width>& bodies, BodyIndex body,
                         const Vec3<Real>& torque) {
    if (body >= bodies.centres.size() || is_point(bodies, body)) return;
    const BodyIndex top = bodies.top_of[body];
    add_lane(bodies.tops.packs()[top / width].torque, top, torque);
  }

  Kernel kernel_;
};
/// @endcond

}  // namespace tumble
