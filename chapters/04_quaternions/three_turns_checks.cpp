#include <support/random_quaternion.hpp>
#include <tumble/rotation_vector.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

template <class Real>
Quaternion<Real> three_one_axis_turns(const Vec3<Real>& v) {
  return quaternion_about(Vec3<Real>(1, 0, 0), v.x()) *
         quaternion_about(Vec3<Real>(0, 1, 0), v.y()) *
         quaternion_about(Vec3<Real>(0, 0, 1), v.z());
}

template <class Real>
Real error_of_three_turns(const Vec3<Real>& v) {
  return angle_between(three_one_axis_turns(v), quaternion_of_rotation_vector(v));
}

}  // namespace

TEST_CASE_TEMPLATE("Three one-axis turns miss the one true turn by an error of second order", Real,
                   EVERY_PRECISION) {
  const Vec3<Real> direction = Vec3<Real>(1, 2, -2) / 3;
  for (const Real angle : {Real(0.4), Real(0.2), Real(0.1)}) {
    CAPTURE(angle);
    const Real ratio = error_of_three_turns<Real>(angle * direction) /
                       error_of_three_turns<Real>(angle / 2 * direction);
    // Half the angle, a quarter of the error, but for the next order: a part of size `angle`.
    CHECK(ratio > 4 * (1 - angle / 2));
    CHECK(ratio < 4 * (1 + angle / 2));
  }
}

TEST_CASE_TEMPLATE("What three turns miss begins with half the cross products of their vectors",
                   Real, EVERY_PRECISION) {
  std::mt19937_64 generator(31);
  for (int trial = 0; trial < 100; ++trial) {
    const Real angle = Real(0.02);
    const Vec3<Real> v = angle * random_vector<Real>(generator);
    const Real predicted = Vec3<Real>(v.y() * v.z(), v.x() * v.z(), v.x() * v.y()).norm() / 2;
    // The third order: each of its terms is a product of three angles, and all of them together
    // are less than |v|³.
    const Real third_order = v.norm() * v.squaredNorm(), rounding = 200 * unit_roundoff<Real>;
    CHECK(std::abs(error_of_three_turns(v) - predicted) <= third_order + rounding);
  }
}

TEST_CASE_TEMPLATE("Turns about one axis commute: there three factors and one turn agree", Real,
                   EVERY_PRECISION) {
  for (int axis = 0; axis < 3; ++axis) {
    Vec3<Real> v = Vec3<Real>::Zero();
    v[axis] = 2;
    CHECK(error_of_three_turns(v) <= 8 * unit_roundoff<Real>);
  }
}
