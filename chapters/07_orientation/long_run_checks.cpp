#include <support/bad_vectors.hpp>
#include <support/random_quaternion.hpp>
#include <tumble/orientation.hpp>

using namespace tumble;
using namespace tumble::support;

TEST_CASE_TEMPLATE("Not normalised, the norm grows by the root of 1 + (omega h / 2)^2 every step",
                   Real, EVERY_PRECISION) {
  const Vec3<Real> axis = Vec3<Real>(1, 2, -2) / 3;
  for (const Real turn : {Real(0.1), Real(0.5), Real(1)}) {
    CAPTURE(turn);
    Quaternion<Real> q;
    Real predicted = 1;
    for (int n = 1; n <= 50; ++n) {
      q = q + turn * orientation_rate(q, axis);
      predicted *= std::sqrt(1 + turn * turn / 4);
      // Rate, product and sum round a component by 12 at most, the axis' length and the prediction
      // by 4 more.
      REQUIRE(std::abs(norm(q) - predicted) <=
              Real(n) * 2 * (12 + 4) * unit_roundoff<Real> * predicted);
    }
  }
}

TEST_CASE_TEMPLATE("However many steps it takes, the norm stays 1 to a few roundings", Real,
                   EVERY_PRECISION) {
  std::mt19937_64 generator(77);
  Quaternion<Real> exact, first, exact_body, first_body;
  Real worst = 0;
  for (int n = 0; n < 100'000; ++n) {
    const Vec3<Real> omega = random_vector<Real>(generator);
    const Real h = Real(n % 100) / 50;
    exact = turn_exponential(exact, omega, h);
    first = turn_first_order(first, omega, h);
    exact_body = turn_exponential_body(exact_body, omega, h);
    first_body = turn_first_order_body(first_body, omega, h);
    for (const Quaternion<Real>& q : {exact, first, exact_body, first_body})
      worst = std::max(worst, std::abs(norm(q) - 1));
  }
  // Left alone within 16 units of roundoff of the square, 8 of the norm; and 3 for measuring it.
  CHECK(worst <= (8 + 3) * unit_roundoff<Real>);
}

TEST_CASE_TEMPLATE(
    "From no turn a million turns of a ten-millionth make a tenth, in float within 8 per cent",
    Real, EVERY_PRECISION) {
  const int steps = 1'000'000;
  const Vec3<Real> omega(0, 0, Real(1e-7));
  Quaternion<Real> exact, first;
  for (int n = 0; n < steps; ++n) {
    exact = turn_exponential(exact, omega, 1);
    first = turn_first_order(first, omega, 1);
  }
  // From rest the part along k is at most 0.05 and the sum that makes it rounds once, at most by
  // half a unit of its last place, 0.0625 roundings of 1; a turn is twice that. In float that is
  // a thirteenth of each turn at worst.
  const Real bound = steps * 2 * Real(0.0625) * unit_roundoff<Real> + 4 * unit_roundoff<Real>;
  CHECK(std::abs(angle_between({}, exact) - Real(0.1)) <= bound);
  CHECK(std::abs(angle_between({}, first) - Real(0.1)) <= bound);
}

TEST_CASE_TEMPLATE("In double, turns of a ten-millionth of a radian add up from any orientation",
                   Real, double) {
  std::mt19937_64 generator(78);
  const int steps = 100'000;
  const Quaternion<Real> start = random_orientation<Real>(generator);
  const Vec3<Real> omega = Real(1e-7) * random_vector<Real>(generator).normalized();
  Quaternion<Real> exact = start, first = start;
  for (int n = 0; n < steps; ++n) {
    exact = turn_exponential(exact, omega, 1);
    first = turn_first_order(first, omega, 1);
  }
  // A component's sum of four rounds by 3, and 8 in the norm do not turn; twice that as an angle
  // of four components.
  const Real bound = steps * 2 * 2 * 4 * unit_roundoff<Real>;
  CHECK(std::abs(angle_between(start, exact) - Real(0.01)) <= bound);
  CHECK(std::abs(angle_between(start, first) - Real(0.01)) <= bound);
  CHECK(bound < Real(1e-9));
}

TEST_CASE_TEMPLATE("Under constant omega the first-order rule loses angle by second order", Real,
                   EVERY_PRECISION) {
  const Vec3<Real> omega(0, 0, 1);
  const auto lost = [&](int steps) {  // in one turn of 1 rad
    Quaternion<Real> q;
    for (int n = 0; n < steps; ++n) q = turn_first_order(q, omega, 1 / Real(steps));
    return 1 - angle_between({}, q);
  };
  for (const int steps : {2, 4, 8}) {
    CHECK(lost(steps) / lost(2 * steps) > Real(3.8));
    CHECK(lost(steps) / lost(2 * steps) < Real(4.2));
    // A step loses x³/12 of its angle x, less x⁵/80.
    const Real x = 1 / Real(steps);
    CHECK(std::abs(lost(steps) - x * x / 12) <= x * x * x * x / 80 + 100 * unit_roundoff<Real>);
  }
}

