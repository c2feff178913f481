#include <random>
#include <support/checks.hpp>
#include <support/damping_forms.hpp>
#include <support/uneven_top.hpp>
#include <tumble/damping.hpp>

using namespace tumble;
using namespace tumble::support;

TEST_CASE_TEMPLATE("Exponential damping leaves exp(-k t), however the time is cut into steps", Real,
                   EVERY_PRECISION) {
  const Real rate = Real(0.7), time = 2;
  const long double exact = std::exp(-static_cast<long double>(rate) * time);
  const auto left_after = [rate](const std::vector<Real>& steps) {
    Particle<Real> particle =
        make_particle(Real(3), Vec3<Real>(Vec3<Real>::Zero()), Vec3<Real>(1, -1, 1));
    for (const Real time_step : steps) damp(particle, fraction_kept(rate, time_step));
    CHECK(particle.velocity.y() == -particle.velocity.x());
    return particle.velocity.x();
  };
  // Each step rounds its length, k h and the exponential (within 1 unit in the last place, that is
  // 2 u) and the product. The first two count by k h only, and sum to k t.
  const auto bound = [rate, time](std::size_t steps) {
    return (Real(3 * steps) + 3 * rate * time) * unit_roundoff<Real>;
  };
  for (const std::size_t steps : {1u, 10u, 60u, 144u, 1000u}) {
    CAPTURE(steps);
    const std::vector<Real> even(steps, time / Real(steps));
    CHECK(std::abs(Real(left_after(even) / exact - 1)) <= bound(steps));
    if (sizeof(Real) >= sizeof(double)) CHECK(bound(steps) < Real(1e-12));
  }
  // And with every step of another length. Powers of two as a unit make the rest of the time exact.
  std::mt19937_64 generator(9);
  std::vector<Real> uneven;
  Real rest = time;
  while (rest > 0) {
    uneven.push_back(std::min(rest, Real(1 + generator() % 64) / 1024));
    rest -= uneven.back();
  }
  CHECK(std::abs(Real(left_after(uneven) / exact - 1)) <= bound(uneven.size()));
}

TEST_CASE("The linear form damps too much and the fractional one too little, by k^2 h t / 2") {
  const double rate = 0.7, time = 2;
  const auto off = [=](double (*form)(double, double), int steps) {
    return std::pow(form(rate, time / steps), steps) / std::exp(-rate * time) - 1;
  };
  for (const int steps : {100, 200, 400}) {
    const double predicted = rate * rate * time * time / steps / 2;
    // The next term is (k h)² k t / 3, smaller by 2 k h / 3, and the square of the first.
    const double next = 2 * predicted * rate * time / steps + predicted * predicted;
    CHECK(std::abs(off(linear_form, steps) + predicted) <= next);
    CHECK(std::abs(off(fractional_form, steps) - predicted) <= next);
  }
  CHECK(std::abs(std::pow(power_form(0.25, time / 100), 100) / 0.0625 - 1) < 1e-13);
}

TEST_CASE("Beyond k h = 1 the linear form turns a body round, beyond 2 it speeds it up") {
  const auto left = [](double kh, int steps) { return std::pow(linear_form(kh, 1.0), steps); };
  CHECK(left(0.9, 1) > 0);
  CHECK(left(1.1, 1) < 0);
  CHECK(std::abs(left(1.99, 1000)) < 1e-4);
  CHECK(std::abs(left(2.01, 1000)) > 1e4);
  for (const double kh : {0.9, 1.1, 1.99, 2.01, 50.0}) {
    CHECK(fraction_kept(kh, 1.0) > 0);
    CHECK(fraction_kept(kh, 1.0) < 1);
    CHECK(fractional_form(kh, 1.0) > 0);
    CHECK(fractional_form(kh, 1.0) < 1);
  }
}

