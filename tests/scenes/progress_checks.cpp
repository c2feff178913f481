#include "progress.hpp"

#include <support/checks.hpp>

using namespace tumble::simulate;

TEST_CASE("The time left is told in seconds, minutes and seconds, or hours and minutes") {
  CHECK(duration_text(0) == "0 s");
  CHECK(duration_text(12.4) == "12 s");
  CHECK(duration_text(59.6) == "1 min 0 s");
  CHECK(duration_text(200) == "3 min 20 s");
  CHECK(duration_text(3599) == "59 min 59 s");
  CHECK(duration_text(3600) == "1 h 0 min");
  CHECK(duration_text(7541) == "2 h 5 min");
  CHECK(duration_text(90'000) == "25 h 0 min");
}

TEST_CASE("The rest takes as long, in proportion, as what has been done") {
  CHECK(time_left(10, 0.25) == 30);
  CHECK(time_left(10, 0.5) == 10);
  CHECK(time_left(10, 1) == 0);
}