TEST_CASE_TEMPLATE("When omega changes, either rule is of the order of the omega it is given", Real,
                   double) {
  // A cone: a body that spins about its own axis while that axis goes round z. What it has turned
  // is known: q(t) = e^(tΩ/2) e^(ts/2), and its angular velocity is Ω + s carried round.
  const Vec3<Real> precession(0, 0, 1), spin(2, 0, 1);
  const auto orientation = [&](Real t) {
    return quaternion_of_rotation_vector<Real>(t * precession) *
           quaternion_of_rotation_vector<Real>(t * spin);
  };
  const auto omega = [&](Real t) {
    const Quaternion<Real> carried = quaternion_of_rotation_vector<Real>(t * precession);
    return Vec3<Real>(precession + rotate(carried, spin));
  };
  const auto error = [&](auto rule, int steps, Real asked_at) {
    const Real h = 1 / Real(steps);
    Quaternion<Real> q;
    for (int n = 0; n < steps; ++n) q = rule(q, omega((Real(n) + asked_at) * h), h);
    return angle_between(q, orientation(1));
  };
  const auto ratio = [&](auto rule, Real asked_at) {
    return error(rule, 64, asked_at) / error(rule, 128, asked_at);
  };
  const auto exponential = [](const auto& q, const auto& w, Real h) {
    return turn_exponential(q, w, h);
  };
  const auto first_order = [](const auto& q, const auto& w, Real h) {
    return turn_first_order(q, w, h);
  };
  for (const Real at : {Real(0), Real(1)}) {  // the start of the step, or its end
    CHECK(std::abs(ratio(exponential, at) - 2) < Real(0.1));
    CHECK(std::abs(ratio(first_order, at) - 2) < Real(0.1));
  }
  CHECK(std::abs(ratio(exponential, Real(0.5)) - 4) < Real(0.1));  // the middle
  CHECK(std::abs(ratio(first_order, Real(0.5)) - 4) < Real(0.1));
}

TEST_CASE_TEMPLATE("A scene turned as a whole turns its bodies as before, to a few roundings", Real,
                   EVERY_PRECISION) {
  std::mt19937_64 generator(79);
  for (int trial = 0; trial < 1000; ++trial) {
    const Quaternion<Real> scene = random_orientation<Real>(generator),
                           q = random_orientation<Real>(generator);
    const Vec3<Real> omega = random_vector<Real>(generator);
    const Quaternion<Real> then_turned = scene * turn_exponential(q, omega, 2),
                           turned_first =
                               turn_exponential<Real>(scene * q, rotate(scene, omega), 2);
    // Four products, an exponential and a rotated omega on each side, and their norms.
    CHECK(angle_between(then_turned, turned_first) <= 400 * unit_roundoff<Real>);
  }
}

TEST_CASE_TEMPLATE("A turn too large for a step is refused by name, size and limit", Real,
                   EVERY_PRECISION) {
  const auto complaint = [](const Vec3<Real>& omega, Real h) {
    return complaint_of([&] { require_turn(omega, h); });
  };
  const Real nan = std::numeric_limits<Real>::quiet_NaN(),
             limit = 2 * SineCosineConstants<Real>::limit;
  check_refuses_bad_vectors<Real>("angular velocity", "rad/s",
                                  [](const Vec3<Real>& bad) { require_turn(bad, 1); });
  CHECK(complaint({0, 1, 0}, nan) == "time step is nan s; it must be finite");
  CHECK(complaint({0, 0, 2 * limit}, 1) == "turn in one step is " + text_of(2 * limit) +
                                               " rad; it must lie between 0 and " + text_of(limit) +
                                               " rad");
  CHECK(complaint({0, 0, limit}, 1) == "nothing thrown");
  // It is the length that turns: neither of these components is too large by itself.
  CHECK(complaint({Real(0.75) * limit, -Real(0.75) * limit, 0}, 1) != "nothing thrown");
  CHECK(complaint({Real(0.5) * limit, -Real(0.75) * limit, 0}, 1) == "nothing thrown");
  CHECK(complaint({0, 0, 2 * limit}, Real(0.5)) == "nothing thrown");
  CHECK(complaint({0, 0, limit}, -2) != "nothing thrown");
  CHECK(std::isfinite(turn_exponential<Real>({}, Vec3<Real>(0, 0, limit), 1).real));
  CHECK(std::isnan(turn_exponential<Real>({}, Vec3<Real>(0, 0, 2 * limit), 1).real));
}

TEST_CASE_TEMPLATE("Every turn that is accepted can be made, to the last bit of the limit", Real,
                   EVERY_PRECISION) {
  std::mt19937_64 generator(11);
  const Real limit = 2 * SineCosineConstants<Real>::limit, h = Real(1) / 60;
  int passed = 0, refused = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    const Vec3<Real> direction = random_vector<Real>(generator);
    const Vec3<Real> omega = direction * (limit / (h * direction.norm()));
    const bool answered = complaint_of([&] { require_turn(omega, h); }) == "nothing thrown";
    (answered ? passed : refused) += 1;
    CHECK(answered == std::isfinite(turn_exponential<Real>({}, omega, h).real));
    CHECK(answered == std::isfinite(turn_exponential_body<Real>({}, omega, h).real));
  }
  // At the limit rounding alone decides, so there are some of either kind.
  CHECK(passed > 100);
  CHECK(refused > 100);
}