TEST_CASE_TEMPLATE("A rate found from a fraction leaves that fraction, at every frame rate", Real,
                   EVERY_PRECISION) {
  const Real rate = damping_rate_that_leaves(Real(0.99), Real(1) / 60);
  // The logarithm of a number near 1 magnifies nothing: it is exact for the rounded 0.99.
  CHECK(std::abs(fraction_kept(rate, Real(1) / 60) - Real(0.99)) <= 4 * unit_roundoff<Real>);
  for (const int frames_per_second : {30, 60, 144}) {
    const Real step = fraction_kept(rate, Real(1) / Real(frames_per_second));
    const Real second = std::pow(step, Real(frames_per_second)),
               expected = std::pow(Real(0.99), Real(60));
    // 144 times the rounding of one factor, twice that of its exponent, and those of pow.
    CHECK(std::abs(second / expected - 1) <= (4 * 144 + 8) * unit_roundoff<Real>);
  }
  CHECK(damping_rate_that_leaves(Real(1), Real(5)) == 0);
  CHECK(damping_rate_that_leaves(Real(0.25), Real(2)) == std::log(Real(4)) / 2);
}

TEST_CASE_TEMPLATE(
    "Damped by 0.1 per second and free of forces, speed, turning energy and |L| fall in every step",
    Real, EVERY_PRECISION) {
  RigidBody<Real> body{
      .centre = make_particle(Real(2), Vec3<Real>(Vec3<Real>::Zero()), Vec3<Real>(3, -4, 12)),
      .top = uneven_top(Vec3<Real>(1, 2, Real(0.5)))};
  const Real time_step = Real(1) / 60;
  const Real kept = fraction_kept(Real(0.1), time_step);
  for (int n = 0; n < 3000; ++n) {
    const Real speed = body.centre.velocity.norm(), energy = kinetic_energy(body.top),
               momentum = body.top.angular_momentum_body.norm();
    kick(body.centre, time_step);
    kick(body.top, time_step);
    damp(body.centre, kept);
    damp(body.top, kept);
    drift(body.centre, time_step);
    drift(body.top, time_step);
    // Chapter 8's rule keeps |L|, and moves the energy by at most 2e-5 of itself on this top. A
    // step of damping takes 3e-3.
    REQUIRE(body.centre.velocity.norm() < speed);
    REQUIRE(kinetic_energy(body.top) < energy);
    REQUIRE(body.top.angular_momentum_body.norm() < momentum);
  }
  CHECK(std::abs(body.centre.velocity.norm() / 13 / std::exp(Real(-5)) - 1) < Real(0.001));
}

TEST_CASE(
    "A damping weaker than the swing of the step lets the energy of turning rise in some steps, "
    "|L| in none") {
  Topd top = uneven_top(Vec3d(4, 8, 2));
  const double time_step = 1.0 / 60, rate = 1e-4, start = kinetic_energy(top);
  const double kept = fraction_kept(rate, time_step);
  int rises = 0;
  const int steps = 3000;
  for (int n = 0; n < steps; ++n) {
    const double energy = kinetic_energy(top), momentum = top.angular_momentum_body.norm();
    damp(top, kept);
    drift(top, time_step);
    rises += kinetic_energy(top) > energy;
    REQUIRE(top.angular_momentum_body.norm() < momentum);
  }
  CHECK(rises > steps / 10);
  // In the long run it falls as e^(-2kt), here by a hundredth: the swing does not add up.
  CHECK(std::abs(kinetic_energy(top) / start / std::exp(-2 * rate * steps * time_step) - 1) < 1e-3);
}

TEST_CASE_TEMPLATE("The angular speed of a damped tumbling body may rise for a while", Real, float,
                   double) {
  Top<Real> top = uneven_top(Vec3<Real>(Real(0.01), Real(1.2), 2));
  const Real start = angular_velocity_body(top).norm(), time_step = Real(1) / 60;
  Real largest = 0, previous_momentum = top.angular_momentum_body.norm();
  for (int n = 0; n < 600; ++n) {
    drift(top, time_step);
    damp(top, fraction_kept(Real(0.01), time_step));
    largest = std::max(largest, angular_velocity_body(top).norm());
    REQUIRE(top.angular_momentum_body.norm() < previous_momentum);
    previous_momentum = top.angular_momentum_body.norm();
  }
  CHECK(largest > Real(1.03) * start);
}

