/// @file
/// The undo buffer of a step in packs.
#pragma once

#include <tumble/motion_record.hpp>
#include <tumble/packed_visits.hpp>

namespace tumble {

/// How those packs moved that a step is about to change. Each block is remembered just before it is
/// stepped, while it is in the cache.
template <class Real, int width>
class PackedUndoBuffer {
  using Packed = Pack<Real, width>;

 public:
  void resize(std::size_t packs_of_centres, std::size_t packs_of_tops) {
    centres_.resize(packs_of_centres);
    tops_.resize(packs_of_tops);
  }

  //! [remember]
  [[gnu::always_inline]] void remember(const PackedArray<Particle, Real, width>& array,
                                       std::uint32_t pack) {
    centres_[pack] = motion_of(array.packs()[pack]);
  }
  [[gnu::always_inline]] void remember(const PackedArray<Top, Real, width>& array,
                                       std::uint32_t pack) {
    tops_[pack] = motion_of(array.packs()[pack]);
  }
  //! [remember]

  /// Puts back one element of an array, and clears its force or torque.
  void restore(PackedArray<Particle, Real, width>& array, BodyIndex i) const {
    const int lane = static_cast<int>(i % width);
    const auto& [position, velocity] = centres_[i / width];
    Particle<Real> centre = array[i];
    set_motion(centre, {lane_of(position, lane), lane_of(velocity, lane)});
    array.set(i, centre);
  }
  void restore(PackedArray<Top, Real, width>& array, BodyIndex i) const {
    const int lane = static_cast<int>(i % width);
    const auto& [q, L] = tops_[i / width];
    Top<Real> top = array[i];
    set_motion(top, {{q.real[lane], lane_of(q.imaginary, lane)}, lane_of(L, lane)});
    array.set(i, top);
  }

 private:
  std::vector<CentreMotion<Packed>> centres_;
  std::vector<TopMotion<Packed>> tops_;
};

}  // namespace tumble
