// Where the refusals and the corrections of this chapter begin.
#include <support/random_quaternion.hpp>
#include <tumble/rotation_matrix.hpp>

using namespace tumble;
using namespace tumble::support;

TEST_CASE_TEMPLATE("A quaternion whose square is off by 8 epsilon stays as it is, by 9 it does not",
                   Real, EVERY_PRECISION) {
  const Real epsilon = std::numeric_limits<Real>::epsilon();
  // (1 + 4 epsilon)² rounds to 1 + 8 epsilon. The imaginary part's square is one epsilon, to the
  // bit: epsilon is 2⁻⁵² in double, and 2⁻²³, the sum of two squares, in float.
  const Quaternion<Real> eight = {.real = 1 + 4 * epsilon, .imaginary = {0, 0, 0}};
  const Real x = std::is_same_v<Real, float> ? Real(0x1p-12) : Real(0x1p-26);
  const Real y = std::is_same_v<Real, float> ? x : 0;
  const Quaternion<Real> nine = {.real = eight.real, .imaginary = {x, y, 0}};
  REQUIRE(eight.real * eight.real == 1 + 8 * epsilon);
  REQUIRE(nine.real * nine.real + nine.imaginary.squaredNorm() == 1 + 9 * epsilon);
  CHECK(same_bits(renormalized(eight), eight));
  CHECK_FALSE(same_bits(renormalized(nine), nine));
}

TEST_CASE_TEMPLATE(
    "The squares and products of a rotation's columns may be off by 0.01 and no more", Real,
    EVERY_PRECISION) {
  // Sheared by e, the columns' products are off by e, and a length's square by e².
  const auto complaint = [](Real e) {
    Mat3<Real> matrix = Mat3<Real>::Identity();
    matrix(0, 1) = e;
    return complaint_of([&] { quaternion_of(matrix); });
  };
  const Real most = Real(0.01);
  CHECK(complaint(most) == "nothing thrown");
  CHECK(complaint(std::nextafter(most, Real(1))).find("the largest element of RᵀR − 1") == 0);
  for (int column = 0; column < 3; ++column) {
    Mat3<Real> matrix = Mat3<Real>::Identity();
    // A length is off by half of what its square is.
    matrix(column, column) = Real(1.0049);
    CHECK(complaint_of([&] { quaternion_of(matrix); }) == "nothing thrown");
    matrix(column, column) = Real(1.0051);
    CHECK(complaint_of([&] { quaternion_of(matrix); }) != "nothing thrown");
    matrix(1, column) = std::numeric_limits<Real>::quiet_NaN();
    CHECK(complaint_of([&] { quaternion_of(matrix); }).find("a column of rotation is (") == 0);
  }
}

TEST_CASE_TEMPLATE("A sum of quaternions is the sum of their components", Real, EVERY_PRECISION) {
  const Quaternion<Real> p = {.real = 1, .imaginary = {2, -3, 4}};
  const Quaternion<Real> q = {.real = 8, .imaginary = {16, 32, -64}};
  const Quaternion<Real> sum = {.real = 9, .imaginary = {18, 29, -60}};
  CHECK(same_bits(p + q, sum));
}
