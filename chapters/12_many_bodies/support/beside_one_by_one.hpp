/// @file
/// Random worlds in packs beside the same worlds with their bodies one by one.
#pragma once

#include <support/checks.hpp>
#include <support/complaint_of_step.hpp>
#include <support/random_world.hpp>
#include <tumble/in_packs.hpp>

namespace tumble::support {

/// Random worlds with up to 40 bodies, kept in packs of `width` and stepped by `threads`, beside
/// the same worlds with their bodies one by one.
template <class Real, int width>
void compare_with_one_by_one(std::uint64_t first_seed, int count, int threads) {
  int moved = 0;
  for (std::uint64_t seed = first_seed; seed < first_seed + static_cast<std::uint64_t>(count);
       ++seed) {
    CAPTURE(seed);
    CAPTURE(width);
    CAPTURE(threads);
    RandomGenerator dice(seed), same_dice(seed);
    World<Real> plain = random_world<Real>(dice, 40);
    auto packed = random_world<Real, InPacks<Real, width>>(same_dice, 40);
    packed.use_threads(threads);
    const Bodies<Real> start = plain.bodies();
    for (int n = 0; n < 16; ++n) {
      if (n % 4 == 3) {
        meddle(plain, dice, n);
        meddle(packed, same_dice, n);
      }
      const std::string complaint = complaint_of_step([&] { plain.step(); });
      REQUIRE(complaint_of_step([&] { packed.step(); }) == complaint);
      REQUIRE(same_motion(plain.bodies(), packed.bodies()));
    }
    moved += !same_motion(start, plain.bodies());
  }
  CHECK(moved > count / 2);
}

}  // namespace tumble::support

#ifdef TUMBLE_COMPILED_RANDOM_WORLDS
namespace tumble {
extern template ManyBodies<float> support::random_world(support::RandomGenerator&, std::size_t);
extern template ManyBodies<double> support::random_world(support::RandomGenerator&, std::size_t);
extern template void support::meddle(ManyBodies<float>&, support::RandomGenerator&, int);
extern template void support::meddle(ManyBodies<double>&, support::RandomGenerator&, int);
extern template BodyHandle support::add_random_body(ManyBodies<float>&, support::RandomGenerator&,
                                                    const std::string&);
extern template BodyHandle support::add_random_body(ManyBodies<double>&, support::RandomGenerator&,
                                                    const std::string&);
extern template void support::add_random_effect(ManyBodies<float>&, support::RandomGenerator&,
                                                const std::vector<BodyHandle>&);
extern template void support::add_random_effect(ManyBodies<double>&, support::RandomGenerator&,
                                                const std::vector<BodyHandle>&);
}  // namespace tumble
#endif
