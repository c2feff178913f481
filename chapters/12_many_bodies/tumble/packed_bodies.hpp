/// @file
/// The bodies of a world in packs: the particles of several bodies side by side, and their tops.
#pragma once

#include <tumble/bodies.hpp>
#include <tumble/pack.hpp>

namespace tumble {

/// The bytes of a vector register: 64 with AVX-512, 32 with AVX, 16 with neither.
//! [width]
#if defined(__AVX512F__)
constexpr std::size_t vector_bytes = 64;
#elif defined(__AVX__)
constexpr std::size_t vector_bytes = 32;
#else
constexpr std::size_t vector_bytes = 16;
#endif
/// How many numbers fit into one register of the machine that it is compiled for.
template <class Real>
constexpr int natural_width = static_cast<int>(vector_bytes / sizeof(Real));
//! [width]

/// Copies the numbers of one body out of its lane of a pack of bodies, or into it.
template <class Real, int width>
Vec3<Real> lane_of(const Vec3<Pack<Real, width>>& packed, int lane) {
  return {packed.x()[lane], packed.y()[lane], packed.z()[lane]};
}
template <class Real, int width>
void set_lane(Vec3<Pack<Real, width>>& packed, int lane, const Vec3<Real>& vector) {
  for (int axis = 0; axis < 3; ++axis) packed[axis].lanes[lane] = vector[axis];
}

template <class Real, int width>
Particle<Real> lane_of(const Particle<Pack<Real, width>>& packed, int lane) {
  return {.position = lane_of(packed.position, lane),
          .velocity = lane_of(packed.velocity, lane),
          .force = lane_of(packed.force, lane),
          .inverse_mass = packed.inverse_mass[lane]};
}
template <class Real, int width>
void set_lane(Particle<Pack<Real, width>>& packed, int lane, const Particle<Real>& particle) {
  set_lane(packed.position, lane, particle.position);
  set_lane(packed.velocity, lane, particle.velocity);
  set_lane(packed.force, lane, particle.force);
  packed.inverse_mass.lanes[lane] = particle.inverse_mass;
}

template <class Real, int width>
Top<Real> lane_of(const Top<Pack<Real, width>>& packed, int lane) {
  return {
      .orientation = {packed.orientation.real[lane], lane_of(packed.orientation.imaginary, lane)},
      .angular_momentum_body = lane_of(packed.angular_momentum_body, lane),
      .torque = lane_of(packed.torque, lane),
      .inverse_moments = lane_of(packed.inverse_moments, lane)};
}
template <class Real, int width>
void set_lane(Top<Pack<Real, width>>& packed, int lane, const Top<Real>& top) {
  packed.orientation.real.lanes[lane] = top.orientation.real;
  set_lane(packed.orientation.imaginary, lane, top.orientation.imaginary);
  set_lane(packed.angular_momentum_body, lane, top.angular_momentum_body);
  set_lane(packed.torque, lane, top.torque);
  set_lane(packed.inverse_moments, lane, top.inverse_moments);
}

/// An array of particles or tops, `width` to a pack. One of them is read and written as a copy, out
/// of its lane and into it; packs() has all as they lie. The lanes that are left over in the last
/// pack hold bodies that nothing can move.
//! [packed_array]
template <template <class> class Element, class Real, int width>
class PackedArray {
 public:
  using Packed = Element<Pack<Real, width>>;

  /// How many there are, without the lanes that are left over.
  std::size_t size() const { return size_; }
  /// A copy of one, all of its numbers: who wants the positions alone reads packs().
  Element<Real> operator[](BodyIndex i) const { return lane_of(packs_[i / width], lane(i)); }
  void set(BodyIndex i, const Element<Real>& element) {
    set_lane(packs_[i / width], lane(i), element);
  }
  void push_back(const Element<Real>& element) {
    if (size_ % width == 0) packs_.push_back(Packed{});
    set(static_cast<BodyIndex>(size_++), element);
  }
  /// Takes an element out; the last one gets its place.
  friend void swap_and_pop(PackedArray& array, BodyIndex i) {
    const auto last = static_cast<BodyIndex>(--array.size_);
    array.set(i, array[last]);
    array.set(last, Element<Real>{});
    if (array.size_ % width == 0) array.packs_.pop_back();
  }

  /// All as they lie, `width` to an element; lane_of() takes one out of it.
  std::vector<Packed>& packs() { return packs_; }
  const std::vector<Packed>& packs() const { return packs_; }

 private:
  static int lane(BodyIndex i) { return static_cast<int>(i % width); }

  std::vector<Packed> packs_;
  std::size_t size_ = 0;
};
//! [packed_array]

/// All bodies of a world, see Bodies.
template <class Real, int width>
struct PackedBodies : BodyMap {
  PackedArray<Particle, Real, width> centres;  ///< one for each body
  PackedArray<Top, Real, width> tops;          ///< one for each that is not a point
};

/// Copies all bodies into packs.
template <class Real, int width>
PackedBodies<Real, width> packed(const Bodies<Real>& bodies) {
  PackedBodies<Real, width> result;
  for (const Particle<Real>& centre : bodies.centres) result.centres.push_back(centre);
  for (const Top<Real>& top : bodies.tops) result.tops.push_back(top);
  static_cast<BodyMap&>(result) = bodies;
  return result;
}

/// Copies all bodies out of their packs.
template <class Real, int width>
Bodies<Real> unpacked(const PackedBodies<Real, width>& bodies) {
  Bodies<Real> result;
  for (BodyIndex i = 0; i < bodies.centres.size(); ++i) result.centres.push_back(bodies.centres[i]);
  for (BodyIndex i = 0; i < bodies.tops.size(); ++i) result.tops.push_back(bodies.tops[i]);
  static_cast<BodyMap&>(result) = bodies;
  return result;
}

/// One body; a point has a top that is locked about every axis.
template <class Real, int width>
RigidBody<Real> body_at(const PackedBodies<Real, width>& bodies, BodyIndex body) {
  return {.centre = bodies.centres[body],
          .top = is_point(bodies, body) ? Top<Real>{} : bodies.tops[bodies.top_of[body]]};
}
template <class Real, int width>
void set_body_at(PackedBodies<Real, width>& bodies, BodyIndex body, const RigidBody<Real>& state) {
  bodies.centres.set(body, state.centre);
  if (!is_point(bodies, body)) bodies.tops.set(bodies.top_of[body], state.top);
}

}  // namespace tumble
