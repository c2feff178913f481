#include <course/checks.hpp>
#include <course/rules.hpp>

using namespace tumble;
using namespace tumble::course;

namespace {

const TumblingProblem &A = tumbling_problems[0], &B = tumbling_problems[1],
                      &C = tumbling_problems[2], &D = tumbling_problems[3];

/// `found` is what a published figure of two digits rounds: within 6% of it.
bool about(double found, double published) {
  return std::abs(found - published) <= 0.06 * published;
}

const double rounding = 1e-11;  // 36,000 steps of a few roundings each

}  // namespace

TEST_CASE_TEMPLATE("The gyroscopic torque is square to L and to the angular velocity", Real,
                   EVERY_PRECISION) {
  const Top<Real> top = top_of<Real>(A);
  const Vec3<Real> torque = gyroscopic_torque(top), w = angular_velocity_body(top);
  const Vec3<Real>& L = top.angular_momentum_body;
  const Real bound = 10 * unit_roundoff<Real> * torque.norm();
  CHECK(std::abs(torque.dot(L)) <= bound * L.norm());
  CHECK(std::abs(torque.dot(w)) <= bound * w.norm());
  // Problem A: ω = (1, 2, 0.5), L = (1, 4, 1.5) in the given order gives L × ω = (−1, 1, −2).
  const Top<Real> given = top_in_order<Real>(A, {0, 1, 2});
  CHECK(distance(gyroscopic_torque(given), Vec3<Real>(-1, 1, -2)) <= 10 * unit_roundoff<Real> * 4);
}

//! [coasting_momentum]
TEST_CASE_TEMPLATE("The rule that keeps the angular velocity keeps the energy too, and loses L",
                   Real, float, double) {
  Top<Real> top = top_of<Real>(A);
  const Top<Real> start = top;
  for (int n = 0; n < 600; ++n) turn_steadily(top, Real(1) / 60);
  CHECK(same_bits(top.angular_momentum_body, start.angular_momentum_body));
  CHECK(kinetic_energy(top) == kinetic_energy(start));
  const Motion motion = watched<Real>(A, turn_steadily<Real>);
  CHECK(about(motion.momentum_error, 0.49));
  CHECK(about(motion.angle, 2.89));
  CHECK(about(watched<Real>(C, turn_steadily<Real>).angle, 1.68));
}
//! [coasting_momentum]

//! [explicit_grows]
TEST_CASE("An explicit step adds h^2 |L x w|^2 to |L|^2, every time, until it blows up") {
  Topd top = top_of<double>(A);
  const double h = 1.0 / 60;
  for (int n = 0; n < 1000; ++n) {
    const double before = top.angular_momentum_body.squaredNorm();
    const double gained = h * h * gyroscopic_torque(top).squaredNorm();
    turn_explicitly(top, h);
    CHECK(std::abs(top.angular_momentum_body.squaredNorm() - before - gained) <=
          20 * unit_roundoff<double> * before);
  }
  // The published steps of divergence; ours counts to a thousandfold energy, where what is left
  // takes a few dozen steps.
  const int a = watched<double>(A, turn_explicitly<double>).diverged;
  const int b = watched<double>(B, turn_explicitly<double>).diverged;
  CHECK(std::abs(a - 11971) <= 50);
  CHECK(std::abs(b - 3628) <= 50);
  CHECK(watched<double>(C, turn_explicitly<double>).diverged <= 22);
  CHECK(watched<double>(D, turn_explicitly<double>).diverged <= 7);
}
//! [explicit_grows]

//! [restored_spins_up]
TEST_CASE("Restoring |L| keeps |L| and turns a stable spin's energy into that of an unstable one") {
  Topd top = top_of<double>(B);
  const double size = top.angular_momentum_body.norm();
  for (int n = 0; n < 1000; ++n) turn_restoring_momentum(top, 1.0 / 60);
  CHECK(std::abs(top.angular_momentum_body.norm() - size) <=
        1000 * 8 * unit_roundoff<double> * size);

  const Motion a = watched<double>(A, turn_restoring_momentum<double>);
  CHECK(about(a.energy_error, 0.013));
  CHECK(about(a.momentum_error, 0.053));
  CHECK(about(a.angle, 0.059));
  const Motion b = watched<double>(B, turn_restoring_momentum<double>);
  CHECK(std::abs(b.energy_ratio - 1.498) <= 0.0005);
  // Where it ends: the energy L²/2I₂ of a spin about the middle axis.
  const Topd start = top_of<double>(B);
  const double middle = size * size / 4;  // I₂ = 2
  CHECK(std::abs(b.energy_ratio * kinetic_energy(start) / middle - 1) <= 0.001);
  const Motion c = watched<double>(C, turn_restoring_momentum<double>);
  CHECK(std::abs(c.energy_ratio - 0.072) <= 0.0005);
  CHECK(about(c.angle, 1.38));
  CHECK(about(watched<double>(D, turn_restoring_momentum<double>).energy_error, 0.031));
}
//! [restored_spins_up]

TEST_CASE("One Newton step leaves a residual of third order in the time step") {
  // A wrong derivative would leave one of second order, whose ratio is 4.
  const auto residual = [](double h) -> double {
    const Topd start = top_of<double>(A);
    Topd top = start;
    turn_implicitly(top, h);
    return (top.angular_momentum_body - start.angular_momentum_body - h * gyroscopic_torque(top))
        .norm();
  };
  for (const double h : {1e-2, 1e-3}) {
    CHECK(residual(h) / residual(h / 2) >= 8 * (1 - 4 * h));
    CHECK(residual(h) / residual(h / 2) <= 8 * (1 + 4 * h));
  }
}

