#include <support/checks.hpp>
#include <tumble/tiny.hpp>

TEST_CASE("The stick is shorter than two metres") {
  CHECK(tumble::stick_length() < 2);
}

TEST_CASE("The stick has a length") {
  CHECK(tumble::stick_length() > 0);
}

TEST_CASE("The stick has a length") {
  CHECK(tumble::stick_length() != 0);
}
