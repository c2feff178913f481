#include <cstdlib>
#include <support/bad_vectors.hpp>
#include <tumble/force.hpp>

using namespace tumble;
using namespace tumble::support;

TEST_CASE_TEMPLATE(
    "A mass that is zero, negative, NaN or infinite is refused by name, value and rule", Real,
    EVERY_PRECISION) {
  const Real infinity = std::numeric_limits<Real>::infinity(),
             nan = std::numeric_limits<Real>::quiet_NaN();
  const auto complaint = [](Real mass) { return complaint_of([mass] { make_particle(mass); }); };
  CHECK(complaint(0) == "mass is 0 kg; it must be greater than 0");
  CHECK(complaint(-2) == "mass is -2 kg; it must be greater than 0");
  CHECK(complaint(nan) == "mass is nan kg; it must be greater than 0");
  CHECK(complaint(-nan) == complaint(nan));  // its sign means nothing
  CHECK(complaint(infinity) ==
        "mass is inf kg; for a body that nothing can move, use make_static_particle");
  CHECK(complaint(-infinity) == "mass is -inf kg; it must be greater than 0");
}

TEST_CASE_TEMPLATE("A mass whose inverse loses digits or overflows is refused", Real,
                   EVERY_PRECISION) {
  using Limits = std::numeric_limits<Real>;
  const auto complaint = [](Real mass) { return complaint_of([mass] { make_particle(mass); }); };
  CHECK(complaint(Limits::denorm_min()).find("it must lie between") != std::string::npos);
  CHECK(complaint(Limits::max()).find("it must lie between") != std::string::npos);
  CHECK(complaint(Limits::min()) == "nothing thrown");
  CHECK(complaint(1 / Limits::min()) == "nothing thrown");
  CHECK(std::isnormal(make_particle(Limits::min()).inverse_mass));
  CHECK(std::isnormal(make_particle(1 / Limits::min()).inverse_mass));
}

TEST_CASE_TEMPLATE("A force that is not finite is refused, and the particle keeps every bit", Real,
                   EVERY_PRECISION) {
  Particle<Real> particle = make_particle(Real(2));
  add_force(particle, Vec3<Real>(1, 2, 3));
  const Real bad = std::numeric_limits<Real>::quiet_NaN();
  CHECK(complaint_of([&] { add_force(particle, Vec3<Real>(4, bad, 5)); }) ==
        "force is (4, nan, 5) N; every component must be finite");
  CHECK(same_bits(particle.force, Vec3<Real>(1, 2, 3)));
}

TEST_CASE_TEMPLATE("Positions and velocities that are not finite are refused", Real,
                   EVERY_PRECISION) {
  const Vec3<Real> bad(0, std::numeric_limits<Real>::infinity(), 0), good(1, 2, 3);
  CHECK(complaint_of([&] { make_particle(Real(1), bad); }) ==
        "position is (0, inf, 0) m; every component must be finite");
  CHECK(complaint_of([&] { make_particle(Real(1), good, bad); }) ==
        "velocity is (0, inf, 0) m/s; every component must be finite");
  CHECK(complaint_of([&] { make_static_particle(bad); }) ==
        "position is (0, inf, 0) m; every component must be finite");
}

TEST_CASE_TEMPLATE(
    "A time step of zero changes nothing; negative, NaN and infinite ones are refused", Real,
    EVERY_PRECISION) {
  const Vec3<Real> position(1, 2, 3), velocity(4, 5, 6);
  Particle<Real> particle = make_particle(Real(2), position, velocity);
  add_force(particle, Vec3<Real>(7, 8, 9));
  step(particle, checked_time_step(Real(0)));
  CHECK(same_bits(particle.position, position));
  CHECK(same_bits(particle.velocity, velocity));

  CHECK(complaint_of([] { checked_time_step(Real(-0.5)); }) ==
        "time step is -0.5 s; time runs forward: it must be 0 or more");
  CHECK(complaint_of([] { checked_time_step(std::numeric_limits<Real>::quiet_NaN()); }) ==
        "time step is nan s; it must be finite");
  CHECK(complaint_of([] { checked_time_step(std::numeric_limits<Real>::infinity()); }) ==
        "time step is inf s; it must be finite");
}

TEST_CASE_TEMPLATE("A mass twice as large as the largest allowed is refused with both limits", Real,
                   EVERY_PRECISION) {
  const Real smallest = std::numeric_limits<Real>::min(), too_much = 1.5f / smallest;
  CHECK(complaint_of([&] { make_particle(too_much); }) ==
        "mass is " + text_of(too_much) + " kg; it must lie between " + text_of(smallest) + " and " +
            text_of(1 / smallest) + " kg");
}

TEST_CASE_TEMPLATE("What has no unit is refused without one", Real, EVERY_PRECISION) {
  CHECK(complaint_of([] { require_between<Real>("ratio", 3, "", 0, 2); }) ==
        "ratio is 3; it must lie between 0 and 2");
  CHECK(complaint_of([] { require_between<Real>("ratio", 2, "", 0, 2); }) == "nothing thrown");
  CHECK(complaint_of([] { require_between<Real>("ratio", 0, "", 0, 2); }) == "nothing thrown");
  // Between which two numbers should NaN lie?
  CHECK(complaint_of([] {
          require_between<Real>("ratio", std::numeric_limits<Real>::quiet_NaN(), "", 0, 2);
        }) == "ratio is nan; it must lie between 0 and 2");
}

TEST_CASE_TEMPLATE("A number in a refusal reads back as the number that was refused", Real,
                   EVERY_PRECISION) {
  CHECK(text_of(Real(0.1)) == "0.1");
  for (Real number = 4 * std::numeric_limits<Real>::min(); std::isfinite(number);
       number *= Real(1.7e5)) {
    const std::string text = text_of(-number / 3);
    const Real back = std::is_same_v<Real, float> ? Real(std::strtof(text.c_str(), nullptr))
                                                  : Real(std::strtod(text.c_str(), nullptr));
    CHECK(back == -number / 3);
  }
}

TEST_CASE_TEMPLATE("One bad component is enough, whichever it is", Real, EVERY_PRECISION) {
  using Vector = Vec3<Real>;
  Particle<Real> particle = make_particle(Real(2));
  check_refuses_bad_vectors<Real>("force", "N", [&](const Vector& v) { add_force(particle, v); });
  check_refuses_bad_vectors<Real>("position", "m",
                                  [](const Vector& v) { make_particle(Real(1), v); });
  check_refuses_bad_vectors<Real>(
      "velocity", "m/s", [](const Vector& v) { make_particle(Real(1), Vector(1, 2, 3), v); });
  check_refuses_bad_vectors<Real>("position", "m",
                                  [](const Vector& v) { make_static_particle(v); });
  CHECK(same_bits(particle.force, Vector::Zero()));
}

TEST_CASE_TEMPLATE("What must not be negative may be zero, and must be finite", Real,
                   EVERY_PRECISION) {
  const auto complaint = [](Real value) {
    return complaint_of([value] { require_not_negative("stiffness", value, "N/m"); });
  };
  CHECK(complaint(0) == "nothing thrown");
  CHECK(complaint(Real(0.5)) == "nothing thrown");
  CHECK(complaint(Real(-0.5)) == "stiffness is -0.5 N/m; it must be 0 or more");
  CHECK(complaint(std::numeric_limits<Real>::infinity()) ==
        "stiffness is inf N/m; it must be finite");
}
