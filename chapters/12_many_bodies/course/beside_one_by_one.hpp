/// @file
/// Random worlds in packs beside the same worlds with their bodies one by one.
#pragma once

#include <course/checks.hpp>
#include <course/complaint_of_step.hpp>
#include <course/random_world.hpp>
#include <tumble/in_packs.hpp>

namespace tumble::course {

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
    Dice dice(seed), same_dice(seed);
    World<Real> plain = random_world<Real>(dice, 40);
    auto packed = random_world<Real, InPacks<Real, width>>(same_dice, 40);
    packed.keeping().use_threads(threads);
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

}  // namespace tumble::course

#ifdef TUMBLE_COMPILED_RANDOM_WORLDS
namespace tumble {
extern template ManyBodies<float> course::random_world(course::Dice&, std::size_t);
extern template ManyBodies<double> course::random_world(course::Dice&, std::size_t);
extern template void course::meddle(ManyBodies<float>&, course::Dice&, int);
extern template void course::meddle(ManyBodies<double>&, course::Dice&, int);
extern template BodyHandle course::add_random_body(ManyBodies<float>&, course::Dice&,
                                                   const std::string&);
extern template BodyHandle course::add_random_body(ManyBodies<double>&, course::Dice&,
                                                   const std::string&);
extern template void course::add_random_effect(ManyBodies<float>&, course::Dice&,
                                               const std::vector<BodyHandle>&);
extern template void course::add_random_effect(ManyBodies<double>&, course::Dice&,
                                               const std::vector<BodyHandle>&);
}  // namespace tumble
#endif
