// What a world does with the longest step and with none, with a rule that blows up, and with a rod.
#include <cfenv>
#include <support/checks.hpp>
#include <support/random_quaternion.hpp>
#include <support/tumbling_problems.hpp>
#include <tumble/damping.hpp>
#include <tumble/gravity.hpp>
#include <tumble/spheres.hpp>
#include <tumble/thruster.hpp>
#include <tumble/world.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

template <class Action>
std::string complaint_of_any(const Action& action) {
  try {
    action();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "nothing thrown";
}

}  // namespace

TEST_CASE_TEMPLATE("Down to the slowest speed the turn of a box makes no number that underflows",
                   Real, EVERY_PRECISION) {
  // A turn squares L, of I times the slowest speed or more. That speed is 2^33 times the root of
  // the smallest normal number, so the square is normal where I is 2^-33 kg m² or more; for the
  // grain of dust it is not.
  void (*volatile turn)(Top<Real>&, Same<Real>) = turn_by_splitting<Real>;  // not known beforehand
  const auto underflows = [&](Real moment, Real speed) {
    Top<Real> top{.orientation = {Real(0.5), {Real(0.5), Real(0.5), Real(0.5)}},
                  .angular_momentum_body = moment * speed * Vec3<Real>(1, 2, Real(2.7)),
                  .inverse_moments = Vec3<Real>(1, Real(0.5), Real(0.37)) / moment};
    std::feclearexcept(FE_UNDERFLOW);
    turn(top, Real(1) / 60);
    return std::fetestexcept(FE_UNDERFLOW) != 0;
  };
  for (const Real moment : {std::ldexp(Real(1), -32), Real(1e-6), Real(1), Real(1000)})
    for (Real speed = 1; speed > slowest_speed<Real>; speed /= Real(3.7)) {
      CAPTURE(moment);
      CAPTURE(speed);
      CHECK_FALSE(underflows(moment, speed));
    }
  CHECK(underflows(Real(1e-13), 2 * slowest_speed<Real>));
}

TEST_CASE_TEMPLATE(
    "In a step of no time no force or push moves a body; a negative one, or one over an hour, is "
    "refused",
    Real, EVERY_PRECISION) {
  World<Real> still(StepLength{.numerator = 0, .denominator = 1});
  const BodyHandle body =
      still.add("brick", make_rigid_body<Real>("brick", mass_properties(Box<Real>{{1, 2, 3}}, 2),
                                               {}, {4, 5, 6}, {1, 2, 3})
                             .body);
  const RigidBody<Real> before = still.body(body);
  still.add(Gravity<Real>{});
  still.add(Thruster<Real>{.force_body = {1, 2, 3}, .point = {1, 0, 0}}, {body});
  still.push_at(body, {1, 2, 3}, {3, 2, 1});
  still.step();
  const RigidBody<Real> after = still.body(body);
  CHECK(same_bits(after.centre.position, before.centre.position));
  CHECK(same_bits(after.centre.velocity, before.centre.velocity));
  CHECK(same_bits(after.top.orientation, before.top.orientation));
  CHECK(same_bits(after.top.angular_momentum_body, before.top.angular_momentum_body));
  const auto refused = [](std::int64_t numerator, std::int64_t denominator) {
    return complaint_of([&] { World<Real>(StepLength{numerator, denominator}); });
  };
  CHECK(refused(-5, 1) ==
        "numerator of the step is -5 ns; it must lie between 0 and 3600000000000 ns");
  CHECK(refused(3'600'000'000'001, 1) ==
        "numerator of the step is 3600000000001 ns; it must lie between 0 and 3600000000000 ns");
  CHECK(refused(1, 0) == "denominator of the step is 0; it must lie between 1 and 1000000");
  CHECK(refused(1, -1) == "denominator of the step is -1; it must lie between 1 and 1000000");
}

TEST_CASE_TEMPLATE("In a step of an hour a body moves and turns as far as asked, or says why not",
                   Real, EVERY_PRECISION) {
  const auto ball = [](Real spin) {
    return make_rigid_body<Real>("ball", mass_properties(Sphere<Real>{1}, 1), {}, {1, 0, 0},
                                 {0, 0, spin})
        .body;
  };
  World<Real> slow(step_of_nanoseconds(3'600'000'000'000)), fast = slow;
  const BodyHandle body = slow.add("ball", ball(Real(0.5)));  // 1800 rad
  slow.step();
  CHECK(slow.position(body).x() == 3600);
  // L is rounded twice, the spin and the angle once each: 1800 rad magnify that.
  const Quaternion<Real> asked = quaternion_about<Real>(Vec3<Real>::UnitZ(), 1800);
  CHECK(angle_between(slow.orientation(body), asked) <= 1800 * 4 * unit_roundoff<Real>);
  fast.add("ball", ball(1000));
  CHECK(complaint_of_any([&] { fast.step(); }).find("'ball' at 0 s (step 0): it would turn by ") ==
        0);
}

TEST_CASE_TEMPLATE("A rule that blows up stops the world, which names the body, the step and limit",
                   Real, EVERY_PRECISION) {
  World<Real> world(steps_per_second(60), ExplicitEuler{});
  RigidBody<Real> needle;
  needle.centre = make_particle<Real>(1);
  needle.top = top_of<Real>(tumbling_problems[3]);
  world.add("needle", needle);
  const std::string what = complaint_of_any([&] {
    for (int n = 0; n < 1000; ++n) world.step();
  });
  CAPTURE(what);
  CHECK(what.find("'needle' at ") == 0);
  CHECK(what.find("(step " + std::to_string(world.ticks()) + ")") != std::string::npos);
  CHECK(what.find(" rad in this step, and no finite orientation was found; at most " +
                  text_of(2 * SineCosineConstants<Real>::limit) +
                  " rad can be turned; the world is as it was before this step") !=
        std::string::npos);
  CHECK(is_finite(world.body(world.find("needle")).top.angular_momentum_body));
}

TEST_CASE_TEMPLATE("A rod without thickness never turns about its line, however it is pushed", Real,
                   EVERY_PRECISION) {
  World<Real> world(steps_per_second(64));
  RigidBody<Real> rod = make_rigid_body<Real>("rod", mass_properties(ThinRod<Real>{2}, 3), {},
                                              {0, 0, 0}, {1, 0, 0}, Turning::locked_where_thin)
                            .body;
  Eigen::Index line = 0;
  REQUIRE(rod.top.inverse_moments.minCoeff(&line) == 0);
  const BodyHandle body = world.add("rod", rod);
  world.add(Thruster<Real>{.force_body = {1, 2, 3}, .point = {1, 1, 1}}, {body});
  std::mt19937_64 generator(146);
  std::uniform_real_distribution<Real> some(-1, 1);
  const auto vector = [&] {
    const Real x = some(generator), y = some(generator);
    return Vec3<Real>(x, y, some(generator));
  };
  for (int n = 0; n < 100; ++n) {
    world.push_at(body, vector(), vector());
    world.apply_impulse_at(body, vector(), vector());
    world.step();
    CHECK(world.body(body).top.angular_momentum_body[line] == 0);
  }
  CHECK(is_finite(world.body(body).top.angular_momentum_body));
  // What makes 1/0 of it is refused.
  rod.top.inverse_moments[line] = std::numeric_limits<Real>::infinity();
  CHECK(complaint_of([&] { world.add("naive", rod); }).find("naive: inverse moments is (") == 0);
}
