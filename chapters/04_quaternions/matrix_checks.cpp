#include <numbers>
#include <support/random_quaternion.hpp>
#include <tumble/rotation_matrix.hpp>
#include <tumble/rotation_vector.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

/// An element of the matrix sums two products of at most 1, doubled, and a third number.
template <class Real>
constexpr Real matrix_bound = 8 * unit_roundoff<Real>;

/// The distance of two quaternions, of which each may also have the other sign.
template <class Real>
Real distance_up_to_sign(const Quaternion<Real>& p, const Quaternion<Real>& q) {
  return std::min(distance(p, q), distance(p, -q));
}

}  // namespace

TEST_CASE_TEMPLATE("The matrix of a quaternion turns vectors as the quaternion does", Real,
                   EVERY_PRECISION) {
  std::mt19937_64 generator(41);
  for (int trial = 0; trial < 1000; ++trial) {
    const Quaternion<Real> q = random_orientation<Real>(generator);
    const Vec3<Real> v = random_vector<Real>(generator);
    // Three elements times a component each, five roundings; the 23 of rotate(), see
    // rotate_checks.cpp.
    CHECK(distance<Real>(matrix_of(q) * v, rotate(q, v)) <=
          (3 * matrix_bound<Real> + (5 + 23) * unit_roundoff<Real>)*v.norm());
  }
}

TEST_CASE_TEMPLATE("The matrix of a product is the product of the matrices", Real,
                   EVERY_PRECISION) {
  std::mt19937_64 generator(43);
  for (int trial = 0; trial < 1000; ++trial) {
    const Quaternion<Real> p = random_orientation<Real>(generator),
                           q = random_orientation<Real>(generator);
    const Mat3<Real> product = matrix_of(p) * matrix_of(q);
    // Norms off by 8 in each factor count twice.
    CHECK((matrix_of<Real>(p * q) - product).cwiseAbs().maxCoeff() <=
          8 * matrix_bound<Real> + (2 * 2 * 7 + 2 * 2 * 8) * unit_roundoff<Real>);
  }
}

TEST_CASE_TEMPLATE("From quaternion to matrix and back no digits are lost, near 180 degrees too",
                   Real, EVERY_PRECISION) {
  std::mt19937_64 generator(44);
  std::vector<Vec3<Real>> axes = {{1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {1, 1, 0}, {-1, 1, 1}};
  for (int trial = 0; trial < 100; ++trial) axes.push_back(random_vector<Real>(generator));
  const Real pi = std::numbers::pi_v<Real>;
  for (const Vec3<Real>& axis : axes)
    for (const Real angle : {Real(0), Real(1e-6), Real(1), Real(2), Real(2.1), pi - Real(1e-3),
                             pi - Real(1e-6), std::nextafter(pi, Real(0)), pi, pi + Real(1e-6)}) {
      CAPTURE(angle);
      const Quaternion<Real> q = quaternion_about(axis, angle), back = quaternion_of(matrix_of(q));
      // The largest of 4 q_i² is at least 1, so the column taken is at least 1 long, and no element
      // of it sums more than four elements of the matrix; then 8 for q's own norm, 8 for the other.
      CHECK(distance_up_to_sign(back, q) <= 4 * matrix_bound<Real> + (8 + 8) * unit_roundoff<Real>);
      CHECK(back.real >= 0);
    }
}

TEST_CASE_TEMPLATE("A half turn about each axis comes back to the bit", Real, EVERY_PRECISION) {
  for (int axis = 0; axis < 3; ++axis) {
    Quaternion<Real> q = {.real = 0};
    q.imaginary[axis] = 1;
    CHECK(same_bits(quaternion_of(matrix_of(q)), q));
  }
  CHECK(same_bits(quaternion_of<Real>(Mat3<Real>::Identity()), Quaternion<Real>()));
}

TEST_CASE_TEMPLATE("A matrix that isn't a rotation is refused: stretched, mirrored or not finite",
                   Real, EVERY_PRECISION) {
  const auto complaint = [](const Mat3<Real>& matrix) {
    return complaint_of([&] { quaternion_of(matrix, "orientation"); });
  };
  CHECK(complaint(2 * Mat3<Real>::Identity()) ==
        "the largest element of RᵀR − 1 for orientation is 3; "
        "a rotation's columns have length 1 and are perpendicular to each other, within 0.01");
  CHECK(complaint(-Mat3<Real>::Identity()) ==
        "the determinant of orientation is -1; a rotation's is +1; this is a mirror");
  Mat3<Real> sheared = Mat3<Real>::Identity();
  sheared(0, 1) = Real(0.125);
  CHECK(complaint(sheared).find("for orientation is 0.125;") != std::string::npos);
  Mat3<Real> broken = Mat3<Real>::Identity();
  broken(1, 2) = std::numeric_limits<Real>::quiet_NaN();
  CHECK(complaint(broken) ==
        "a column of orientation is (0, nan, 1); every component must be finite");
  CHECK(complaint(matrix_of(quaternion_about(Vec3<Real>(1, 2, 3), 2))) == "nothing thrown");
  // The limit is 0.01 in RᵀR − 1, of a slant and of a length.
  sheared(0, 1) = Real(0.011);
  CHECK(complaint(sheared) != "nothing thrown");
  sheared(0, 1) = Real(0.009);
  CHECK(complaint(sheared) == "nothing thrown");
  CHECK(complaint(Real(1.0051) * Mat3<Real>::Identity()) != "nothing thrown");
  CHECK(complaint(Real(1.0049) * Mat3<Real>::Identity()) == "nothing thrown");
}

TEST_CASE_TEMPLATE("A matrix that is nearly a rotation still gives a quaternion of norm 1", Real,
                   EVERY_PRECISION) {
  for (const Real angle : {Real(0.1), Real(2), Real(3)}) {
    const Quaternion<Real> q = quaternion_about(Vec3<Real>(1, -2, 3), angle);
    const Quaternion<Real> found = quaternion_of<Real>(Real(1.004) * matrix_of(q));
    CHECK(std::abs(norm(found) - 1) <= 8 * unit_roundoff<Real>);
    // Stretched evenly, R is off by 0.004 of itself, so each of the sixteen products by 0.012.
    CHECK(distance_up_to_sign(found, q) <= Real(0.012));
  }
}
