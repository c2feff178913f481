#include <numbers>
#include <support/random_quaternion.hpp>
#include <tumble/rotation_vector.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

/// Lengths of rotation vectors from the smallest number that has all its digits up to almost π.
template <class Real>
std::vector<Real> lengths_below_half_a_turn() {
  std::vector<Real> lengths = {Real(3.14), 3, 2, 1, Real(0.1)};
  for (Real length = Real(0.01); length > std::numeric_limits<Real>::min(); length /= 1000)
    lengths.push_back(length);
  lengths.push_back(std::numeric_limits<Real>::min());
  return lengths;
}

using Witness = Quaternion<long double>;

/// By the definition, with the standard library's sine, in long double.
template <class Real>
Witness exact_exponential(const Vec3<Real>& rotation_vector) {
  const Vec3<long double> v = rotation_vector.template cast<long double>();
  const long double angle = std::hypot(v.x(), v.y(), v.z());
  if (angle == 0) return {};
  return {.real = std::cos(angle / 2), .imaginary = std::sin(angle / 2) * (v / angle)};
}

/// By the definition, in long double: 2 atan2(|u|, w) along u.
template <class Real>
Vec3<long double> exact_logarithm(const Quaternion<Real>& q) {
  const Vec3<long double> u = q.imaginary.template cast<long double>();
  const long double size = std::hypot(u.x(), u.y(), u.z()), real = q.real;
  const long double sign = real < 0 ? -1 : 1;
  return sign * 2 * std::atan2(size, sign * real) * (u / size);
}

}  // namespace

// The length rounds 2.5 times, which sin x / x passes on in part; sine, quotient and product round
// another 2, 1 and 1 times.
TEST_CASE_TEMPLATE("The exponential keeps its digits from the smallest turn to a whole one", Real,
                   EVERY_PRECISION) {
  std::mt19937_64 generator(21);
  for (const Real length : lengths_below_half_a_turn<Real>())
    for (int trial = 0; trial < 50; ++trial) {
      CAPTURE(length);
      const Vec3<Real> v = length * random_vector<Real>(generator).normalized();
      for (const Vec3<Real>& vector : {v, Vec3<Real>(2 * v)}) {
        const Quaternion<Real> ours = quaternion_of_rotation_vector(vector);
        const Witness exact = exact_exponential(vector);
        const Real largest = std::min<Real>(1, length);
        CHECK(std::abs(ours.real - exact.real) <= 8 * unit_roundoff<Real>);
        CHECK(distance<long double>(ours.imaginary.template cast<long double>(), exact.imaginary) <=
              8 * unit_roundoff<Real> * largest + std::numeric_limits<Real>::denorm_min());
      }
    }
}

TEST_CASE_TEMPLATE("A rotation vector too small to square turns by its half, to the bit", Real,
                   EVERY_PRECISION) {
  using Limits = std::numeric_limits<Real>;
  for (const Real size : {2 * Limits::denorm_min(), Limits::min(), 1024 * Limits::min()}) {
    const Vec3<Real> v(size, -4 * size, 0);
    const Quaternion<Real> q = quaternion_of_rotation_vector(v);
    CHECK(q.real == 1);
    CHECK(same_bits(q.imaginary, v / 2));
    CHECK(same_bits(rotation_vector_of(q), v));
  }
  CHECK(same_bits(quaternion_of_rotation_vector(Vec3<Real>(0, 0, 0)), Quaternion<Real>()));
  CHECK(same_bits(rotation_vector_of(Quaternion<Real>()), Vec3<Real>(0, 0, 0)));
}

TEST_CASE_TEMPLATE(
    "The exponential keeps norm 1 and its angle up to its limit, hundreds of whole turns away",
    Real, EVERY_PRECISION) {
  std::mt19937_64 generator(22);
  const Real limit = 2 * SineCosineConstants<Real>::limit;
  CHECK(limit > 400 * 2 * std::numbers::pi_v<Real>);
  for (const Real length :
       {Real(4), Real(10), Real(100), Real(3000), limit / 2, limit * Real(0.99)})
    for (int trial = 0; trial < 50; ++trial) {
      CAPTURE(length);
      const Vec3<Real> v = length * random_vector<Real>(generator).normalized();
      const Quaternion<Real> q = quaternion_of_rotation_vector(v);
      CHECK(std::abs(norm(q) - 1) <= 12 * unit_roundoff<Real>);
      // The length of v itself can only be had to 2.5 roundings, and half of that is the error.
      CHECK(distance<long double>(cast<long double>(q), exact_exponential(v)) <=
            (8 + Real(1.25) * length) * unit_roundoff<Real>);
    }
  CHECK(std::isnan(quaternion_of_rotation_vector(Vec3<Real>(2 * limit, 0, 0)).real));
}

// The size rounds 2.5 times, arc tangent, quotient and product once each.
TEST_CASE_TEMPLATE("The logarithm keeps its digits from the smallest turn to half a turn", Real,
                   EVERY_PRECISION) {
  std::mt19937_64 generator(23);
  for (const Real length : lengths_below_half_a_turn<Real>())
    for (int trial = 0; trial < 50; ++trial) {
      CAPTURE(length);
      const Quaternion<Real> q =
          quaternion_of_rotation_vector<Real>(length * random_vector<Real>(generator).normalized());
      const Vec3<long double> exact = exact_logarithm(q);
      CHECK(distance<long double>(rotation_vector_of(q).template cast<long double>(), exact) <=
            7 * unit_roundoff<Real> * length + 2 * std::numeric_limits<Real>::denorm_min());
    }
}

