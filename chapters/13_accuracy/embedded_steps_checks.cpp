#include <support/checks.hpp>
#include <tumble/embedded_steps.hpp>

using namespace tumble;
using namespace tumble::support;

// What the reports call them.
TYPE_TO_STRING_AS("the pair 5(4)", tumble::DormandPrince54);
TYPE_TO_STRING_AS("the pair 8(5,3)", tumble::DormandPrince853);

namespace {

/// A push along one line that depends on the time alone, and what follows from it for a kilogram
/// that stands still at the origin when the time is 0: x'' = t^power.
struct PushInTime {
  int power;
  template <class Real>
  void operator()(Particle<Real>& particle, Real time) const {
    particle.force = {std::pow(time, Real(power)), 0, -2 * std::pow(time, Real(power))};
  }
  double velocity(double time) const { return std::pow(time, power + 1) / (power + 1); }
  double position(double time) const {
    return std::pow(time, power + 2) / (power + 1) / (power + 2);
  }
};

Particled at(const PushInTime& push, double time) {
  const double x = push.position(time), v = push.velocity(time);
  return make_particle<double>(1, {x, 0, -2 * x}, {v, 0, -2 * v});
}

void check_is(const Particled& found, const Particled& truth, double size) {
  CHECK(distance(found.position, truth.position) <= 100 * unit_roundoff<double> * size);
  CHECK(distance(found.velocity, truth.velocity) <= 100 * unit_roundoff<double> * size);
}

}  // namespace

TEST_CASE_TEMPLATE("What acts at the end of a step is asked of a unit quaternion", Pair,
                   DormandPrince54, DormandPrince853) {
  double asked = 0;
  const auto turn = [&](Topd& top, double time) {
    asked = norm(top.orientation);
    top.torque = {time, 1, -2 * time};
  };
  const Topd top{.angular_momentum_body = {1, 2, 3}, .inverse_moments = {1, 2, 3}};
  EmbeddedSteps<Pair, Topd, decltype(turn), double> steps(top, turn, 0.0, 1e-3);
  for (int n = 0; n < 3; ++n) {
    steps.attempt(0.125);  // so long that the four numbers leave their sphere by far more
    steps.accept();
    CHECK(std::abs(asked - 1) <= 4 * unit_roundoff<double>);
  }
}

TEST_CASE_TEMPLATE("The error of L counts as a part of what L was when the step began", Pair,
                   DormandPrince54, DormandPrince853) {
  // So heavy that it hardly turns: L gains t^13/13, and is a few hundred times as long in the end.
  const auto twist = [](Topd& top, double time) { top.torque = {std::pow(time, 12), 0, 0}; };
  const auto square = [&](double momentum) {
    const Topd top{.angular_momentum_body = {momentum, 0, 0},
                   .inverse_moments = Vec3d::Constant(1e-12)};
    return EmbeddedSteps<Pair, Topd, decltype(twist), double>(top, twist, 0.0, 1).attempt(2);
  };
  CHECK(std::abs(square(1) / square(2) - 4) <= 1e-6);
}

TEST_CASE_TEMPLATE(
    "The errors of a particle's position and of its velocity count each in what is allowed of it",
    Real, EVERY_PRECISION) {
  const Real e = std::numeric_limits<Real>::epsilon();
  const StateVector<Real, 6> nowhere = {};
  // Five metres and thirteen metres a second, where one and a half are allowed.
  const StateVector<Real, 6> error = {3, 4, 0, 3, 4, 12};
  const auto is = [](Real found, double expected) {
    CHECK(std::abs(double(found) / expected - 1) <= 32 * unit_roundoff<Real>);
  };
  is(square_of_error<Real>(error, nowhere, nowhere, {Real(0.5), Real(0.25)}, 2), 25 + 4 * 169);
  is(square_of_error<Real>(error, nowhere, nowhere, {Real(0.5), Real(0.25)}, 4),
     (25 + 4 * 169) / 4.0);
  // Four epsilon of the size are always allowed: 28 epsilon for 7 m, 36 epsilon for 9 m/s.
  const StateVector<Real, 6> start = {2, 3, 6, 1, 4, 8};
  const StateVector<Real, 6> small = {4 * e, 13 * e, 16 * e, 8 * e, 16 * e, 11 * e};  // 21 and 21
  is(square_of_error<Real>(small, start, nowhere, {e * e, e * e}, 1),
     21 * 21 / 784.0 + 21 * 21 / 1296.0);
  // Both together add up as squares: 21² + 28² = 35², 27² + 36² = 45².
  is(square_of_error<Real>({4 * e, 13 * e, 16 * e, 0, 0, 0}, start, nowhere, {21 * e, 1}, 1),
     21 * 21 / 1225.0);
  is(square_of_error<Real>({0, 0, 0, 8 * e, 16 * e, 11 * e}, start, nowhere, {1, 27 * e}, 1),
     21 * 21 / 2025.0);
}

