#include <numbers>
#include <support/random_quaternion.hpp>
#include <tumble/rotation_vector.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

/// How far rotate() may be off for |v| = 1: a cross product is off by 2 roundings of the product of
/// its lengths. The first is doubled (4), passed on by w (4, and 2 for the product) and by the
/// second cross product (7, and 4 of its own), and two sums of up to 3 round (6).
template <class Real>
constexpr Real rotate_bound = (4 + 2 + 7 + 4 + 6) * unit_roundoff<Real>;

/// How far the norm of a normalised quaternion may be off 1.
template <class Real>
constexpr Real norm_bound = 8 * unit_roundoff<Real>;

}  // namespace

TEST_CASE_TEMPLATE("A quarter turn about z takes x to y and y to minus x", Real, EVERY_PRECISION) {
  const Quaternion<Real> q = quaternion_about(Vec3<Real>(0, 0, 1), std::numbers::pi_v<Real> / 2);
  // π/2 and the quaternion are rounded, by 2 roundings each.
  const Real bound = rotate_bound<Real> + 4 * unit_roundoff<Real>;
  CHECK(distance<Real>(rotate(q, Vec3<Real>(1, 0, 0)), Vec3<Real>(0, 1, 0)) <= bound);
  CHECK(distance<Real>(rotate(q, Vec3<Real>(0, 1, 0)), Vec3<Real>(-1, 0, 0)) <= bound);
  CHECK(same_bits(rotate(q, Vec3<Real>(0, 0, 1)), Vec3<Real>(0, 0, 1)));
}

TEST_CASE_TEMPLATE("To rotate a vector is to put it between the quaternion and its conjugate", Real,
                   EVERY_PRECISION) {
  std::mt19937_64 generator(11);
  for (int trial = 0; trial < 1000; ++trial) {
    const Quaternion<Real> q = random_orientation<Real>(generator);
    const Vec3<Real> v = random_vector<Real>(generator);
    const Quaternion<Real> sandwich = q * pure(v) * conjugate(q);
    // Two products of 7 roundings; and |q|² is off 1 by twice the norm's bound.
    const Real bound =
        (rotate_bound<Real> + 14 * unit_roundoff<Real> + 2 * norm_bound<Real>)*v.norm();
    CHECK(std::abs(sandwich.real) <= bound);
    CHECK(distance(rotate(q, v), sandwich.imaginary) <= bound);
  }
}

TEST_CASE_TEMPLATE("Axis and angle turn a vector as Rodrigues' formula does, without quaternions",
                   Real, EVERY_PRECISION) {
  std::mt19937_64 generator(12);
  for (int trial = 0; trial < 1000; ++trial) {
    const Vec3<Real> v = random_vector<Real>(generator),
                     axis = random_vector<Real>(generator).normalized();
    const Real angle = 7 * random_number<Real>(generator);
    const Vec3<Real> along = axis * axis.dot(v), across = v - along;
    const Vec3<Real> expected = along + std::cos(angle) * across + std::sin(angle) * axis.cross(v);
    // The formula rounds 20 times of |v| at most, sine and cosine of the half angle and the axis'
    // length another 10.
    CHECK(distance(rotate(quaternion_about(axis, angle), v), expected) <=
          (rotate_bound<Real> + 30 * unit_roundoff<Real>)*v.norm());
  }
}

TEST_CASE_TEMPLATE("A turn keeps lengths, the angles between vectors, and handedness", Real,
                   EVERY_PRECISION) {
  std::mt19937_64 generator(13);
  for (int trial = 0; trial < 1000; ++trial) {
    const Quaternion<Real> q = random_orientation<Real>(generator);
    const Vec3<Real> a = random_vector<Real>(generator), b = random_vector<Real>(generator);
    // Both factors are off by the bound in each of three components, and q's norm by its own.
    const Real bound = 4 * (2 * rotate_bound<Real> + 4 * norm_bound<Real>)*a.norm() * b.norm();
    CHECK(std::abs(rotate(q, a).dot(rotate(q, b)) - a.dot(b)) <= bound);
    CHECK(distance<Real>(rotate(q, a).cross(rotate(q, b)), rotate<Real>(q, a.cross(b))) <= bound);
  }
}

