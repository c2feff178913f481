#include <set>
#include <support/checks.hpp>
#include <support/random_world.hpp>
#include <tumble/index_set.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

std::set<BodyIndex> members_of(const IndexSet& group) {
  std::set<BodyIndex> members;
  for (const BodyIndex i : group) CHECK(members.insert(i).second);
  return members;
}

}  // namespace

TEST_CASE("A group is a set, whatever comes, goes and takes the place of another") {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    CAPTURE(seed);
    RandomGenerator dice(seed);
    const std::size_t most = seed % 2 == 0 ? 12 : 200;  // short lists and long ones
    std::size_t count = 0;
    IndexSet group;
    std::set<BodyIndex> expected;
    for (int n = 0; n < 600; ++n) {
      const auto some = static_cast<BodyIndex>(dice.below(std::max<std::size_t>(count, 1)));
      switch (dice.below(4)) {
        case 0:  // an element comes
          if (count == most) break;
          if (!dice.one_in(seed)) {
            group.insert(static_cast<BodyIndex>(count));
            expected.insert(static_cast<BodyIndex>(count));
          }
          ++count;
          break;
        case 1:
          if (count == 0) break;
          group.insert(some);
          expected.insert(some);
          break;
        case 2:
          if (seed % 3 == 0) break;  // some groups lose nobody that stays in the array
          group.erase(some);
          expected.erase(some);
          break;
        default: {  // an element goes, and the last gets its place
          if (count == 0) break;
          const auto last = static_cast<BodyIndex>(--count);
          group.replace_by_last(some, last);
          const bool was_member = expected.erase(last) > 0;
          expected.erase(some);
          if (was_member && some != last) expected.insert(some);
        }
      }
      REQUIRE(group.size() == expected.size());
      REQUIRE(members_of(group) == expected);
      for (BodyIndex i = 0; i < count; ++i) REQUIRE(group.contains(i) == expected.contains(i));
    }
  }
}

TEST_CASE(
    "A group of the first so many bodies is a number: coming and going at its end lists nobody") {
  IndexSet group;
  for (BodyIndex i = 0; i < 100; ++i) group.insert(i);
  group.replace_by_last(7, 99);
  group.erase(98);
  CHECK_FALSE(group.is_listed());
  CHECK(group.size() == 98);
  group.erase(5);
  CHECK(group.is_listed());
  CHECK(group.size() == 97);
}

TEST_CASE("A long group that becomes a list knows who comes later") {
  IndexSet group;
  for (BodyIndex i = 0; i < 40; ++i) group.insert(i);
  group.erase(5);
  group.insert(50);
  group.insert(5);
  CHECK(group.contains(50));
  CHECK(group.contains(5));
  CHECK(group.size() == 41);
  group.erase(50);
  CHECK_FALSE(group.contains(50));
  for (BodyIndex i = 0; i < 30; ++i) group.erase(i);  // so few that they are searched
  group.insert(60);
  CHECK(group.contains(60));
  CHECK(group.size() == 11);
}