TEST_CASE_TEMPLATE("The error of a top is the angle that it is off by, and the part of L", Real,
                   EVERY_PRECISION) {
  const Real e = std::numeric_limits<Real>::epsilon();
  const auto is = [](Real found, double expected) {
    CHECK(std::abs(double(found) / expected - 1) <= 64 * unit_roundoff<Real>);
  };
  // |Im(q* d)|² = |d|² - (q·d)² for a unit quaternion q; here q·d = 1.5 and |d|² = 39.
  const StateVector<Real, 7> start = {1, 0, 0, 0, 2, 3, 6},
                             end = {Real(0.1), Real(0.5), Real(0.7), Real(0.5), 1, 4, 8};
  const double angle = 4 * (39 - 2.25);
  is(square_of_error<Real>({1, 2, -3, 5, 3, 4, 12}, start, end, Real(0.5), 2), angle + 169 / 49.0);
  is(square_of_error<Real>({1, 2, -3, 5, 3, 4, 12}, start, end, Real(0.5), 4),
     (angle + 169 / 49.0) / 4);
  is(square_of_error<Real>({0, 0, 0, 0, 1, 0, 0}, start, end, Real(0.5), 2), 1 / 49.0);
  is(square_of_error<Real>({1, 2, -3, 5, 0, 0, 0}, start, end, Real(0.5), 2), angle);
  // A top that begins at rest is measured by what it has gained.
  is(square_of_error<Real>({0, 0, 0, 0, 3, 4, 12}, {1, 0, 0, 0, 0, 0, 0}, end, Real(0.5), 2),
     169 / 81.0);
  is(square_of_error<Real>({0, 0, 0, 0, 3, 4, 12}, {1, 0, 0, 0, 1, 0, 0}, end, Real(0.5), 2), 169);
  // One that rests all the while has no error, and not 0/0 of one.
  CHECK(square_of_error<Real>({}, {1, 0, 0, 0, 0, 0, 0}, {1, 0, 0, 0, 0, 0, 0}, Real(0.5), 2) == 0);
  // Four epsilon are always allowed: here half of it.
  is(square_of_error<Real>({0, 0, 0, 0, 3 * e, 4 * e, 12 * e}, start, end, 2 * e, 2),
     169 / 49.0 / 64);
}

TEST_CASE("Of two estimates the one that falls faster counts, tamed by the other") {
  // As squares: e₁²/√(e₁² + e₂²/100).
  CHECK(combined_square(std::array{7.0}) == 7);
  CHECK(combined_square(std::array{4.0, 1200.0}) == 1);
  CHECK(combined_square(std::array{1.0, 300.0}) == 0.25);
  CHECK(combined_square(std::array{4.0, 0.0}) == 4);
  CHECK(combined_square(std::array{0.0, 5.0}) == 0);
  CHECK(combined_square(std::array{0.0, 0.0}) == 0);
}

TEST_CASE_TEMPLATE(
    "Under a push that is a polynomial of time a pair steps exactly, whenever it begins", Pair,
    DormandPrince54, DormandPrince853) {
  // A rule of order p integrates t^(p-2) without error twice over.
  const PushInTime push{Pair::power == 5 ? 3 : 6};
  for (const double begin : {0.0, 1.0, -0.5}) {
    EmbeddedSteps<Pair, Particled, PushInTime, double> steps(at(push, begin), push, begin,
                                                             {1e-3, 1e-3});
    double time = begin;
    for (const double h : {0.5, 0.25, 0.375}) {
      steps.attempt(2 * h);  // not accepted: leaves no trace
      steps.attempt(h);
      steps.accept();
      time += h;
      check_is(steps.body(), at(push, time), 10);
    }
  }
}

