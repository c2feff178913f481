/// @file
/// Digests of states, to be compared between machines.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string_view>
#include <tumble/particle.hpp>
#include <tumble/top.hpp>
#include <type_traits>

namespace tumble::bits {

/// FNV-1a, a well-known digest: http://www.isthe.com/chongo/tech/comp/fnv.
class Digest {
 public:
  /// Which of its many bit patterns a machine chooses for what is no number means nothing.
  template <class Real>
  void take(Real value) {
    using Word = std::conditional_t<sizeof(Real) == 4, std::uint32_t, std::uint64_t>;
    const Word bits = std::isnan(value) ? ~Word(0) : std::bit_cast<Word>(value);
    for (std::size_t byte = 0; byte < sizeof(Real); ++byte)
      hash_ = (hash_ ^ (bits >> (8 * byte) & 0xff)) * 0x100000001b3;
  }
  template <class Real>
  void take(const Vec3<Real>& vector) {
    for (int axis = 0; axis < 3; ++axis) take(vector[axis]);
  }
  template <class Real>
  void take(const Top<Real>& top) {
    take(top.orientation.real);
    for (int axis = 0; axis < 3; ++axis) {
      take(top.orientation.imaginary[axis]);
      take(top.angular_momentum_body[axis]);
    }
  }
  template <class Real>
  void take(const Particle<Real>& particle) {
    take(particle.position);
    take(particle.velocity);
  }
  std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325;
};

template <class Real>
constexpr const char* precision_of = sizeof(Real) == 4 ? "float" : "double";

/// A line that bits.py reads: what was run, the precision, the digest.
template <class Real>
void print(std::string_view what, const Digest& digest) {
  std::printf("%.*s\t%s\t%016llx\n", int(what.size()), what.data(), precision_of<Real>,
              static_cast<unsigned long long>(digest.value()));
}

}  // namespace tumble::bits
