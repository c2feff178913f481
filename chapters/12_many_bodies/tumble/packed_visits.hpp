/// @file
/// Loops over the packs in which an effect has members.
#pragma once

#include <tumble/packed_bodies.hpp>
#include <tumble/packed_index_set.hpp>

namespace tumble {

/// Takes from `changed` what a step can change, in the lanes of the members.
template <class Real, int width>
void blend(Particle<Pack<Real, width>>& pack, const Particle<Pack<Real, width>>& changed,
           const PackMask<Real, width>& members) {
  for (int axis = 0; axis < 3; ++axis) {
    pack.position[axis] = select(members, changed.position[axis], pack.position[axis]);
    pack.velocity[axis] = select(members, changed.velocity[axis], pack.velocity[axis]);
    pack.force[axis] = select(members, changed.force[axis], pack.force[axis]);
  }
}

template <class Real, int width>
void blend(Top<Pack<Real, width>>& pack, const Top<Pack<Real, width>>& changed,
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

/// The loop in which nearly all of the time is spent. The kernel and all that it calls must be
/// inlined here: a function of its own would be handed its vectors through memory.
//! [visit_whole]
template <class Packs, class Kernel>
[[gnu::flatten]] void visit_whole(const Kernel& kernel, Packs* begin, const Packs* end) {
  // NOLINTNEXTLINE(performance-unnecessary-copy-initialization): the copy is wanted
  const Kernel own_kernel = kernel;  // nobody else can change it meanwhile: it stays in registers
  for (Packs* packs = begin; packs != end; ++packs) own_kernel(*packs);
}
//! [visit_whole]

/// The same for a pack of which some are members.
template <class Packed, class Kernel, class Members>
[[gnu::flatten]] void visit_part(const Kernel& kernel, Packed& pack, const Members& members) {
  Packed changed = pack;
  kernel(changed);
  blend(pack, changed, members);
}

/// Calls `kernel` with each pack of `array`, between `begin` and `end`, that has members.
//! [visit_packs]
template <class Array, class Real, int width, class Kernel>
void visit_packs(Array& array, const PackedIndexSet<Real, width>& indices, std::uint32_t begin,
                 std::uint32_t end, const Kernel& kernel) {
  for_each_whole(indices, begin, end, [&](std::uint32_t first, std::uint32_t last) {
    visit_whole(kernel, array.packs().data() + first, array.packs().data() + last);
  });
  for_each_part(indices, begin, end, [&](std::uint32_t pack, const auto& members) {
    visit_part(kernel, array.packs()[pack], members);
  });
}
//! [visit_packs]

/// Calls `kernel` with one member after another.
template <class Array, class Real, int width, class Kernel>
void visit_lanes_of(Array& array, const PackedIndexSet<Real, width>& indices, std::uint32_t begin,
                    std::uint32_t end, const Kernel& kernel) {
  for_each_pack(indices, begin, end, [&](std::uint32_t pack, const auto& members) {
    for (int lane = 0; lane < width; ++lane) {
      if (!members[lane]) continue;
      auto element = lane_of(array.packs()[pack], lane);
      kernel(element);
      set_lane(array.packs()[pack], lane, element);
    }
  });
}

/// The tops of the bodies of a pack, side by side; of a point, one locked about every axis.
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

/// Calls `kernel` with the centres and the tops of each pack of bodies that has members.
template <class Real, int width, class Kernel>
void visit_bodies(PackedBodies<Real, width>& bodies, const PackedIndexSet<Real, width>& indices,
                  std::uint32_t begin, std::uint32_t end, bool changes_tops, const Kernel& kernel) {
  for_each_pack(indices, begin, end, [&](std::uint32_t pack, const auto& members) {
    auto changed = bodies.centres.packs()[pack];
    auto tops = tops_of(bodies, pack);
    kernel(changed, tops, members);
    blend(bodies.centres.packs()[pack], changed, members);
    if (!changes_tops) return;
    for (int lane = 0; lane < width; ++lane) {
      if (!members[lane]) continue;
      const BodyIndex top = bodies.top_of[pack * width + static_cast<BodyIndex>(lane)];
      if (top != no_index) bodies.tops.set(top, lane_of(tops, lane));
    }
  });
}

}  // namespace tumble
