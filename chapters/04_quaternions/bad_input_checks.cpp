#include <support/bad_vectors.hpp>
#include <support/random_quaternion.hpp>
#include <tumble/rotation_matrix.hpp>
#include <tumble/rotation_vector.hpp>

using namespace tumble;
using namespace tumble::support;

TEST_CASE_TEMPLATE("A zero quaternion is refused as an orientation", Real, EVERY_PRECISION) {
  CHECK(complaint_of([] { checked_orientation<Real>({.real = 0}, "orientation of the book"); }) ==
        "orientation of the book is (0, 0, 0, 0); "
        "zero turns nothing into nothing: no turn is (1, 0, 0, 0)");
}

TEST_CASE_TEMPLATE("A quaternion that is not finite, or far off norm 1, is refused", Real,
                   EVERY_PRECISION) {
  const auto complaint = [](const Quaternion<Real>& q) {
    return complaint_of([&] { checked_orientation(q, "orientation"); });
  };
  const Real nan = std::numeric_limits<Real>::quiet_NaN(),
             infinity = std::numeric_limits<Real>::infinity();
  CHECK(complaint({.real = nan}) ==
        "orientation is (nan, 0, 0, 0); every component must be finite");
  CHECK(complaint({.imaginary = {0, infinity, 0}}) ==
        "orientation is (1, 0, inf, 0); every component must be finite");
  CHECK(complaint({.real = 2}) ==
        "orientation is (2, 0, 0, 0); its norm is 2 and must be 1 within 0.01");
  for (const Real off : {Real(0.989), Real(1.011)})
    CHECK(complaint({.real = off}).find("must be 1 within 0.01") != std::string::npos);
  for (const Real near : {Real(0.991), Real(1.009)})
    CHECK(complaint({.real = near}) == "nothing thrown");
  // The norm that it names is the true one, even where the square of a component is 0 or infinite.
  for (const Real far : {std::numeric_limits<Real>::min(), std::numeric_limits<Real>::max()})
    CHECK(complaint({.real = far}) == "orientation is (" + text_of(far) +
                                          ", 0, 0, 0); its norm is " + text_of(far) +
                                          " and must be 1 within 0.01");
}

TEST_CASE_TEMPLATE("A quaternion typed to two digits is near enough, and comes out with norm 1",
                   Real, EVERY_PRECISION) {
  std::mt19937_64 generator(51);
  for (int trial = 0; trial < 1000; ++trial) {
    const Quaternion<Real> q = random_orientation<Real>(generator);
    const auto typed = [](Real x) { return std::round(x * 100) / 100; };
    const Quaternion<Real> rounded = {.real = typed(q.real),
                                      .imaginary = q.imaginary.unaryExpr(typed)};
    Quaternion<Real> checked;
    REQUIRE(complaint_of([&] { checked = checked_orientation(rounded, "orientation"); }) ==
            "nothing thrown");
    CHECK(std::abs(norm(checked) - 1) <= 8 * unit_roundoff<Real>);
    CHECK(same_bits(checked, normalized(rounded)));
  }
}

TEST_CASE_TEMPLATE("A zero axis, and an axis or angle that is not finite or too large, is refused",
                   Real, EVERY_PRECISION) {
  const auto complaint = [](const Vec3<Real>& axis, Real angle) {
    return complaint_of([&] { quaternion_about(axis, angle); });
  };
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  CHECK(complaint({0, 0, 0}, 1) == "axis is (0, 0, 0); it needs a direction");
  CHECK(complaint({0, nan, 0}, 1) == "axis is (0, nan, 0); every component must be finite");
  const Real limit = 2 * SineCosineConstants<Real>::limit;
  const std::string rule =
      "it must lie between " + text_of(-limit) + " and " + text_of(limit) + " rad";
  CHECK(complaint({0, 0, 1}, nan) == "angle is nan rad; " + rule);
  CHECK(complaint({0, 0, 1}, 2 * limit) == "angle is " + text_of(2 * limit) + " rad; " + rule);
  CHECK(complaint({0, 0, 1}, -limit) == "nothing thrown");
}

TEST_CASE_TEMPLATE(
    "Of a quaternion, an axis and a matrix every number is checked, and half turns are accepted",
    Real, EVERY_PRECISION) {
  const auto with = [](int part, Real number) {
    Quaternion<Real> q = {.real = 0};
    (part == 3 ? q.real : q.imaginary[part]) = number;
    return q;
  };
  for (int part = 0; part < 4; ++part) {
    for (const Real bad : not_finite<Real>) {
      const Quaternion<Real> q = with(part, bad);
      CHECK(complaint_of([&] { checked_orientation(q, "orientation"); }) ==
            "orientation is " + text_of(q) + "; every component must be finite");
    }
    // All its norm may stand in one component, with either sign.
    for (const Real sign : {Real(1), Real(-1)})
      CHECK(same_bits(checked_orientation(with(part, sign), "orientation"), with(part, sign)));
  }
  check_refuses_bad_vectors<Real>("axis", "",
                                  [](const Vec3<Real>& bad) { quaternion_about(bad, 1); });
  for (int column = 0; column < 3; ++column) {
    check_refuses_bad_vectors<Real>("a column of rotation", "", [column](const Vec3<Real>& bad) {
      Mat3<Real> matrix = Mat3<Real>::Identity();
      matrix.col(column) = bad;
      quaternion_of(matrix);
    });
    Mat3<Real> stretched = Mat3<Real>::Identity();
    stretched.col(column) *= Real(1.02);
    CHECK(complaint_of([&] {
            quaternion_of(stretched);
          }).find("the largest element of RᵀR − 1 for rotation is ") == 0);
  }
}