TEST_CASE_TEMPLATE("Within a step, too, a push that grows evenly with time is followed exactly",
                   Pair, DormandPrince54, DormandPrince853) {
  const PushInTime push{1};
  EmbeddedSteps<Pair, Particled, PushInTime, double> steps(at(push, 2), push, 2.0, {1e-3, 1e-3});
  steps.attempt(0.5);
  for (const double part : {0.0, 0.25, 0.5, 0.875, 1.0})
    check_is(steps.within(part), at(push, 2 + part * 0.5), 10);
}

TEST_CASE("The first step is that of an oscillation, where rates and their change are known") {
  // x'' = -x: the rates (v, -x) change at the rates (-x, -v), which have the same size.
  const auto spring = [](Particled& particle, double) { particle.force = -particle.position; };
  const auto start = make_particle<double>(1, {1, 4, 8}, {3, 4, 12});
  const double tolerance = 1e-3, rate = std::sqrt(81.0 + 169.0) / tolerance;
  EmbeddedSteps<DormandPrince54, Particled, decltype(spring), double> steps(start, spring, 0.0,
                                                                            {tolerance, tolerance});
  const double first = steps.first_step(1);
  // The change is a difference of rates a ten-thousandth of a second apart.
  CHECK(std::abs(first / (2 * std::pow(rate, -1.0 / 4)) - 1) <= 1e5 * unit_roundoff<double>);

  // A push that begins to change: x'' = t, at rest at the time 0. The rates' change is the push's.
  const PushInTime push{1};
  EmbeddedSteps<DormandPrince54, Particled, PushInTime, double> pushed(at(push, 3), push, 3.0,
                                                                       {tolerance, tolerance});
  const double v = push.velocity(3), pushed_rate = std::sqrt(5 * (v * v + 9)) / tolerance,
               change = std::sqrt(5 * (9 + 1.0)) / tolerance;
  const double expected = first_step_of(pushed_rate, change, 4, 10.0);
  CHECK(std::abs(pushed.first_step(1e-3) / std::min(expected, 1e-3) - 1) <= 1e-6);
  CHECK(std::abs(pushed.first_step(10) / expected - 1) <= 1e-3);  // t² within a thousandth of 3 s
}

TEST_CASE_TEMPLATE(
    "An integration leaves the push of the moment that it reaches, and refuses what is none", Pair,
    DormandPrince54, DormandPrince853) {
  const PushInTime push{2};
  auto body = at(push, 1);
  const StepCounts counts = integrate<Pair>(body, push, 1.0, 2, {1e-6, 1e-6});
  CHECK(counts.steps > 0);
  check_is(body, at(push, 3), 20);
  CHECK(body.force.x() == 9);
  CHECK(complaint_of([&] {
          integrate<Pair>(body, push, 0.0, -1, {1e-6, 1e-6});
        }) == "time is -1 s; it must be 0 or more");
  CHECK(complaint_of([&] {
          integrate<Pair>(body, push, 0.0, 1, {-1e-6, 1e-6});
        }) == "tolerance of the position is -1e-06 m a second; it must be greater than 0");
  CHECK(complaint_of([&] {
          integrate<Pair>(body, push, 0.0, 1, {1e-6, 0});
        }) == "tolerance of the velocity is 0 m/s a second; it must be greater than 0");
}

TEST_CASE("Within a step of a top the fourth order holds too, and the quaternion is a unit") {
  const auto twist = [](Topd& top, double time) { top.torque = {time, 1, -2 * time}; };
  const Topd top{.angular_momentum_body = {1, 2, 3}, .inverse_moments = {1, 0.5, 0.25}};
  const auto error = [&](double h) {
    EmbeddedSteps<DormandPrince54, Topd, decltype(twist), double> steps(top, twist, 0.0, 1);
    steps.attempt(h);
    double worst = 0;
    for (const double part : {0.25, 0.5, 0.875}) {
      const Topd within = steps.within(part);
      CHECK(std::abs(norm(within.orientation) - 1) <= 4 * unit_roundoff<double>);
      Topd there = top;
      integrate<DormandPrince853>(there, twist, 0.0, part * h, 1e-14);
      worst = std::max({worst, angle_between(within.orientation, there.orientation),
                        distance(within.angular_momentum_body, there.angular_momentum_body)});
    }
    return worst;
  };
  CHECK(std::log2(error(0.125) / error(0.0625)) >= 4.5);  // the fifth power of the step, and more
}