TEST_CASE_TEMPLATE("Below half a turn the logarithm gives back what the exponential was given",
                   Real, EVERY_PRECISION) {
  std::mt19937_64 generator(24);
  for (const Real length : lengths_below_half_a_turn<Real>())
    for (int trial = 0; trial < 50; ++trial) {
      CAPTURE(length);
      const Vec3<Real> v = length * random_vector<Real>(generator).normalized();
      // An exponential off by 8 in each of four components, twice that in the angle; and the
      // logarithm's 7.
      const Real bound = (2 * 2 * 8 + 7) * unit_roundoff<Real> * length;
      CHECK(distance(rotation_vector_of(quaternion_of_rotation_vector(v)), v) <=
            bound + 2 * std::numeric_limits<Real>::denorm_min());
    }
}

TEST_CASE_TEMPLATE("Beyond half a turn the logarithm takes the shorter way round", Real,
                   EVERY_PRECISION) {
  const Real pi = std::numbers::pi_v<Real>;
  const Vec3<Real> axis = Vec3<Real>(0, 3, -4) / 5;
  for (const Real over : {Real(0.001), Real(0.1), Real(1), Real(3)}) {
    const Vec3<Real> shortest =
        rotation_vector_of(quaternion_of_rotation_vector<Real>((pi + over) * axis));
    CHECK(distance<Real>(shortest, (over - pi) * axis) <= 2 * (8 + 7) * pi * unit_roundoff<Real>);
  }
}

TEST_CASE_TEMPLATE("A turn by exactly 180 degrees has a logarithm of length pi", Real,
                   EVERY_PRECISION) {
  for (const Real sign : {Real(1), Real(-1)}) {
    const Vec3<Real> v = rotation_vector_of<Real>({.real = 0, .imaginary = {0, sign, 0}});
    CHECK(std::abs(v.norm() - std::numbers::pi_v<Real>) <= 8 * unit_roundoff<Real>);
    CHECK(v.x() == 0);
    CHECK(v.z() == 0);
  }
}

TEST_CASE_TEMPLATE("q and minus q have one logarithm, to the bit", Real, EVERY_PRECISION) {
  std::mt19937_64 generator(25);
  for (int trial = 0; trial < 1000; ++trial) {
    const Quaternion<Real> q = random_orientation<Real>(generator);
    CHECK(same_bits(rotation_vector_of(q), rotation_vector_of(-q)));
  }
  const Quaternion<Real> half_turn = {.real = 0, .imaginary = {1, 0, 0}};
  CHECK(same_bits(rotation_vector_of(half_turn), rotation_vector_of(-half_turn)));
}

TEST_CASE_TEMPLATE("The angle between two orientations keeps its digits down to the smallest", Real,
                   EVERY_PRECISION) {
  const Quaternion<Real> none;
  for (const Real angle : lengths_below_half_a_turn<Real>()) {
    CAPTURE(angle);
    const Quaternion<Real> q = quaternion_about(Vec3<Real>(1, -2, 3), angle);
    CHECK(std::abs(angle_between(none, q) - angle) <=
          20 * unit_roundoff<Real> * angle + 4 * std::numeric_limits<Real>::denorm_min());
    CHECK(angle_between(none, -q) == angle_between(none, q));
  }
}

TEST_CASE_TEMPLATE("The angle between two orientations is that of the turn from one to the other",
                   Real, EVERY_PRECISION) {
  std::mt19937_64 generator(26);
  for (int trial = 0; trial < 1000; ++trial) {
    const Quaternion<Real> p = random_orientation<Real>(generator);
    const Real angle = std::numbers::pi_v<Real> * std::abs(random_number<Real>(generator));
    const Quaternion<Real> q = quaternion_about(random_vector<Real>(generator), angle) * p;
    // Two products of 7 roundings, an exponential of 8 and a norm of 8; twice that as an angle.
    const Real bound = 2 * 2 * (7 + 7 + 8 + 8) * unit_roundoff<Real>;
    CHECK(std::abs(angle_between(p, q) - angle) <= bound);
    CHECK(std::abs(angle_between(q, p) - angle) <= bound);
    CHECK(std::abs(angle_between(p, -q) - angle) <= bound);
  }
}

TEST_CASE_TEMPLATE("The length of an axis does not matter, from the smallest to the largest", Real,
                   EVERY_PRECISION) {
  using Limits = std::numeric_limits<Real>;
  const Quaternion<Real> expected = quaternion_about(Vec3<Real>(1, -2, 2), Real(2.5));
  CHECK(std::abs(angle_between({}, expected) - Real(2.5)) <= 20 * unit_roundoff<Real>);
  for (const Real size : {Limits::min(), Real(1e-20), Real(3), Real(1e20), Limits::max() / 4})
    CHECK(distance(quaternion_about<Real>(size * Vec3<Real>(1, -2, 2), Real(2.5)), expected) <=
          12 * unit_roundoff<Real>);
}
