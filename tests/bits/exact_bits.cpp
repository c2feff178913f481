// Asks every exact solution where it is at 2000 times, and prints a digest. They take sines,
// exponentials and arc tangents from the C++ library, so their bits are those of the library.
#include "digest.hpp"

#include <string>
#include <tumble/exact/free_top.hpp>
#include <tumble/exact/heavy_top.hpp>
#include <tumble/exact/kepler.hpp>
#include <tumble/exact/oscillator.hpp>
#include <tumble/exact/projectile.hpp>
#include <tumble/rotation_vector.hpp>

namespace {

using namespace tumble;

template <class Real, class Solution>
void print_digest(const char* name, const Solution& solution) {
  bits::Digest digest;
  for (int n = 0; n < 2000; ++n) {
    const auto state = solution.at(Real(n) / 64);
    if constexpr (std::is_same_v<std::decay_t<decltype(state)>, exact::OscillatorState<Real>>)
      digest.take(Vec3<Real>(state.position, state.velocity, 0));
    else
      digest.take(state);
  }
  bits::print<Real>("exact " + std::string(name), digest);
}

template <class Real>
void print_digests() {
  Top<Real> top;
  top.inverse_moments = {Real(1), Real(0.7), Real(0.3)};
  top.angular_momentum_body = {Real(1.1), Real(2.3), Real(0.7)};
  print_digest<Real>("free top", exact::FreeTop<Real>(top));
  top.inverse_moments = {Real(0.7), Real(0.7), Real(1.3)};
  top.orientation = quaternion_about(Vec3<Real>(Real(1), Real(0.5), 0), Real(0.4));
  print_digest<Real>("heavy top", exact::HeavyTop<Real>(top, Vec3<Real>(0, 0, Real(-1.7))));
  Particle<Real> planet;
  planet.position = {Real(1.1), Real(0.2), 0};
  planet.velocity = {Real(0.1), Real(0.9), Real(0.3)};
  print_digest<Real>("Kepler orbit", exact::KeplerOrbit<Real>(planet, Real(1.1)));
  print_digest<Real>("projectile", exact::Projectile<Real>(planet, {0, 0, Real(-9.81)}, Real(0.3)));
  const exact::OscillatorState<Real> swing{.position = Real(1.1), .velocity = Real(0.3)};
  print_digest<Real>("oscillator", exact::Oscillator<Real>(swing, Real(1.7), Real(0.1)));
  print_digest<Real>("creeping oscillator", exact::Oscillator<Real>(swing, Real(1.7), Real(2.9)));
}

}  // namespace

int main() {
  print_digests<float>();
  print_digests<double>();
}
