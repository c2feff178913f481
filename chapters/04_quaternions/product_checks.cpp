#include <support/random_quaternion.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

/// Each part of a product sums four products of components: four roundings, and three for the sums,
/// of at most |p| |q|.
template <class Real>
Real product_bound(const Quaternion<Real>& p, const Quaternion<Real>& q) {
  return 7 * unit_roundoff<Real> * norm(p) * norm(q);
}

template <class Real>
Eigen::Quaternion<Real> as_eigen(const Quaternion<Real>& q) {
  return {q.real, q.imaginary.x(), q.imaginary.y(), q.imaginary.z()};
}

template <class Real>
Quaternion<Real> from_eigen(const Eigen::Quaternion<Real>& q) {
  return {.real = q.w(), .imaginary = q.vec()};
}

}  // namespace

TEST_CASE_TEMPLATE("Our product equals Eigen's", Real, EVERY_PRECISION) {
  std::mt19937_64 generator(2);
  for (int trial = 0; trial < 1000; ++trial) {
    const Quaternion<Real> p = random_quaternion<Real>(generator),
                           q = random_quaternion<Real>(generator);
    CHECK(distance(p * q, from_eigen<Real>(as_eigen(p) * as_eigen(q))) <= 2 * product_bound(p, q));
  }
}

TEST_CASE_TEMPLATE("i, j and k square to -1, and so does ijk", Real, EVERY_PRECISION) {
  const Quaternion<Real> one, i = pure<Real>({1, 0, 0}), j = pure<Real>({0, 1, 0}),
                              k = pure<Real>({0, 0, 1});
  CHECK(same_bits(i * i, -one));
  CHECK(same_bits(j * j, -one));
  CHECK(same_bits(k * k, -one));
  CHECK(same_bits(i * j * k, -one));
}

TEST_CASE_TEMPLATE("ij = k, jk = i, ki = j, and in the other order the sign changes", Real,
                   EVERY_PRECISION) {
  const Quaternion<Real> i = pure<Real>({1, 0, 0}), j = pure<Real>({0, 1, 0}),
                         k = pure<Real>({0, 0, 1});
  CHECK(same_bits(i * j, k));
  CHECK(same_bits(j * k, i));
  CHECK(same_bits(k * i, j));
  CHECK(same_bits(j * i, -k));
  CHECK(same_bits(k * j, -i));
  CHECK(same_bits(i * k, -j));
}

TEST_CASE_TEMPLATE(
    "All sixteen products of components stand where the rules for i, j and k put them", Real,
    EVERY_PRECISION) {
  // Small whole numbers, so that nothing rounds: (1 + 2i + 3j + 5k)(7 + 11i + 13j + 17k).
  const Quaternion<Real> p = {.real = 1, .imaginary = {2, 3, 5}},
                         q = {.real = 7, .imaginary = {11, 13, 17}};
  CHECK(same_bits(p * q,
                  {.real = 1 * 7 - 2 * 11 - 3 * 13 - 5 * 17,
                   .imaginary = {1 * 11 + 2 * 7 + 3 * 17 - 5 * 13, 1 * 13 - 2 * 17 + 3 * 7 + 5 * 11,
                                 1 * 17 + 2 * 13 - 3 * 11 + 5 * 7}}));
}

TEST_CASE_TEMPLATE("A product of three does not depend on which two are multiplied first", Real,
                   EVERY_PRECISION) {
  std::mt19937_64 generator(4);
  for (int trial = 0; trial < 1000; ++trial) {
    const Quaternion<Real> p = random_quaternion<Real>(generator),
                           q = random_quaternion<Real>(generator),
                           r = random_quaternion<Real>(generator);
    CHECK(distance((p * q) * r, p * (q * r)) <= 4 * product_bound(p * q, r));
  }
}

