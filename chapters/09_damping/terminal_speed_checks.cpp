#include <support/checks.hpp>
#include <support/damping_forms.hpp>
#include <tumble/damping.hpp>
#include <tumble/drag.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

/// The speed that repeated steps end at, and what their roundings can make of it: each of the last
/// 1/(1 − slope) steps adds some 4 u of the speed.
template <class Real, class Step>
void check_terminal_speed(Step next, long double exact, long double slope) {
  Real speed = 0;
  const int steps =
      10 + static_cast<int>(-std::log(unit_roundoff<Real>) / -std::log(std::abs(slope)));
  for (int n = 0; n < steps; ++n) speed = next(speed);
  const Real bound = 8 / Real(1 - std::abs(slope)) * unit_roundoff<Real> * Real(std::abs(exact));
  CHECK(std::abs(Real(speed - exact)) <= bound);
}

}  // namespace

TEST_CASE_TEMPLATE("Every form of damping has its own terminal speed, and it is exactly this", Real,
                   EVERY_PRECISION) {
  const Real gravity = Real(9.81);
  for (const Real time_step : {Real(0.01), Real(0.1), Real(0.3), Real(0.75)}) {
    CAPTURE(time_step);
    const Real rate = 2, h = time_step, gain = h * gravity;
    const Real linear = linear_form(rate, h), fractional = fractional_form(rate, h);
    const long double g = gravity, c = rate, ch = c * h;

    // Kick, then damp by e^(−ch), by the chapter's own functions.
    const auto exponential = [gravity, rate, h](Real v) {
      Particle<Real> ball =
          make_particle(Real(1), Vec3<Real>(Vec3<Real>::Zero()), Vec3<Real>(0, 0, -v));
      accelerate(ball, Vec3<Real>(0, 0, -gravity), h);
      damp(ball, fraction_kept(rate, h));
      return -ball.velocity.z();
    };
    check_terminal_speed<Real>(exponential, h * g / std::expm1(ch), std::exp(-ch));
    check_terminal_speed<Real>([=](Real v) { return (v + gain) * fractional; }, g / c,
                               1 / (1 + ch));
    check_terminal_speed<Real>([=](Real v) { return (v + gain) * linear; }, g * (1 - ch) / c,
                               1 - ch);
    check_terminal_speed<Real>([=](Real v) { return v * fractional + gain; }, g * (1 + ch) / c,
                               1 / (1 + ch));
    // And as a force in the kick.
    check_terminal_speed<Real>([=](Real v) { return v + h * (gravity - rate * v); }, g / c, 1 - ch);
  }
}

TEST_CASE("Falling with damping nears the exact fall with linear drag, to first order") {
  const double g = 9.81, c = 0.8, start_speed = 5, time = 3;
  const double terminal = -g / c;
  const double exact = terminal * time + (start_speed - terminal) * (1 - std::exp(-c * time)) / c;
  const auto off = [=](int steps) {
    const double h = time / steps;
    Particled ball = make_particle(0.2, Vec3d(0, 0, 0), Vec3d(0, 0, start_speed));
    for (int n = 0; n < steps; ++n) {
      accelerate(ball, Vec3d(0, 0, -g), h);
      damp(ball, fraction_kept(c, h));
      drift(ball, h);
    }
    return ball.position.z() - exact;
  };
  for (const int steps : {200, 400, 800}) {
    CHECK(off(steps) / off(2 * steps) > 1.9);
    CHECK(off(steps) / off(2 * steps) < 2.1);
  }
  // A damped coaster stops within v/k: the distance left when only damping acts.
  Particled coaster = make_particle(1.0, Vec3d(0, 0, 0), Vec3d(12, 0, 0));
  for (int n = 0; n < 60 * 100; ++n) {
    damp(coaster, fraction_kept(c, 1.0 / 60));
    drift(coaster, 1.0 / 60);
  }
  const double kept = fraction_kept(c, 1.0 / 60);
  CHECK(std::abs(coaster.position.x() - 12.0 / 60 * kept / (1 - kept)) < 1e-12);
  CHECK(coaster.position.x() < 12 / c);
}

TEST_CASE_TEMPLATE("Quadratic drag points against the motion through the air, whatever the axes",
                   Real, EVERY_PRECISION) {
  const Vec3<Real> velocity(3, -4, 12), wind(0, 0, 0);
  CHECK(distance(quadratic_drag(Real(0.5), velocity, wind), Real(-6.5) * velocity) <=
        8 * unit_roundoff<Real> * Real(6.5) * 12);
  CHECK(same_bits(quadratic_drag(Real(0.5), velocity, velocity), Vec3<Real>::Zero()));
  CHECK(same_bits(quadratic_drag(Real(0.5), wind, velocity),
                  -quadratic_drag(Real(0.5), velocity, wind)));
  const auto turned = [](const Vec3<Real>& v) { return Vec3<Real>(-v.y(), v.x(), v.z()); };
  CHECK(same_bits(quadratic_drag<Real>(Real(0.5), turned(velocity), wind),
                  turned(quadratic_drag(Real(0.5), velocity, wind))));
  CHECK(same_bits(quadratic_drag(Real(0.5), Vec3<Real>(2 * velocity), wind),
                  4 * quadratic_drag(Real(0.5), velocity, wind)));
  CHECK(drag_coefficient(Real(1.25), Real(0.5), Real(2)) == Real(0.625));
}

