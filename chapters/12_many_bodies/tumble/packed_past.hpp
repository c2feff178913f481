/// @file
/// What a step in packs changes, as it was before it.
#pragma once

#include <tumble/packed_visits.hpp>

namespace tumble {

/// Place and velocity, orientation and angular momentum of the packs that a step is about to
/// change. Each block is remembered just before it is stepped, while it is in the cache.
template <class Real, int width>
class PackedPast {
  using Packed = Pack<Real, width>;

 public:
  void resize(std::size_t packs_of_centres, std::size_t packs_of_tops) {
    centres_.resize(packs_of_centres);
    tops_.resize(packs_of_tops);
  }

  //! [remember]
  void remember(const PackedArray<Particle, Real, width>& array, std::uint32_t pack) {
    const Particle<Packed>& centre = array.packs()[pack];
    centres_[pack] = {centre.position, centre.velocity};
  }
  void remember(const PackedArray<Top, Real, width>& array, std::uint32_t pack) {
    const Top<Packed>& top = array.packs()[pack];
    tops_[pack] = {top.orientation, top.angular_momentum_body};
  }
  //! [remember]

  /// Puts back one element of an array, and empties its sum.
  void restore(PackedArray<Particle, Real, width>& array, BodyIndex i) const {
    Particle<Real> centre = array[i];
    const auto& [position, velocity] = centres_[i / width];
    centre.position = lane_of(position, lane(i));
    centre.velocity = lane_of(velocity, lane(i));
    clear_force(centre);
    array.set(i, centre);
  }
  void restore(PackedArray<Top, Real, width>& array, BodyIndex i) const {
    Top<Real> top = array[i];
    const auto& [orientation, angular_momentum_body] = tops_[i / width];
    top.orientation = {orientation.real[lane(i)], lane_of(orientation.imaginary, lane(i))};
    top.angular_momentum_body = lane_of(angular_momentum_body, lane(i));
    clear_torque(top);
    array.set(i, top);
  }

 private:
  static int lane(BodyIndex i) { return static_cast<int>(i % width); }
  struct Centre {
    Vec3<Packed> position, velocity;
  };
  struct TopState {
    Quaternion<Packed> orientation;
    Vec3<Packed> angular_momentum_body;
  };
  std::vector<Centre> centres_;
  std::vector<TopState> tops_;
};

}  // namespace tumble
