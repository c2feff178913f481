#include <numbers>
#include <support/random_quaternion.hpp>
#include <tumble/orientation.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

/// A step's roundings as an angle: exponential 8, product 7 and norm 8 in a component, and the
/// angle is twice what the vector of components is off, √4 times one.
template <class Real>
constexpr Real step_bound = 2 * 2 * (8 + 7 + 8) * unit_roundoff<Real>;

}  // namespace

TEST_CASE_TEMPLATE("The rate of an orientation is half omega times q: the difference tends to it",
                   Real, EVERY_PRECISION) {
  std::mt19937_64 generator(71);
  const Quaternion<Real> q = random_orientation<Real>(generator);
  const Vec3<Real> omega(Real(0.5), -2, 1);
  const auto error = [&](Real h) {
    // Rotations turn vectors; what they do is all that is asked here of q(t + h).
    const Quaternion<Real> later = quaternion_about(omega, h * omega.norm()) * q;
    return norm((1 / h) * (later + -q) + -orientation_rate(q, omega));
  };
  for (const Real h : {Real(0.04), Real(0.02), Real(0.01)}) {
    CHECK(error(h) / error(h / 2) > Real(1.9));  // first order: half the time, half the error
    CHECK(error(h) / error(h / 2) < Real(2.1));
  }
}

TEST_CASE_TEMPLATE("A point fixed to the body moves with omega cross r", Real, EVERY_PRECISION) {
  std::mt19937_64 generator(72);
  for (int trial = 0; trial < 100; ++trial) {
    const Quaternion<Real> q = random_orientation<Real>(generator);
    const Vec3<Real> omega = random_vector<Real>(generator), body = random_vector<Real>(generator);
    // The central difference has no second-order part; its third is h²|ω|³|r|/6 at most.
    const Real h = Real(1e-3);
    const Vec3<Real> velocity = (rotate(turn_exponential(q, omega, h), body) -
                                 rotate(turn_exponential(q, omega, -h), body)) /
                                (2 * h);
    const Real size = omega.norm(), r = body.norm();
    const Real bound = h * h * size * size * size * r / 6 + step_bound<Real> / h * r;
    CHECK(distance<Real>(velocity, omega.cross(rotate(q, body))) <= bound);
  }
}

TEST_CASE_TEMPLATE("World omega on the left and body omega on the right are one motion", Real,
                   EVERY_PRECISION) {
  std::mt19937_64 generator(73);
  for (int trial = 0; trial < 1000; ++trial) {
    const Quaternion<Real> q = random_orientation<Real>(generator);
    const Vec3<Real> omega_body = 20 * random_vector<Real>(generator),
                     omega_world = rotate(q, omega_body);
    const Real h = Real(1) / 16;
    // To carry omega over costs 23 roundings in each component.
    const Real carried = 40 * h * omega_body.norm() * unit_roundoff<Real>;
    CHECK(angle_between(turn_exponential(q, omega_world, h),
                        turn_exponential_body(q, omega_body, h)) <= 2 * step_bound<Real> + carried);
    CHECK(angle_between(turn_first_order(q, omega_world, h),
                        turn_first_order_body(q, omega_body, h)) <= 2 * step_bound<Real> + carried);
    CHECK(distance(orientation_rate(q, omega_world), orientation_rate_body(q, omega_body)) <=
          (40 + 14) * unit_roundoff<Real> * omega_body.norm());
  }
}

TEST_CASE_TEMPLATE("The exponential turns by omega h, the first-order rule by 2 atan(omega h / 2)",
                   Real, EVERY_PRECISION) {
  std::mt19937_64 generator(74);
  const Real h = Real(1) / 64;
  for (const Real turn : {Real(1e-6), Real(0.01), Real(0.1), Real(1), Real(2), Real(3)})
    for (int trial = 0; trial < 50; ++trial) {
      CAPTURE(turn);
      const Quaternion<Real> q = random_orientation<Real>(generator);
      const Vec3<Real> axis = random_vector<Real>(generator).normalized(), omega = turn / h * axis;
      const Real bound = step_bound<Real> + 8 * turn * unit_roundoff<Real>;

      const Quaternion<Real> exact = turn_exponential(q, omega, h) * conjugate(q);
      CHECK(distance<Real>(rotation_vector_of(exact), turn * axis) <= bound);

      const Quaternion<Real> first = turn_first_order(q, omega, h) * conjugate(q);
      CHECK(distance<Real>(rotation_vector_of(first), 2 * std::atan(turn / 2) * axis) <= bound);
    }
}

