#include <course/checks.hpp>
#include <tumble/mass_properties.hpp>

using namespace tumble;
using namespace tumble::course;

TEST_CASE_TEMPLATE("Each column alone can be too long, and each two can lean towards each other",
                   Real, EVERY_PRECISION) {
  const Mat3<Real> axes = Mat3<Real>::Identity();
  CHECK(orthonormality_error(axes) == 0);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      Mat3<Real> off = axes;
      off(i, j) += Real(0.5);  // a column of length 1.5, or one that leans by a half
      CHECK(orthonormality_error(off) == (i == j ? Real(1.25) : Real(0.5)));
      CHECK_THROWS_AS(require_turn("off", off), std::invalid_argument);
      off(i, j) = std::numeric_limits<Real>::quiet_NaN();
      CHECK(std::isnan(orthonormality_error(off)));
      CHECK_THROWS_AS(require_turn("off", off), std::invalid_argument);
    }
}

TEST_CASE_TEMPLATE("The triple product of axes is 1 right-handed and -1 left-handed", Real,
                   EVERY_PRECISION) {
  Mat3<Real> axes = Mat3<Real>::Zero();
  for (int first = 0; first < 3; ++first)
    for (const int turn : {1, 2}) {
      axes = Mat3<Real>::Zero();
      axes(first, 0) = axes((first + turn) % 3, 1) = axes((first + 2 * turn) % 3, 2) = 1;
      CHECK(triple_product(axes) == (turn == 1 ? 1 : -1));
    }
  axes << 2, 1, 0, 0, 3, 1, 1, 0, 4;  // 2 (12 - 0) - 1 (0 - 1) = 25
  CHECK(triple_product(axes) == 25);
}