//! [implicit_brakes]
TEST_CASE("The implicit rule brakes: a tumbling body comes to rest about its largest moment") {
  const Motion a = watched<double>(A, turn_implicitly<double>);
  CHECK(about(a.energy_error, 0.84));
  CHECK(about(a.momentum_error, 0.71));
  CHECK(about(a.angle, 0.43));
  CHECK(std::abs(watched<double>(B, turn_implicitly<double>).energy_ratio - 0.997) <= 0.0005);
  const Motion c = watched<double>(C, turn_implicitly<double>);
  CHECK(std::abs(c.energy_ratio - 0.965) <= 0.0005);
  CHECK(about(c.angle, 1.71));
  CHECK(about(watched<double>(D, turn_implicitly<double>).energy_error, 0.97));
}
//! [implicit_brakes]

TEST_CASE("Carrying the momentum holds L in the world to rounding, and not the energy") {
  const Motion a = watched<double>(A, turn_carrying_momentum<double>);
  CHECK(a.momentum_error <= rounding);
  CHECK(about(a.energy_error, 0.97));
  CHECK(about(a.angle, 2.48));
  CHECK(std::abs(watched<double>(B, turn_carrying_momentum<double>).energy_ratio - 2.996) <=
        0.0005);
  const Motion c = watched<double>(C, turn_carrying_momentum<double>);
  CHECK(std::abs(c.energy_ratio - 1.884) <= 0.0005);
  CHECK(about(c.angle, 2.88));
  CHECK(about(watched<double>(D, turn_carrying_momentum<double>).energy_error, 127));
}

//! [three_axes]
TEST_CASE(
    "Splitting by axes is exact in L; its energy depends on which axis stands in the middle") {
  const auto in_given_order = [](const TumblingProblem& problem) {
    return watched(top_in_order<double>(problem, {0, 1, 2}), turn_axis_by_axis<double>,
                   60 * problem.seconds, 60 * problem.seconds_to_angle, 1.0 / 60);
  };
  const Motion a = in_given_order(A), c = in_given_order(C);
  CHECK(about(a.energy_error, 1e-5));
  CHECK(about(a.angle, 1.1e-4));
  CHECK(a.momentum_error <= rounding);
  CHECK(std::abs(c.energy_ratio - 1.004) <= 0.0005);
  CHECK(about(c.angle, 0.18));
  CHECK(in_given_order(D).diverged > 0);
  // With the lone axis in the middle, as our bodies have it, the same rule holds on to the rod and
  // the needle.
  CHECK(watched<double>(C, turn_axis_by_axis<double>).energy_error < 1e-3);
  CHECK(watched<double>(D, turn_axis_by_axis<double>).energy_error < 1e-3);
}
//! [three_axes]

//! [without_sine]
TEST_CASE(
    "Without a sine the splitting still is exact in L, bounded in energy and of second order") {
  for (const TumblingProblem* problem : {&A, &B, &C}) {
    const Motion motion = watched<double>(*problem, turn_by_splitting_without_sine<double>);
    CHECK(motion.diverged == 0);
    CHECK(motion.momentum_error <= rounding);
    // Bounded: what is off is not more at the end than it has been all along, and a thousandth
    // where the steps are small. C turns by 1 rad a step.
    CHECK(motion.energy_error <= (problem == &C ? 0.05 : 1e-3));
  }
  // Halve the step, and the angle is off by a quarter.
  const auto angle_with = [](int steps_per_second) {
    const int steps = steps_per_second * A.seconds_to_angle;
    return watched(top_of<double>(A), turn_by_splitting_without_sine<double>, steps, steps,
                   1.0 / steps_per_second)
        .angle;
  };
  const double ratio = angle_with(120) / angle_with(240);
  CHECK(ratio >= 3.9);
  CHECK(ratio <= 4.1);
}
//! [without_sine]

TEST_CASE("Splitting with a sphere: energy, momentum and phase of the problems A to D") {
  const Motion a = watched<double>(A, turn_by_splitting<double>);
  CHECK(about(a.energy_error, 2e-5));
  CHECK(about(a.angle, 1.7e-4));
  CHECK(a.momentum_error <= rounding);
  const Motion b = watched<double>(B, turn_by_splitting<double>);
  CHECK(std::abs(b.energy_ratio - 1) <= 1e-6);
  CHECK(watched<double>(C, turn_by_splitting<double>).angle < 1e-4);
  CHECK(about(watched<double>(D, turn_by_splitting<double>).energy_error, 6.3e-6));
}

//! [orders]
TEST_CASE(
    "Halving the time step halves the error of the first-order rules and quarters that of the "
    "splittings") {
  const Topd start = top_of<double>(A);
  const auto exact = FreeTop(exactly(start)).orientation(10);
  const auto error = [&](const Rule<double>& rule, int steps_per_second) {
    Topd top = start;
    for (int n = 0; n < 10 * steps_per_second; ++n) rule.turn(top, 1.0 / steps_per_second);
    return static_cast<double>(angle_between(exact, exactly(top).orientation));
  };
  // The next term of the error is smaller by about ω h t ω = 2.3²·10/1920, a fortieth.
  const double expected[] = {1, 2, 2, 2, 2, 4, 4};
  for (std::size_t n = 0; n < rules<double>.size(); ++n) {
    const Rule<double>& rule = rules<double>[n];
    CAPTURE(std::string(rule.name));
    const double ratio = error(rule, 1920) / error(rule, 3840);
    CHECK(ratio >= expected[n] * (1 - 0.025));
    CHECK(ratio <= expected[n] * (1 + 0.025));
  }
}
//! [orders]