TEST_CASE("Quadratic drag alone leaves v0 / (1 + c v0 t / m), to first order") {
  const double coefficient = 0.02, mass = 0.5, start = 30, time = 2;
  const auto coast = [=](int steps) {
    Particled ball = make_particle(mass, Vec3d(0, 0, 0), Vec3d(start, 0, 0));
    for (int n = 0; n < steps; ++n) {
      clear_force(ball);
      add_force(ball, quadratic_drag(coefficient, ball.velocity, Vec3d(0, 0, 0)));
      step(ball, time / steps);
    }
    return ball;
  };
  const double slowing = 1 + coefficient * start * time / mass;
  const double speed = start / slowing, place = mass / coefficient * std::log(slowing);
  for (const int steps : {100, 200, 400}) {
    const Particled coarse = coast(steps), fine = coast(2 * steps);
    const double speed_ratio = (coarse.velocity.x() - speed) / (fine.velocity.x() - speed);
    const double place_ratio = (coarse.position.x() - place) / (fine.position.x() - place);
    for (const double ratio : {speed_ratio, place_ratio}) {
      CHECK(ratio > 1.9);
      CHECK(ratio < 2.1);
    }
  }
}

TEST_CASE(
    "From the same first deceleration quadratic drag leaves more speed than damping, at every "
    "moment") {
  const double coefficient = 0.02, mass = 0.5, start = 30, rate = coefficient * start / mass;
  const double h = 1.0 / 240;
  Particled dragged = make_particle(mass, Vec3d(0, 0, 0), Vec3d(start, 0, 0)), damped = dragged;
  const double kept = fraction_kept(rate, h);
  for (int n = 1; n <= 12 * 240; ++n) {
    clear_force(dragged);
    add_force(dragged, quadratic_drag(coefficient, dragged.velocity, Vec3d(0, 0, 0)));
    step(dragged, h);
    damp(damped, kept);
    // A kick makes a chord of the curve, which costs (k h)²/2 of the speed at the first one.
    if (n > 1) CHECK(dragged.velocity.x() > damped.velocity.x());
  }
  CHECK(dragged.velocity.x() > 100 * damped.velocity.x());
}

TEST_CASE(
    "A falling body ends at the root of m g / c with quadratic drag, at m g / c with linear") {
  const double coefficient = 0.01, g = 9.81;
  for (const double mass : {0.1, 0.4, 1.6}) {
    Particled ball = make_particle(mass);
    for (int n = 0; n < 60 * 120; ++n) {
      clear_force(ball);
      add_gravity(ball, Vec3d(0, 0, -g));
      add_force(ball, quadratic_drag(coefficient, ball.velocity, Vec3d(0, 0, 0)));
      step(ball, 1.0 / 60);
    }
    CHECK(std::abs(-ball.velocity.z() / std::sqrt(mass * g / coefficient) - 1) < 1e-13);

    // A force −c v: as long as 30 times m/c, which leave e^−30 of the way there.
    const double linear = 0.5;
    Particled bead = make_particle(mass);
    const double h = 1.0 / 60;
    for (int n = 0; n < 30 * mass / linear / h; ++n) {
      clear_force(bead);
      add_gravity(bead, Vec3d(0, 0, -g));
      add_force(bead, -linear * bead.velocity);
      step(bead, h);
    }
    CHECK(std::abs(-bead.velocity.z() / (mass * g / linear) - 1) < 1e-12);
  }
}

TEST_CASE("Quadratic drag as a force overshoots beyond m/(h c) and grows beyond twice that") {
  const double coefficient = 0.5, mass = 0.25, h = 0.125;  // m/(h c) = 4 m/s
  const auto speed_after = [=](double start, int steps) {
    Particled ball = make_particle(mass, Vec3d(0, 0, 0), Vec3d(start, 0, 0));
    for (int n = 0; n < steps; ++n) {
      clear_force(ball);
      add_force(ball, quadratic_drag(coefficient, ball.velocity, Vec3d(0, 0, 0)));
      kick(ball, h);
    }
    return ball.velocity.x();
  };
  CHECK(speed_after(3.9, 1) > 0);
  CHECK(speed_after(4.1, 1) < 0);
  CHECK(std::abs(speed_after(7.9, 20)) < 7.9);
  CHECK(std::abs(speed_after(8.1, 8)) > 10);
}

TEST_CASE_TEMPLATE("A drag coefficient of impossible numbers is refused by name", Real,
                   EVERY_PRECISION) {
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  const auto complaint = [](Real density, Real shape, Real area) {
    return complaint_of([=] { drag_coefficient(density, shape, area); });
  };
  CHECK(complaint(-1, 1, 1) == "density of air is -1 kg/m^3; it must be 0 or more");
  CHECK(complaint(1, -2, 1) == "shape number is -2; it must be 0 or more");
  CHECK(complaint(1, 1, -3) == "area is -3 m^2; it must be 0 or more");
  CHECK(complaint(nan, 1, 1) == "density of air is nan kg/m^3; it must be finite");
  CHECK(complaint(1, nan, 1) == "shape number is nan; it must be finite");
  CHECK(complaint(1, 1, nan) == "area is nan m^2; it must be finite");
}
