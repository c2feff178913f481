// Far from the origin: what can still be told apart, and what moves.
#include <support/checks.hpp>
#include <support/tumbling_problems.hpp>
#include <tumble/far_from_origin.hpp>
#include <tumble/solids.hpp>
#include <tumble/tumbling.hpp>

using namespace tumble;
using namespace tumble::support;

TEST_CASE_TEMPLATE(
    "Outwards a coordinate can be told from one that is a spacing away, and from none nearer", Real,
    EVERY_PRECISION) {
  for (const Real place : {Real(1), Real(-1000), Real(-1024), Real(1e7), Real(3), Real(1e-6)}) {
    const Real spacing = spacing_at(place), out = std::copysign(spacing, place);
    CHECK(place + out != place);
    CHECK(place + out / 2 * (1 - unit_roundoff<Real>)*(1 - 2 * unit_roundoff<Real>) == place);
    CHECK((place + out) - place == out);
    // Inwards from a power of two the next place lies twice as near.
    const bool is_power = place == 1 || place == -1024;
    CHECK((place - Real(0.49) * out != place) == is_power);
  }
  CHECK(spacing_at(Real(1)) == std::numeric_limits<Real>::epsilon());
}

TEST_CASE_TEMPLATE("A body moves outwards above the slowest speed, and below it never does", Real,
                   EVERY_PRECISION) {
  const Real h = Real(1) / 64;
  for (const Real place : {Real(10e3), Real(-1e6)}) {
    const Real slowest = std::copysign(slowest_drift_at(place, h), place);
    const auto moved = [&](Real speed) {
      auto particle = make_particle<Real>(1, {place, 0, 0}, {speed, 0, 0});
      for (int n = 0; n < 100; ++n) drift(particle, h);
      return particle.position.x() - place;
    };
    CHECK(slowest_drift_at(place, -h) == slowest_drift_at(place, h));  // backwards in time too
    CHECK(moved(Real(0.99) * slowest) == 0);
    // Of two places equally near the even multiple wins: once from an odd one, and no further.
    CHECK(std::abs(moved(slowest)) <= spacing_at(place));
    // Rounded up each time, it goes twice as fast as it should.
    CHECK(moved(Real(1.01) * slowest) == 100 * std::copysign(spacing_at(place), place));
  }
}

TEST_CASE_TEMPLATE("Inwards from a power of two a body moves from half the slowest speed on", Real,
                   EVERY_PRECISION) {
  // The numbers on the inner side lie twice as close.
  const Real h = Real(1) / 64, place = 1024, slowest = slowest_drift_at(place, h);
  const auto moved = [&](Real from, Real speed) {
    auto particle = make_particle<Real>(1, {from, 0, 0}, {speed, 0, 0});
    drift(particle, h);
    return particle.position.x() - from;
  };
  CHECK(moved(place, -Real(0.49) * slowest) == 0);
  CHECK(moved(place, -Real(0.51) * slowest) == -spacing_at(place) / 2);
  CHECK(moved(place, Real(0.99) * slowest) == 0);
  // Beside it, and everywhere else, both sides are alike.
  const Real beside = place + spacing_at(place);
  CHECK(moved(beside, -Real(0.99) * slowest) == 0);
  CHECK(moved(beside, -Real(1.01) * slowest) == -spacing_at(place));
}

TEST_CASE("In float at 60 Hz, 0.029 m/s moves at 10 km and 1.9 m/s at 1000 km") {
  CHECK(std::abs(slowest_drift_at(10e3f, 1.0f / 60) - 0.0293f) < 0.00005f);
  CHECK(std::abs(slowest_drift_at(1e6f, 1.0f / 60) - 1.875f) < 0.0005f);
}

TEST_CASE_TEMPLATE("1 km and 10000 km away two bodies meet as at the origin, to an ulp a step",
                   Real, EVERY_PRECISION) {
  const Real h = Real(1) / 60;
  const int steps = 600;
  const auto gap = [&](Real away) {
    auto chaser = make_particle<Real>(1, {away, 0, 0}, {Real(2.5), 1, 0});
    auto target = make_particle<Real>(1, {away + 16, 0, 0}, {Real(1.25), 0, Real(0.5)});
    const Real rounded = target.position.x() - chaser.position.x() - 16;
    for (int n = 0; n < steps; ++n) {
      for (auto* body : {&chaser, &target}) {
        add_force(*body, Vec3<Real>(0, 0, Real(-9.81)));
        kick(*body, h);
        clear_force(*body);
        drift(*body, h);
      }
    }
    return Vec3<Real>(target.position - chaser.position - rounded * Vec3<Real>::UnitX());
  };
  // Each of two positions is rounded to half a spacing a step. Along y and z nothing is far.
  const Vec3<Real> here = gap(0);
  for (const Real away : {Real(1e3), Real(1e7)}) {
    const Vec3<Real> there = gap(away);
    const Real spacing = spacing_at(away + 64);
    CHECK(std::abs(there.x() - here.x()) <= steps * spacing + steps * spacing_at(Real(32)));
    CHECK(there.y() == here.y());
    CHECK(there.z() == here.z());
    CHECK(digits_needed(double(away) + 64, double(spacing)) <= std::numeric_limits<Real>::digits);
    CHECK(digits_needed(double(away) + 64, double(spacing) / 2) >
          std::numeric_limits<Real>::digits);
  }
}

TEST_CASE("A millimetre at 1 km fits a float's digits, one at 10000 km needs a double") {
  CHECK(spacing_at(999.0f) == 1.0f / 16384);  // 0.06 mm
  CHECK(spacing_at(1e7f) == 1);
  CHECK(spacing_at(1e7) < 1e-8);
  CHECK(digits_needed(1e3, 1e-3) == 20);
  CHECK(digits_needed(1e7, 1e-3) == 34);
  CHECK(digits_needed(16777215, 1) == 24);
  CHECK(digits_needed(16777216, 1) == 25);
  CHECK(complaint_of([] { digits_needed(0, 1); }) ==
        "distance from the origin is 0 m; it must be above 0");
  CHECK(complaint_of([] { digits_needed(1, -1); }) == "resolution is -1 m; it must be above 0");
  CHECK(complaint_of([] { digits_needed(1, 0); }) == "resolution is 0 m; it must be above 0");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(complaint_of([=] { digits_needed(nan, 1); }) ==
        "distance from the origin is nan m; it must be finite");
  CHECK(complaint_of([=] { digits_needed(1, nan); }) == "resolution is nan m; it must be finite");
  CHECK(complaint_of([] { digits_needed(1, std::numeric_limits<double>::infinity()); }) ==
        "resolution is inf m; it must be finite");
  CHECK(complaint_of([] { digits_needed(std::numeric_limits<double>::infinity(), 1); }) ==
        "distance from the origin is inf m; it must be finite");
}
