#include <numbers>
#include <support/body_bounds.hpp>
#include <support/checks.hpp>
#include <tumble/force.hpp>
#include <tumble/interpolation.hpp>
#include <tumble/step_clock.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

/// The turn takes two products, a logarithm, an exponential and a third product: some forty
/// roundings of numbers of size π at most.
template <class Real>
const Real turn_error = 40 * std::numbers::pi_v<Real>* unit_roundoff<Real>;

template <class Real>
Pose<Real> random_pose(std::mt19937_64& generator) {
  return {random_vector<Real>(generator), random_orientation<Real>(generator)};
}

}  // namespace

TEST_CASE_TEMPLATE("Between two poses both the position and the turn advance evenly", Real,
                   EVERY_PRECISION) {
  std::mt19937_64 generator(12);
  for (int n = 0; n < 200; ++n) {
    const Pose<Real> from = random_pose<Real>(generator), to = random_pose<Real>(generator);
    const Real angle = angle_between(from.orientation, to.orientation);
    for (const Real fraction : {Real(0.125), Real(0.5), Real(0.9)}) {
      const Pose<Real> drawn = interpolated(from, to, fraction);
      const Real size = from.position.norm() + to.position.norm();
      REQUIRE(
          distance<Real>(drawn.position, (1 - fraction) * from.position + fraction * to.position) <=
          6 * unit_roundoff<Real> * size);
      REQUIRE(std::abs(norm(drawn.orientation) - 1) <= turn_error<Real>);
      REQUIRE(std::abs(angle_between(from.orientation, drawn.orientation) - fraction * angle) <=
              turn_error<Real>);
      REQUIRE(std::abs(angle_between(drawn.orientation, to.orientation) - (1 - fraction) * angle) <=
              turn_error<Real>);
    }
    const Pose<Real> begin = interpolated(from, to, Real(0)), end = interpolated(from, to, Real(1));
    REQUIRE(same_bits(begin.position, from.position));
    REQUIRE(begin.orientation.real == from.orientation.real);
    REQUIRE(same_bits(begin.orientation.imaginary, from.orientation.imaginary));
    REQUIRE(distance(end.position, to.position) <=
            2 * unit_roundoff<Real> * (from.position.norm() + to.position.norm()));
    REQUIRE(angle_between(end.orientation, to.orientation) <= turn_error<Real>);
  }
}

TEST_CASE_TEMPLATE("A turn is drawn along the shortest arc, whichever sign the quaternion has",
                   Real, EVERY_PRECISION) {
  std::mt19937_64 generator(13);
  for (int n = 0; n < 200; ++n) {
    const Pose<Real> from = random_pose<Real>(generator), to = random_pose<Real>(generator);
    const Pose<Real> same{to.position, -to.orientation};
    const Pose<Real> drawn = interpolated(from, to, Real(0.5)),
                     drawn_same = interpolated(from, same, Real(0.5));
    REQUIRE(same_bits(drawn.orientation.imaginary, drawn_same.orientation.imaginary));
    REQUIRE(drawn.orientation.real == drawn_same.orientation.real);
    REQUIRE(angle_between(from.orientation, drawn.orientation) <=
            std::numbers::pi_v<Real> / 2 + turn_error<Real>);
  }
}

TEST_CASE_TEMPLATE("The turn between two poses is about a fixed axis of the world", Real,
                   EVERY_PRECISION) {
  const Vec3<Real> up(0, 0, 1);
  Pose<Real> from, to;
  from.orientation = quaternion_about(Vec3<Real>(1, 2, 2), Real(0.7));
  to.orientation = quaternion_about(up, Real(1.5)) * from.orientation;
  const Quaternion<Real> expected = quaternion_about(up, Real(0.5)) * from.orientation;
  const Pose<Real> drawn = interpolated(from, to, Real(1) / 3);
  CHECK(angle_between(drawn.orientation, expected) <= turn_error<Real>);
}

TEST_CASE("Drawn between two states an evenly moving body is where it was one step before") {
  StepClock clock = make_step_clock(steps_per_second(60));
  const double speed = 3, h = time_step_of<double>(clock.step);
  Particled ball = make_particle(1.0, Vec3d(0, 0, 0), Vec3d(speed, 0, 0));
  Posed previous, now;
  std::mt19937_64 generator(14);
  for (int n = 0; n < 1000; ++n) {
    // Frames of 1 to 40 ms, which no cap shortens.
    const std::int64_t due =
        steps_due(clock, static_cast<std::int64_t>(1'000'000 + generator() % 39'000'000));
    for (std::int64_t k = 0; k < due; ++k) {
      previous = now;
      step(ball, h);
      now.position = ball.position;
    }
    if (clock.steps == 0) continue;  // one state yet, and nothing to lie between
    const Posed drawn = interpolated(previous, now, fraction_of_step<double>(clock));
    const double time = double(clock.time_in) / 1e9;
    // The place adds up one product a step, two roundings each; the other numbers round some 8
    // times.
    const double bound =
        (2 * double(clock.steps) + 8) * unit_roundoff<double> * (speed * time + speed * h);
    REQUIRE(std::abs(drawn.position.x() - speed * (time - h)) <= bound);
  }
  CHECK(clock.dropped_time + clock.dropped_steps == 0);
}

TEST_CASE(
    "A body that turns by more than half a turn in a step, and less than one, is drawn backwards") {
  const Vec3d up(0, 0, 1);
  const double whole = 2 * std::numbers::pi;
  const auto drawn = [&](double turn) {
    const Posed from, to{.position = {0, 0, 0}, .orientation = quaternion_about(up, turn)};
    return 2 * rotation_vector_of(interpolated(from, to, 0.5).orientation).z();
  };
  for (const double turn : {3.2, 3.3, 5.0, 6.2}) {
    CHECK(drawn(turn) < 0);
    CHECK(std::abs(drawn(turn) - (turn - whole)) <= 2 * turn_error<double>);
  }
  // Beyond a whole turn it is drawn forwards again, by what is left over.
  for (const double turn : {6.4, 7.0, 9.0})
    CHECK(std::abs(drawn(turn) - (turn - whole)) <= 2 * turn_error<double>);
}
