// Turns a top by every rung in both precisions, and prints a digest of all states: the same on
// every machine, or some compiler rounds otherwise.
#include <bit>
#include <cmath>
#include <course/rungs.hpp>
#include <cstdint>
#include <cstdio>
#include <type_traits>

namespace {

using namespace tumble;

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
  std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325;
};

/// 2000 steps of 1/64 s, with moments whose quotients no binary number is equal to, and a torque
/// that keeps its direction in the world.
template <class Real>
void print_digests(const char* precision) {
  for (const TurningRung<Real>& rung : course::rungs<Real>()) {
    Digest digest;
    Top<Real> top;
    top.inverse_moments = {Real(1), Real(0.7), Real(0.3)};
    top.angular_momentum_body = {Real(1.1), Real(2.3), Real(0.7)};
    top.torque = {Real(0.01), Real(-0.02), Real(0.03)};
    for (int step = 0; step < 2000; ++step) {
      kick(top, Real(0.015625));
      rung.turn(top, Real(0.015625));
      digest.take(top.orientation.real);
      for (int axis = 0; axis < 3; ++axis) {
        digest.take(top.orientation.imaginary[axis]);
        digest.take(top.angular_momentum_body[axis]);
      }
    }
    std::printf("rung %.*s\t%s\t%016llx\n", int(rung.name.size()), rung.name.data(), precision,
                static_cast<unsigned long long>(digest.value()));
  }
}

}  // namespace

int main() {
  print_digests<float>("float");
  print_digests<double>("double");
}
