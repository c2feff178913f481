#include <course/checks.hpp>
#include <tumble/thread_team.hpp>

using namespace tumble;
using namespace tumble::course;

TEST_CASE("A team does every share once, and run() waits for all of them") {
  for (int size = 1; size <= 4; ++size) {
    ThreadTeam team(size);
    std::vector<int> done(static_cast<std::size_t>(size), 0);  // each member writes its own alone
    for (int call = 1; call <= 2000; ++call) {
      team.run([&](int member) { ++done[static_cast<std::size_t>(member)]; });
      for (const int count : done) REQUIRE(count == call);
    }
  }
}

TEST_CASE("A copy of a team is another team of the same size") {
  ThreadTeam team(3);
  ThreadTeam copy = team;
  CHECK(copy.size() == 3);
  std::atomic<int> calls = 0;
  team.run([&](int) { copy.size(), ++calls; });
  copy.run([&](int) { ++calls; });
  team = ThreadTeam(2);
  team.run([&](int) { ++calls; });
  CHECK(calls == 8);
}

TEST_CASE("A team of no threads, or of thousands, is refused by number and rule") {
  CHECK(complaint_of([] { ThreadTeam(0); }) ==
        "0 threads were asked for; a world can use from 1 to 1024");
  CHECK(complaint_of([] { ThreadTeam(-1); }) ==
        "-1 threads were asked for; a world can use from 1 to 1024");
  CHECK(complaint_of([] { ThreadTeam(1025); }) ==
        "1025 threads were asked for; a world can use from 1 to 1024");
}
