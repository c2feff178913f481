#include <chrono>
#include <support/checks.hpp>
#include <system_error>
#include <tumble/thread_pool.hpp>

using namespace tumble;
using namespace tumble::support;

TEST_CASE("A pool does every share once, and run() waits for all of them") {
  for (int size = 1; size <= 4; ++size) {
    ThreadPool pool(size);
    std::vector<int> done(static_cast<std::size_t>(size), 0);  // each member writes its own alone
    for (int call = 1; call <= 2000; ++call) {
      pool.run([&](int member) { ++done[static_cast<std::size_t>(member)]; });
      for (const int count : done) REQUIRE(count == call);
    }
  }
}

TEST_CASE("What a member of a pool throws, run() throws when all are done, and the pool works on") {
  for (const int size : {1, 2, 4})
    for (int thrower = 0; thrower < size; ++thrower) {
      ThreadPool pool(size);
      std::atomic<int> done = 0;
      CHECK(complaint_of([&] {
              pool.run([&](int member) {
                if (member == thrower) throw std::invalid_argument("this share can't be done");
                std::this_thread::sleep_for(std::chrono::milliseconds(2));
                ++done;
              });
            }) == "this share can't be done");
      CHECK(done == size - 1);
      pool.run([&](int) { ++done; });
      CHECK(done == 2 * size - 1);
    }
}

TEST_CASE("A copy of a pool is another pool of the same size") {
  ThreadPool pool(3);
  ThreadPool copy = pool;
  CHECK(copy.size() == 3);
  std::atomic<int> calls = 0;
  pool.run([&](int) { copy.size(), ++calls; });
  copy.run([&](int) { ++calls; });
  pool = ThreadPool(2);
  pool.run([&](int) { ++calls; });
  CHECK(calls == 8);
}

TEST_CASE("A pool to which one of the same size is assigned keeps its threads") {
  ThreadPool pool(2), same(2), other(3);
  const auto calls_of_second = [&] {  // as its thread counts them
    int calls = 0;
    pool.run([&](int member) {
      thread_local int count = 0;
      if (++count; member == 1) calls = count;
    });
    return calls;
  };
  CHECK(calls_of_second() == 1);
  pool = same;
  CHECK(calls_of_second() == 2);
  pool = other;
  CHECK(pool.size() == 3);
  CHECK(calls_of_second() == 1);
}

TEST_CASE("A pool of no threads, or of thousands, is refused by number and rule") {
  CHECK(complaint_of([] { ThreadPool(0); }) ==
        "0 threads were asked for; a world can use from 1 to 1024");
  CHECK(complaint_of([] { ThreadPool(-1); }) ==
        "-1 threads were asked for; a world can use from 1 to 1024");
  CHECK(complaint_of([] { ThreadPool(1025); }) ==
        "1025 threads were asked for; a world can use from 1 to 1024");
  CHECK(complaint_of([] {
          try {
            ThreadPool(1024);
          } catch (const std::system_error&) {  // the system may have fewer
          }
        }) == "nothing thrown");
}
