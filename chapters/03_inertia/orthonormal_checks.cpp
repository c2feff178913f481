#include <support/checks.hpp>
#include <tumble/mass_properties.hpp>

using namespace tumble;
using namespace tumble::support;

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
    }
}

TEST_CASE_TEMPLATE("A matrix that is not finite is refused, and so is one whose squares are not",
                   Real, EVERY_PRECISION) {
  const Real infinity = std::numeric_limits<Real>::infinity(),
             huge = std::sqrt(std::numeric_limits<Real>::max()) * 2;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      Mat3<Real> off = Mat3<Real>::Identity();
      for (const Real bad : {std::numeric_limits<Real>::quiet_NaN(), infinity, -infinity}) {
        off(i, j) = bad;
        CHECK(complaint_of([&] { require_turn("off", off); }) ==
              "off does not turn rigidly; an element of it is infinite or NaN");
      }
      // Two columns whose product is infinity less infinity: each square alone is infinite.
      off = Mat3<Real>::Identity();
      off.col(j) = off.col((j + 1) % 3) = Vec3<Real>::Constant(huge);
      off(i, j) = -huge;
      CHECK(orthonormality_error(off) == infinity);
      CHECK_THROWS_AS(require_turn("off", off), std::invalid_argument);
    }
}