TEST_CASE_TEMPLATE("Damping the centre leaves the turning alone, and the other way round", Real,
                   EVERY_PRECISION) {
  RigidBody<Real> body{.centre = make_particle(Real(2), Vec3<Real>(1, 2, 3), Vec3<Real>(3, -4, 12)),
                       .top = uneven_top(Vec3<Real>(1, 2, Real(0.5)))};
  const RigidBody<Real> start = body;
  damp(body.centre, Real(0.5));
  CHECK(same_bits(body.centre.velocity, start.centre.velocity / 2));
  CHECK(same_bits(body.centre.position, start.centre.position));
  CHECK(same_bits(body.top.angular_momentum_body, start.top.angular_momentum_body));
  damp(body.top, Real(0.25));
  CHECK(same_bits(body.centre.velocity, start.centre.velocity / 2));
  CHECK(same_bits(body.top.angular_momentum_body, start.top.angular_momentum_body / 4));
  CHECK(same_bits(angular_velocity_body(body.top), angular_velocity_body(start.top) / 4));
  CHECK(same_bits(body.top.orientation.imaginary, start.top.orientation.imaginary));
}

TEST_CASE_TEMPLATE(
    "A static particle keeps any velocity, and at a rate of zero a ball any that matters", Real,
    EVERY_PRECISION) {
  Particle<Real> belt = make_static_particle(Vec3<Real>(1, 2, 3));
  belt.velocity = Vec3<Real>(Real(0.5), 0, slowest_speed<Real> / 2);  // a conveyor belt
  const Vec3<Real> before = belt.velocity;
  damp(belt, fraction_kept(Real(10), Real(1)));
  CHECK(same_bits(belt.velocity, before));

  Particle<Real> ball = make_particle(Real(1), Vec3<Real>(1, 2, 3), Vec3<Real>(Real(0.1), 7, -3));
  damp(ball, fraction_kept(Real(0), Real(1) / 60));
  CHECK(same_bits(ball.velocity, Vec3<Real>(Real(0.1), 7, -3)));
  // What is too slow to matter stops even so.
  ball.velocity.x() = slowest_speed<Real> / 2;
  damp(ball, fraction_kept(Real(0), Real(1) / 60));
  CHECK(same_bits(ball.velocity, Vec3<Real>(0, 7, -3)));
}

TEST_CASE_TEMPLATE("A damping that is negative, NaN, infinite or not a fraction is refused by name",
                   Real, EVERY_PRECISION) {
  const Real nan = std::numeric_limits<Real>::quiet_NaN(),
             infinity = std::numeric_limits<Real>::infinity();
  const auto rate = [](Real value) { return complaint_of([=] { checked_damping_rate(value); }); };
  CHECK(rate(Real(-0.5)) ==
        "damping rate is -0.5 1/s; it must be 0 or more: a negative one adds speed");
  CHECK(rate(nan) == "damping rate is nan 1/s; it must be finite");
  CHECK(rate(infinity) == "damping rate is inf 1/s; it must be finite");
  CHECK(rate(0) == "nothing thrown");
  CHECK(complaint_of([] { checked_damping_rate(Real(-2), "angular damping of 'crate'"); }) ==
        "angular damping of 'crate' is -2 1/s; it must be 0 or more: a negative one adds speed");

  const auto leaves = [](Real fraction, Real time) {
    return complaint_of([=] { damping_rate_that_leaves(fraction, time); });
  };
  CHECK(leaves(Real(1.5), 1) == "fraction left by damping is 1.5; it must lie between 0 and 1");
  CHECK(leaves(Real(-0.5), 1) == "fraction left by damping is -0.5; it must lie between 0 and 1");
  CHECK(leaves(nan, 1) == "fraction left by damping is nan; it must lie between 0 and 1");
  CHECK(leaves(0, 1) ==
        "fraction left by damping is 0; no rate stops a body at once: set its velocity to zero");
  CHECK(leaves(Real(0.5), 0) == "damping time is 0 s; it must be greater than 0");
  CHECK(leaves(Real(0.5), -1) == "damping time is -1 s; it must be greater than 0");
  CHECK(leaves(Real(0.5), nan) == "damping time is nan s; it must be finite");
  CHECK(std::isnan(power_form(Real(-0.5), Real(1) / 60)));  // what the power form makes of it
}

