#include <course/checks.hpp>
#include <tumble/pack.hpp>

using namespace tumble;
using namespace tumble::course;

TEST_CASE_TEMPLATE("A pack of numbers adds, multiplies and compares lane by lane", Real,
                   EVERY_PRECISION) {
  Pack<Real, 4> a = 2, b = 3;
  a.lanes[1] = 5;
  CHECK((a * b)[1] == 15);
  CHECK((a > b)[1]);
  CHECK(!(a > b)[0]);
}
