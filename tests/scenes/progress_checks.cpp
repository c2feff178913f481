#include "progress.hpp"

#include <support/checks.hpp>

using tumble::simulate::duration_text;

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