TEST_CASE_TEMPLATE("The norm of a product is the product of the norms", Real, EVERY_PRECISION) {
  std::mt19937_64 generator(5);
  for (int trial = 0; trial < 1000; ++trial) {
    const Quaternion<Real> p = random_quaternion<Real>(generator),
                           q = random_quaternion<Real>(generator);
    // Four components of the product are off by product_bound() each, which the norm at most
    // doubles; each norm rounds four squares and sums, half of which the root passes on, and once
    // more.
    const Real bound = 2 * product_bound(p, q) + 3 * 4 * unit_roundoff<Real> * norm(p) * norm(q);
    CHECK(std::abs(norm(p * q) - norm(p) * norm(q)) <= bound);
  }
}

TEST_CASE_TEMPLATE("A quaternion times its conjugate is the square of its norm", Real,
                   EVERY_PRECISION) {
  std::mt19937_64 generator(6);
  for (int trial = 0; trial < 1000; ++trial) {
    const Quaternion<Real> q = random_quaternion<Real>(generator);
    const Real square = norm(q) * norm(q);
    const Real bound = product_bound(q, q) + 9 * unit_roundoff<Real> * square;
    CHECK(distance(q * conjugate(q), {.real = square}) <= bound);
    CHECK(distance(conjugate(q) * q, {.real = square}) <= bound);
  }
}

TEST_CASE_TEMPLATE("Against a witness in long double a product rounds no more than its terms allow",
                   Real, float, double) {
  std::mt19937_64 generator(7);
  for (int trial = 0; trial < 1000; ++trial) {
    const Quaternion<Real> p = random_quaternion<Real>(generator),
                           q = random_quaternion<Real>(generator);
    const Quaternion<long double> exact = cast<long double>(p) * cast<long double>(q);
    CHECK(distance(cast<long double>(p * q), exact) <= product_bound(p, q));
  }
}

TEST_CASE_TEMPLATE("A normalised quaternion has norm 1 and the direction it had", Real,
                   EVERY_PRECISION) {
  std::mt19937_64 generator(8);
  for (int trial = 0; trial < 1000; ++trial) {
    const Quaternion<Real> q = random_quaternion<Real>(generator), unit = normalized(q);
    // The norm rounds by 3 at most, its inverse and the four products once each.
    CHECK(std::abs(norm(unit) - 1) <= (3 + 2 + 3) * unit_roundoff<Real>);
    CHECK(distance(norm(q) * unit, q) <= (3 + 2 + 3 + 1) * unit_roundoff<Real> * norm(q));
  }
}

TEST_CASE_TEMPLATE(
    "To renormalise what is normalised changes no bit; to normalise it again may change bits for "
    "ever",
    Real, EVERY_PRECISION) {
  std::mt19937_64 generator(9);
  int changed_by_plain_normalising = 0, changed_for_ever = 0;
  for (int trial = 0; trial < 10'000; ++trial) {
    const Quaternion<Real> q = random_quaternion<Real>(generator), unit = normalized(q);
    CHECK(same_bits(renormalized(unit), unit));
    // Whether it is far off or a little: left alone are 16 roundings of the square, 8 of the norm,
    // and to measure it costs 3.
    for (const Real size : {Real(3), 1 - 20 * unit_roundoff<Real>, 1 + 20 * unit_roundoff<Real>})
      CHECK(std::abs(norm(renormalized(size * unit)) - 1) <= (8 + 3) * unit_roundoff<Real>);
    changed_by_plain_normalising += !same_bits(normalized(unit), unit);
    // What has come back to an earlier value by way of another one will do so for ever.
    Quaternion<Real> late = unit;
    for (int n = 0; n < 10; ++n) late = normalized(late);
    const Quaternion<Real> next = normalized(late);
    changed_for_ever += !same_bits(next, late) && same_bits(normalized(next), late);
  }
  CHECK(changed_by_plain_normalising > 0);  // so that there is something to prevent
  CHECK(changed_for_ever > 1000);           // more than one in ten
}
