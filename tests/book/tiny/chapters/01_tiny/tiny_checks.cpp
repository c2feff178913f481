#include <course/checks.hpp>
#include <tumble/tiny.hpp>

TEST_CASE("The stick is shorter than two metres") {
  CHECK(tumble::stick_length() < 2);
}
