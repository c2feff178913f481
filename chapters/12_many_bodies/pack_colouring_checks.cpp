#include <set>
#include <support/checks.hpp>
#include <support/random_generator.hpp>
#include <tumble/pack_colouring.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

constexpr int lane_count = 4;

/// Points and bodies with tops, of which some have gone: then tops of bodies of different packs lie
/// in one.
PackedBodies<float, lane_count> mixed_bodies(std::size_t count) {
  Bodies<float> bodies;
  const Top<float> top;
  RandomGenerator dice(31);
  for (std::size_t n = 0; n < count + 9; ++n)
    append(bodies, Particle<float>{}, dice.one_in(3) ? nullptr : &top);
  for (int n = 0; n < 9; ++n) take_out(bodies, static_cast<BodyIndex>(dice.below(count)));
  return packed<float, lane_count>(bodies);
}

}  // namespace

TEST_CASE("Threads that share a part of the packs have no pack of tops in common") {
  const PackedBodies<float, lane_count> bodies = mixed_bodies(90);
  PackedIndexSet<float, lane_count> group;  // all but pack 2, and of packs 5 and 21 a part
  group.whole = {{0, 2}, {3, 5}, {6, 21}};
  PackMask<float, lane_count> one{};
  one.lanes[1] = -1;
  group.parts = {{5, one}, {21, one}};
  const PackColouring parts = pack_colouring(group, bodies);
  CHECK(parts.size() > 1);
  std::set<std::uint32_t> seen;
  for (const std::vector<std::uint32_t>& part : parts) {
    std::set<BodyIndex> taken;  // packs of tops, by this part's packs so far
    CHECK(!part.empty());
    for (const std::uint32_t pack : part) {
      CHECK(seen.insert(pack).second);
      std::set<BodyIndex> own;
      for (BodyIndex body = pack * lane_count; body < (pack + 1) * lane_count && body < 90; ++body)
        if (bodies.top_of[body] != no_index) own.insert(bodies.top_of[body] / lane_count);
      for (const BodyIndex tops : own) CHECK(taken.insert(tops).second);
    }
  }
  CHECK(seen.size() == 21);
  CHECK(seen.count(2) == 0);
  CHECK(pack_colouring(PackedIndexSet<float, lane_count>{}, bodies).empty());
}

TEST_CASE("Where all bodies have tops, or none has, all packs are in one part") {
  for (const bool have_tops : {false, true}) {
    Bodies<float> bodies;
    const Top<float> top;
    IndexSet everyone;
    for (BodyIndex n = 0; n < 35; ++n) {
      append(bodies, Particle<float>{}, have_tops ? &top : nullptr);
      everyone.insert(n);
    }
    CHECK(pack_colouring(packed_index_set<float, lane_count>(everyone),
                         packed<float, lane_count>(bodies)) ==
          PackColouring{{0, 1, 2, 3, 4, 5, 6, 7, 8}});
  }
}