TEST_CASE_TEMPLATE("Turning back undoes the turn", Real, EVERY_PRECISION) {
  std::mt19937_64 generator(14);
  for (int trial = 0; trial < 1000; ++trial) {
    const Quaternion<Real> q = random_orientation<Real>(generator);
    const Vec3<Real> v = random_vector<Real>(generator);
    const Real bound =
        (2 * std::sqrt(Real(3)) * rotate_bound<Real> + 4 * norm_bound<Real>)*v.norm();
    CHECK(distance(rotate_back(q, rotate(q, v)), v) <= bound);
    CHECK(distance(rotate(q, rotate_back(q, v)), v) <= bound);
  }
}

TEST_CASE_TEMPLATE("q and minus q turn every vector alike, to the bit", Real, EVERY_PRECISION) {
  std::mt19937_64 generator(15);
  for (int trial = 0; trial < 1000; ++trial) {
    const Quaternion<Real> q = random_orientation<Real>(generator);
    const Vec3<Real> v = random_vector<Real>(generator);
    CHECK(same_bits(rotate(q, v), rotate(-q, v)));
  }
}

TEST_CASE_TEMPLATE("One whole turn takes q to minus q, and two take it home", Real,
                   EVERY_PRECISION) {
  const Real pi = std::numbers::pi_v<Real>;
  const Quaternion<Real> none;
  // π is rounded, by 4 units of roundoff at 4π; the sine passes on half of that.
  CHECK(distance(quaternion_about(Vec3<Real>(1, 2, 3), 2 * pi), -none) <= 4 * unit_roundoff<Real>);
  CHECK(distance(quaternion_about(Vec3<Real>(1, 2, 3), 4 * pi), none) <= 8 * unit_roundoff<Real>);
}

TEST_CASE_TEMPLATE("The product p q turns by q first and by p then", Real, EVERY_PRECISION) {
  std::mt19937_64 generator(16);
  for (int trial = 0; trial < 1000; ++trial) {
    const Quaternion<Real> p = random_orientation<Real>(generator),
                           q = random_orientation<Real>(generator);
    const Vec3<Real> v = random_vector<Real>(generator);
    // Three rotations and a product, of quaternions whose norms are off.
    const Real bound =
        (4 * rotate_bound<Real> + 14 * unit_roundoff<Real> + 6 * norm_bound<Real>)*v.norm();
    CHECK(distance(rotate(p * q, v), rotate(p, rotate(q, v))) <= bound);
  }
}

TEST_CASE_TEMPLATE("A turn about the body's own axis multiplies on the right", Real,
                   EVERY_PRECISION) {
  std::mt19937_64 generator(17);
  for (int trial = 0; trial < 1000; ++trial) {
    const Quaternion<Real> orientation = random_orientation<Real>(generator);
    const Vec3<Real> axis_body = random_vector<Real>(generator).normalized();
    const Vec3<Real> axis_world = rotate(orientation, axis_body);
    const Real angle = 3 * random_number<Real>(generator);
    // Two products, one axis rotated, two sines and cosines.
    CHECK(distance(orientation * quaternion_about(axis_body, angle),
                   quaternion_about(axis_world, angle) * orientation) <=
          2 * rotate_bound<Real> + (14 + 16) * unit_roundoff<Real> + 2 * norm_bound<Real>);
  }
}

TEST_CASE_TEMPLATE("Turning a scene by 90 degrees turns what rotate gives with it, to the bit",
                   Real, EVERY_PRECISION) {
  // An axis' sign changes and two axes change places: no operation can round differently.
  const auto turned = [](const Vec3<Real>& v) { return Vec3<Real>(-v.y(), v.x(), v.z()); };
  std::mt19937_64 generator(18);
  for (int trial = 0; trial < 1000; ++trial) {
    const Quaternion<Real> q = random_orientation<Real>(generator);
    const Vec3<Real> v = random_vector<Real>(generator);
    const Quaternion<Real> seen = {.real = q.real, .imaginary = turned(q.imaginary)};
    CHECK(same_bits(rotate(seen, turned(v)), turned(rotate(q, v))));
  }
}