TEST_CASE_TEMPLATE(
    "A speed that is too small to matter becomes zero, and one that matters does not", Real,
    EVERY_PRECISION) {
  const Real slowest = slowest_speed<Real>, smallest = std::numeric_limits<Real>::min();
  CHECK(slowest * slowest == std::ldexp(smallest, 66));
  const Real above = slowest * (1 + 2 * unit_roundoff<Real>);
  Particle<Real> ball =
      make_particle(Real(1), Vec3<Real>(1, 2, 3), Vec3<Real>(1, slowest / 2, -above));
  damp(ball, 1);
  CHECK(same_bits(ball.velocity, Vec3<Real>(1, 0, -above)));

  // For a top it is the speed that counts, not the momentum: a light body is no slower for it.
  for (const int exponent : {-40, 0, 40}) {
    const Real scale = std::ldexp(Real(1), exponent);
    Top<Real> top;
    top.inverse_moments = Vec3<Real>(1, Real(0.5), Real(0.25)) / scale;
    top.angular_momentum_body = Vec3<Real>(slowest / 2, 2 * slowest, -above * 4) * scale;
    damp(top, 1);
    CHECK(same_bits(top.angular_momentum_body, Vec3<Real>(0, 2 * slowest, -above * 4) * scale));
  }

  // Left to itself a damped speed never gets to zero: in the end the product rounds back up.
  const Real kept = fraction_kept(Real(1), Real(1) / 60);
  Real crawling = smallest;
  for (int n = 0; n < 6000; ++n) crawling *= kept;
  CHECK(crawling > 0);
  CHECK(crawling * kept == crawling);
  Particle<Real> stopping =
      make_particle(Real(1), Vec3<Real>(Vec3<Real>::Zero()), Vec3<Real>(slowest * 100, 0, 0));
  for (int n = 0; n < 600; ++n) damp(stopping, kept);
  CHECK(stopping.velocity.x() == 0);
}

TEST_CASE_TEMPLATE("What damping makes too slow to matter stops in the same step", Real,
                   EVERY_PRECISION) {
  const Real slow = slowest_speed<Real>;
  Particle<Real> particle = make_particle<Real>(1, {0, 0, 0}, {3 * slow / 2, 3 * slow, slow});
  damp(particle, Real(0.5));
  CHECK(same_bits(particle.velocity, Vec3<Real>(0, 3 * slow / 2, 0)));
  damp(particle, Real(1));
  CHECK(same_bits(particle.velocity, Vec3<Real>(0, 3 * slow / 2, 0)));
  Top<Real> top;
  top.inverse_moments = {1, 2, Real(0.5)};
  top.angular_momentum_body = {3 * slow / 2, 3 * slow / 2, 2 * slow};
  damp(top, Real(0.5));
  CHECK(same_bits(top.angular_momentum_body, Vec3<Real>(0, 3 * slow / 4, 0)));
  // Each component stops for itself, whichever it is.
  for (int axis = 0; axis < 3; ++axis) {
    Vec3<Real> speeds(1, 2, 4);
    speeds[axis] = slow / 2;
    Particle<Real> one = make_particle<Real>(1, {0, 0, 0}, speeds);
    Top<Real> turning{.angular_momentum_body = speeds, .inverse_moments = {1, 1, 1}};
    damp(one, Real(1));
    damp(turning, Real(1));
    speeds[axis] = 0;
    CHECK(same_bits(one.velocity, speeds));
    CHECK(same_bits(turning.angular_momentum_body, speeds));
  }
  Particle<Real> just_fast = make_particle<Real>(1, {0, 0, 0}, {slow, 0, 0});
  damp(just_fast, Real(1));
  CHECK(just_fast.velocity.x() == slow);
}
