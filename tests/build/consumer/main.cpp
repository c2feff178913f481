// What another project may do with tumble::tumble.
#include <cstdio>
#include <tumble/force.hpp>

namespace {

/// Whether a product and a sum round one after the other, as the library's target asks of every
/// user's compiler. A fused operation would keep the last term of (1 + e)² = 1 + 2e + e².
bool rounds_twice() {
  volatile double given = 1 + 0x1p-30;
  const double factor = given;
  const double rounded = 1 + 0x1p-29;
  return factor * factor - rounded == 0;
}

}  // namespace

int main() {
  tumble::Particled particle = tumble::make_particle(2.0);
  tumble::add_force(particle, tumble::Vec3d(12, 0, 0));
  tumble::step(particle, 0.5);
  std::printf("%g m/s\n", particle.velocity.x());
  return rounds_twice() ? 0 : 1;
}