TEST_CASE_TEMPLATE("The first-order rule turns by 0.9992, 0.9273 and 0.6552 of 0.1, 1 and 3 rad",
                   Real, EVERY_PRECISION) {
  const auto ratio = [](Real turn) {
    const Quaternion<Real> q;
    return angle_between(q, turn_first_order(q, Vec3<Real>(0, 0, turn), 1)) / turn;
  };
  const Real half_a_digit = Real(0.00005);
  CHECK(std::abs(ratio(Real(0.1)) - Real(0.9992)) <= half_a_digit);
  CHECK(std::abs(ratio(Real(1)) - Real(0.9273)) <= half_a_digit);
  CHECK(std::abs(ratio(Real(3)) - Real(0.6552)) <= half_a_digit);
}

TEST_CASE_TEMPLATE("Under constant omega the body spins steadily, by both rules", Real,
                   EVERY_PRECISION) {
  const Vec3<Real> axis = Vec3<Real>(1, 2, -2) / 3;
  const Real turn = Real(0.1);
  Quaternion<Real> exact, first;
  for (int n = 1; n <= 1000; ++n) {
    exact = turn_exponential(exact, axis, turn);
    first = turn_first_order(first, axis, turn);
    const Real bound = Real(n) * (step_bound<Real> + 4 * unit_roundoff<Real>);
    REQUIRE(angle_between(exact, quaternion_about(axis, Real(n) * turn)) <= bound);
    REQUIRE(angle_between(first, quaternion_about(axis, Real(n) * 2 * std::atan(turn / 2))) <=
            bound);
  }
}

TEST_CASE_TEMPLATE("Without turning the orientation stays as it is, to the bit", Real,
                   EVERY_PRECISION) {
  std::mt19937_64 generator(75);
  const Vec3<Real> none = Vec3<Real>::Zero();
  for (int trial = 0; trial < 1000; ++trial) {
    const Quaternion<Real> start = random_orientation<Real>(generator);
    Quaternion<Real> q = start;
    for (int n = 0; n < 10; ++n) {
      q = turn_exponential(turn_first_order(q, none, Real(0.1)), none, Real(0.1));
      q = turn_exponential_body(turn_first_order_body(q, none, Real(0.1)), none, Real(0.1));
      q = turn_exponential(turn_first_order(q, Vec3<Real>(1, 2, 3), 0), Vec3<Real>(1, 2, 3), 0);
    }
    CHECK(same_bits(q, start));
  }
}

TEST_CASE_TEMPLATE("An omega too small to square turns without a NaN", Real, EVERY_PRECISION) {
  using Limits = std::numeric_limits<Real>;
  for (const Real omega : {Limits::denorm_min(), Limits::min(), std::sqrt(Limits::min())}) {
    const Vec3<Real> omega_world(0, 0, 4 * omega);
    for (const Quaternion<Real>& q : {turn_exponential<Real>({}, omega_world, Real(0.5)),
                                      turn_first_order<Real>({}, omega_world, Real(0.5))}) {
      CHECK(q.real == 1);
      CHECK(same_bits(q.imaginary, Vec3<Real>(0, 0, omega)));
    }
  }
}

TEST_CASE_TEMPLATE("A little more than half a turn one way is a little less the other way", Real,
                   EVERY_PRECISION) {
  std::mt19937_64 generator(76);
  const Real pi = std::numbers::pi_v<Real>;
  for (const Real over : {Real(0), Real(1e-3), Real(0.1), Real(1)})
    for (int trial = 0; trial < 50; ++trial) {
      CAPTURE(over);
      const Quaternion<Real> q = random_orientation<Real>(generator);
      const Vec3<Real> axis = random_vector<Real>(generator).normalized();
      CHECK(angle_between(turn_exponential(q, axis, pi + over),
                          turn_exponential(q, axis, over - pi)) <=
            2 * step_bound<Real> + 16 * pi * unit_roundoff<Real>);
    }
}

TEST_CASE_TEMPLATE("A step of many whole turns ends where its remainder would", Real,
                   EVERY_PRECISION) {
  const Real pi = std::numbers::pi_v<Real>;
  const Vec3<Real> axis(0, 0, 1);
  for (const int turns : {1, 2, 10, 100, 400}) {
    CAPTURE(turns);
    const Quaternion<Real> q = turn_exponential<Real>({}, axis, 2 * pi * Real(turns) + 1);
    // The request itself is rounded: twice, at its own size.
    const Real bound = step_bound<Real> + 2 * unit_roundoff<Real> * (2 * pi * Real(turns) + 1);
    CHECK(angle_between(q, quaternion_about(axis, 1)) <= bound);
  }
}
