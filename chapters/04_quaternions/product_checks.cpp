#include <course/random_quaternion.hpp>

using namespace tumble;
using namespace tumble::course;

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
