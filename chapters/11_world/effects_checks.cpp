#include <support/checks.hpp>
#include <support/random_world.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

template <class Real>
RigidBody<Real> ball_body(const Vec3<Real>& place, const Vec3<Real>& velocity,
                          const Vec3<Real>& spin) {
  return make_rigid_body<Real>("ball", mass_properties(Sphere<Real>{Real(0.5)}, 2), {place},
                               velocity, spin)
      .body;
}

/// The user's own effect: a breeze that comes and goes.
template <class Real>
struct Breeze {
  static constexpr std::string_view name = "breeze";
  Vec3<Real> push = {1, 0, 0};  // N
  Vec3<Real> force(const Particle<Real>&, Real time) const { return std::sin(time) * push; }
};

/// Sets a velocity with its own hands, in the phase that it is told.
template <class Real, Phase when>
struct Motor {
  static constexpr std::string_view name = "motor";
  static constexpr Phase phase = when;
  Real speed = 1;
  Vec3<Real> velocity(const Particle<Real>&, const StepTime<Real>&) const { return {speed, 0, 0}; }
};

}  // namespace

TEST_CASE_TEMPLATE("Gravity as force and as acceleration lead through the same points, to rounding",
                   Real, EVERY_PRECISION) {
  World<Real> by_force, by_acceleration;
  const BodyHandle a = by_force.add("stone", make_particle<Real>(3, {0, 0, 9}, {1, 0, 5}));
  const BodyHandle b = by_acceleration.add("stone", make_particle<Real>(3, {0, 0, 9}, {1, 0, 5}));
  by_force.add(Gravity<Real>{});
  by_acceleration.add(GravityAsAcceleration<Real>{});
  const int steps = 60;
  for (int n = 0; n < steps; ++n) {
    by_force.step();
    by_acceleration.step();
  }
  // m g/m rounds three times more than g; speeds and places stay below 16.
  CHECK(distance(by_force.position(a), by_acceleration.position(b)) <=
        steps * 8 * 16 * unit_roundoff<Real>);
}

TEST_CASE_TEMPLATE("A body circles a point of gravity in Kepler's time", Real, EVERY_PRECISION) {
  // G M = 8, r = 2: v² = G M/r = 4 and the period is 2π r/v = 2π s.
  const int steps = 4096;
  const Real period = 2 * std::numbers::pi_v<Real>;
  World<Real> world(
      step_of_nanoseconds(static_cast<std::int64_t>(std::llround(2e9 * std::numbers::pi / steps))));
  // Kick before drift is a leapfrog whose velocity lags by half a step: start it so, and the orbit
  // closes to second order, with a phase error of (2π)³/(24 · 4096²) · 2π < 1e-5 turns.
  const Real h = world.time_step();
  const BodyHandle moon = world.add("moon", make_particle<Real>(5, {2, 0, 0}, {h, 2, 0}));
  world.add(PointGravity<Real>{.strength = 8});
  for (int n = 0; n < steps; ++n) {
    world.step();
    // The radius wavers by second order, (ω h)²/4 of itself, and by rounding.
    REQUIRE(std::abs(world.position(moon).norm() - 2) <=
            2 * (period / steps) * (period / steps) + 8 * steps * unit_roundoff<Real>);
  }
  const Vec3<Real> end = world.position(moon);
  CHECK(std::abs(end.y() / 2) <= Real(2e-5) + 16 * steps * unit_roundoff<Real>);
}

TEST_CASE_TEMPLATE("Point gravity falls with the square of the distance, towards the point", Real,
                   EVERY_PRECISION) {
  const PointGravity<Real> gravity{.strength = 12, .centre = {1, 1, 1}};
  const auto force = [&](Real x) {
    return gravity.force(make_particle<Real>(3, {1 + x, 1, 1}), 0);
  };
  CHECK(same_bits(force(1), Vec3<Real>(-36, 0, 0)));
  CHECK(same_bits(force(-2), Vec3<Real>(9, 0, 0)));
  const Real far = Real(1e15);  // |r|³ is beyond float
  CHECK(force(far).x() == doctest::Approx(-36 / (1e15 * 1e15)).epsilon(1e-5));
  // −dU/dx = F, by a difference whose step is a power of two.
  const auto energy = [&](Real x) {
    const Particle<Real> at = make_particle<Real>(3, {1 + x, 1, 1});
    return gravity.potential_energy({at, Top<Real>{}});
  };
  const Real h = Real(1) / 256;
  // Third derivative of 36/x at 1 is 216: the difference is off by 36 h², and rounds by u 36/h.
  CHECK(std::abs((energy(1 - h) - energy(1 + h)) / (2 * h) + 36) <=
        40 * h * h + 4 * 36 * unit_roundoff<Real> / h);
}

TEST_CASE_TEMPLATE("A spring to a point is chapter 6's oscillator, to rounding", Real,
                   EVERY_PRECISION) {
  World<Real> world(steps_per_second(100));
  const BodyHandle ball = world.add("ball", make_particle<Real>(2, {3, 0, 0}));
  world.add(SpringToPoint<Real>{.spring = {.stiffness = 50, .damping = 1, .rest_length = 1},
                                .anchor = {1, 0, 0}},
            {ball});
  Real x = 1, v = 0;  // the stretch
  const Real h = world.time_step();
  const int steps = 200;
  for (int n = 0; n < steps; ++n) {
    v += h * (-50 * x - v) / 2;
    x += h * v;
    world.step();
    REQUIRE(std::abs(world.position(ball).x() - 2 - x) <= Real(n + 1) * 32 * unit_roundoff<Real>);
  }
}

TEST_CASE_TEMPLATE("A spring off the centre gives the torque of its force at its attachment", Real,
                   EVERY_PRECISION) {
  RandomGenerator dice(3);
  for (int n = 0; n < 50; ++n) {
    RigidBody<Real> body =
        make_rigid_body<Real>(
            "box", mass_properties(Box<Real>{{1, 2, 3}}, 2),
            {dice.vector<Real>(), quaternion_of_rotation_vector<Real>(3 * dice.vector<Real>())},
            dice.vector<Real>(), dice.vector<Real>())
            .body;
    const SpringToPoint<Real> spring{
        .spring = {.stiffness = 3, .damping = 2, .rest_length = Real(0.5)},
        .anchor = {5, 5, 5},
        .attachment = dice.vector<Real>()};
    const Push<Real> push = spring.push({body.centre, body.top}, 0);
    // By chapter 5's functions: the point of the body, its velocity, the force at it.
    const Vec3<Real> point = point_outward(pose_of(body), spring.attachment);
    const Vec3<Real> along = (point - spring.anchor).normalized();
    const Real length = (point - spring.anchor).norm();
    const Real tension = 3 * (length - Real(0.5)) + 2 * velocity_at(body, point).dot(along);
    add_force_at<Real>(body, -tension * along, point);
    // Forces below 64 N, arms below 2 m; some sixty roundings.
    CHECK(distance(push.force, body.centre.force) <= 64 * 64 * unit_roundoff<Real>);
    CHECK(distance(push.torque, body.top.torque) <= 128 * 64 * unit_roundoff<Real>);
    CHECK(push.torque.norm() > 0);
  }
}

TEST_CASE_TEMPLATE("A tether pulls and never pushes", Real, EVERY_PRECISION) {
  const Spring<Real> tether{.stiffness = 10, .damping = 1, .rest_length = 2, .only_pulls = true};
  const Vec3<Real> rest(0, 0, 0), outward(3, 0, 0), inward(-30, 0, 0);
  CHECK(same_bits(spring_force<Real>(tether, {3, 0, 0}, rest), Vec3<Real>(-10, 0, 0)));
  CHECK(same_bits(spring_force<Real>(tether, {1, 0, 0}, outward), rest));
  CHECK(same_bits(spring_force<Real>(tether, {3, 0, 0}, inward), rest));
  CHECK(spring_energy<Real>(tether, {1, 0, 0}) == 0);
  CHECK(spring_energy<Real>(tether, {4, 0, 0}) == 20);
  CHECK(same_bits(spring_force<Real>(tether, rest, rest), rest));
  RandomGenerator dice(4);
  for (int n = 0; n < 1000; ++n) {
    const Vec3<Real> extent = 4 * dice.vector<Real>(), rate = 50 * dice.vector<Real>();
    CHECK(spring_force<Real>(tether, extent, rate).dot(extent) <= 0);
  }
}

TEST_CASE_TEMPLATE("A thruster turns with its body: it spins up as τ t/I and pushes along itself",
                   Real, EVERY_PRECISION) {
  World<Real> world(steps_per_second(128));
  RigidBody<Real> start = ball_body<Real>({0, 0, 0}, {0, 0, 0}, {0, 0, 0});
  start.top.orientation = quaternion_of_rotation_vector<Real>({1, -1, Real(0.5)});
  const BodyHandle ball = world.add("ball", start);
  world.add(Thruster<Real>{.force_body = {0, 1, 0}, .point = {2, 0, 0}, .from = 1, .until = 3},
            {ball});
  Vec3<Real> momentum = Vec3<Real>::Zero();
  for (int n = 0; n < 512; ++n) {
    const Real burning = n >= 128 && n < 384 ? Real(1) : Real(0);
    momentum +=
        burning * world.time_step() * rotate<Real>(world.orientation(ball), Vec3<Real>(0, 1, 0));
    world.step();
  }
  const RigidBody<Real> end = world.body(ball);
  // I = 2/5 · 2 kg · (0.5 m)² = 0.2 kg m², τ = 2 N m for 2 s: ω = 20 rad/s about the ball's own z
  // axis, after 256 kicks; a step turns that axis by no more than 8 roundings.
  const Vec3<Real> axis = rotate<Real>(start.top.orientation, Vec3<Real>(0, 0, 1));
  CHECK(distance<Real>(angular_velocity_world(end.top), 20 * axis) <=
        (256 * 4 + 512 * 8) * 20 * unit_roundoff<Real>);
  CHECK(distance(tumble::momentum(end), momentum) <= 512 * 8 * unit_roundoff<Real>);
}

TEST_CASE_TEMPLATE(
    "A thruster acts in the steps that begin while it burns, and if none begins, in none", Real,
    EVERY_PRECISION) {
  const auto speed_after = [](Real from, Real until) {
    World<Real> world(steps_per_second(64));
    const BodyHandle ball = world.add("ball", ball_body<Real>({0, 0, 0}, {0, 0, 0}, {0, 0, 0}));
    world.add(Thruster<Real>{.force_body = {0, 64, 0}, .from = from, .until = until}, {ball});
    for (int n = 0; n < 10; ++n) world.step();
    return world.velocity(ball).y();  // half a metre per second for each step
  };
  const Real h = Real(1) / 64;
  CHECK(speed_after(2 * h, 5 * h) == Real(1.5));
  CHECK(speed_after(2 * h, Real(2.001) * h) == Real(0.5));
  CHECK(speed_after(Real(2.001) * h, Real(2.999) * h) == 0);
}

TEST_CASE_TEMPLATE(
    "By Verlet a thruster acts in the steps in whose middle it burns, and by Suzuki in each kick "
    "by itself, the backward one too",
    Real, EVERY_PRECISION) {
  const auto steps_burnt = [](Scheme scheme, Real from, Real until) {
    World<Real> world(steps_per_second(1));
    world.step_by(scheme);
    const BodyHandle ball = world.add("ball", ball_body<Real>({0, 0, 0}, {0, 0, 0}, {0, 0, 0}));
    world.add(Thruster<Real>{.force_body = {0, 2, 0}, .from = from, .until = until}, {ball});
    for (int n = 0; n < 4; ++n) world.step();
    return world.velocity(ball).y();  // a metre per second for each step
  };
  CHECK(steps_burnt(Scheme::verlet, 0, Real(0.49)) == 0);
  CHECK(steps_burnt(Scheme::verlet, Real(1.49), Real(1.51)) == 1);
  // Suzuki's five kicks come at 0.21, 0.62, 0.5, 0.38 and 0.79 of a step.
  const Real p = 1 / (4 - std::cbrt(Real(4))), rounding = 16 * unit_roundoff<Real>;
  CHECK(std::abs(steps_burnt(Scheme::suzuki, 1, Real(1.3)) - p) <= rounding);
  CHECK(std::abs(steps_burnt(Scheme::suzuki, Real(1.45), Real(1.55)) - (1 - 4 * p)) <= rounding);
  // By every scheme what is given differs from what should be by a step's worth at most.
  RandomGenerator dice(5);
  for (const Scheme scheme : {Scheme::semi_implicit_euler, Scheme::verlet, Scheme::suzuki})
    for (int n = 0; n < 100; ++n) {
      const Real from = 1 + dice.real<Real>(), until = from + 1 + dice.real<Real>();
      CAPTURE(from);
      CAPTURE(until);
      CHECK(std::abs(steps_burnt(scheme, from, until) - (until - from)) <= 1 + rounding);
    }
}

TEST_CASE_TEMPLATE(
    "The Magnus force is perpendicular to the spin and to the path through the air: topspin dips",
    Real, EVERY_PRECISION) {
  const Magnus<Real> magnus{.strength = Real(0.5), .wind = {0, 0, 0}};
  // Forward along x, the top side running forward too: ω along +y.
  const RigidBody<Real> topspin = ball_body<Real>({0, 0, 0}, {2, 0, 0}, {0, 4, 0});
  const Vec3<Real> force = magnus.force({topspin.centre, topspin.top}, 0);
  CHECK(std::abs(force.z() + 4) <= 16 * unit_roundoff<Real>);
  CHECK(force.x() == 0);
  const Magnus<Real> with_wind{.strength = Real(0.5), .wind = {2, 0, 0}};
  CHECK(same_bits(with_wind.force({topspin.centre, topspin.top}, 0), Vec3<Real>(0, 0, 0)));
  // With any wind; and towards the side of the ball whose skin, ω × r, runs with the air.
  RandomGenerator dice(8);
  for (int n = 0; n < 50; ++n) {
    const Magnus<Real> wind{.strength = Real(0.5), .wind = dice.vector<Real>()};
    RigidBody<Real> ball = ball_body<Real>({0, 0, 0}, dice.vector<Real>(), 4 * dice.vector<Real>());
    ball.top.orientation = quaternion_of_rotation_vector<Real>(3 * dice.vector<Real>());
    const Vec3<Real> push = wind.force({ball.centre, ball.top}, 0);
    const Vec3<Real> spin = angular_velocity_world(ball.top),
                     path = ball.centre.velocity - wind.wind;
    // A dozen roundings of products up to ½ · 7 · 4 · 7.
    CHECK(std::abs(push.dot(spin)) <= 12 * 98 * unit_roundoff<Real>);
    CHECK(std::abs(push.dot(path)) <= 12 * 98 * unit_roundoff<Real>);
    CHECK(spin.cross(push).dot(-path) > 0);
  }
}

TEST_CASE_TEMPLATE("In still air the Magnus force does no work, and in a wind it does", Real,
                   EVERY_PRECISION) {
  const auto power = [](const Vec3<Real>& wind) {
    const RigidBody<Real> ball = ball_body<Real>({0, 0, 0}, {2, 0, 0}, {0, 4, 0});
    const Magnus<Real> magnus{.strength = Real(0.5), .wind = wind};
    return magnus.force({ball.centre, ball.top}, 0).dot(ball.centre.velocity);
  };
  CHECK(power({0, 0, 0}) == 0);
  CHECK(std::abs(power({0, 0, 3}) + 12) <= 64 * unit_roundoff<Real>);  // ½ 4 y × (2 x − 3 z) · 2 x
}

TEST_CASE_TEMPLATE(
    "A kick by the Magnus force goes along the tangent of the turn: v² grows by (S ω h/m)² of "
    "itself",
    Real, EVERY_PRECISION) {
  World<Real> world(steps_per_second(16));
  const BodyHandle ball = world.add("ball", ball_body<Real>({0, 0, 0}, {2, 0, 0}, {0, 4, 0}));
  world.add(Magnus<Real>{.strength = Real(0.5)});
  const Real part = Real(0.5) * 4 / 16 / 2;  // of a ball of 2 kg
  Real expected = 4;
  for (int n = 1; n <= 100; ++n) {
    world.step();
    expected *= 1 + part * part;
    CHECK(std::abs(world.velocity(ball).squaredNorm() / expected - 1) <=
          Real(n) * 16 * unit_roundoff<Real>);
  }
}

TEST_CASE_TEMPLATE("A ball is lifted by the weight of what it displaces, at every depth", Real,
                   EVERY_PRECISION) {
  const Buoyancy<Real> water{.density = 1000, .radius = 2, .surface = 5, .gravity = 10};
  const auto volume = [&](Real z) {
    return water.force(make_particle<Real>(1, {0, 0, z}), 0).z() / 10'000;
  };
  CHECK(volume(8) == 0);
  CHECK(volume(7) == 0);
  const Real ball = Real(4) / 3 * std::numbers::pi_v<Real> * 8;
  CHECK(std::abs(volume(5) - ball / 2) <= 16 * ball * unit_roundoff<Real>);
  CHECK(std::abs(volume(3) - ball) <= 16 * ball * unit_roundoff<Real>);
  CHECK(std::abs(volume(-90) - ball) <= 16 * ball * unit_roundoff<Real>);
  // Simpson's rule integrates the discs π (r² − z²) exactly: they are of second degree.
  for (const Real height : {Real(6.5), Real(5.25), Real(4), Real(3.5)}) {
    const Real depth = 7 - height;  // of the cap
    const auto disc = [](Real z) { return std::numbers::pi_v<Real> * (4 - z * z); };
    const Real simpson = depth / 6 * (disc(-2) + 4 * disc(-2 + depth / 2) + disc(-2 + depth));
    CHECK(std::abs(volume(height) - simpson) <= 32 * ball * unit_roundoff<Real>);
  }
}

TEST_CASE_TEMPLATE("Damping as an effect keeps the fraction that chapter 9 computes", Real,
                   EVERY_PRECISION) {
  World<Real> world(steps_per_second(50));
  const BodyHandle ball = world.add("ball", ball_body<Real>({0, 0, 0}, {2, 0, 0}, {0, 4, 0}));
  world.add(LinearDamping<Real>{.rate = 3});
  world.add(AngularDamping<Real>{.rate = 5});
  RigidBody<Real> expected = world.body(ball);
  world.step();
  damp(expected.centre, fraction_kept<Real>(3, world.time_step()));
  damp(expected.top, fraction_kept<Real>(5, world.time_step()));
  CHECK(same_bits(world.velocity(ball), expected.centre.velocity));
  CHECK(same_bits(world.body(ball).top.angular_momentum_body, expected.top.angular_momentum_body));
}

TEST_CASE_TEMPLATE("Drag in a world is chapter 9's, wind and all", Real, EVERY_PRECISION) {
  World<Real> world(steps_per_second(64));
  const BodyHandle leaf = world.add("leaf", make_particle<Real>(1));
  world.add(QuadraticDrag<Real>{.coefficient = Real(0.5), .wind = {4, 0, 0}});
  world.step();
  CHECK(world.velocity(leaf).x() == Real(0.125));  // ½ · 4² /64, exact in binary
}

TEST_CASE_TEMPLATE("A force of the user's own is planned, run and named like ours", Real,
                   EVERY_PRECISION) {
  World<Real> world(steps_per_second(1000));
  const BodyHandle leaf = world.add("leaf", make_particle<Real>(2));
  world.add("rock", make_static_particle<Real>({0, 0, 0}));
  world.add(Breeze<Real>{});
  const Plan plan = world.plan();
  const auto row = std::find_if(plan.rows.begin(), plan.rows.end(),
                                [](const PlanRow& r) { return r.effect == "breeze"; });
  REQUIRE(row != plan.rows.end());
  CHECK(row->visited == 1);
  CHECK(row->reason == "not 1: nothing can move them");
  for (int n = 0; n < 3000; ++n) world.step();
  // v = (1 − cos t)/m; the sum of the steps is off by h/2 sin t/m at most, and rounds.
  CHECK(std::abs(world.velocity(leaf).x() - (1 - std::cos(Real(3))) / 2) <=
        Real(0.0005) / 2 + 3000 * 2 * unit_roundoff<Real>);
}

TEST_CASE_TEMPLATE("A velocity that an effect writes moves a body, in whatever phase", Real,
                   EVERY_PRECISION) {
  const auto after_a_second = [](const auto& motor) {
    World<Real> world(steps_per_second(64));
    const BodyHandle ball = world.add("ball", make_particle<Real>(1));
    world.add(motor);
    for (int n = 0; n < 64; ++n) world.step();
    return world.body(ball).centre;
  };
  const Real none = std::numeric_limits<Real>::quiet_NaN();
  const auto check = [&](const auto& motor, const auto& broken, Real expected) {
    CHECK(after_a_second(motor).velocity.x() == 1);
    CHECK(after_a_second(motor).position.x() == expected);
    CHECK_THROWS_WITH_AS(after_a_second(broken),
                         doctest::Contains("motor gives a velocity of (nan, 0, 0) m/s"),
                         SimulationError);
  };
  using enum Phase;
  check(Motor<Real, force>{}, Motor<Real, force>{none}, 1);
  check(Motor<Real, kick>{}, Motor<Real, kick>{none}, 1);
  check(Motor<Real, impulse>{}, Motor<Real, impulse>{none}, 1);
  check(Motor<Real, damping>{}, Motor<Real, damping>{none}, 1);
  // Behind the drift of the first step, it misses one of 64.
  check(Motor<Real, drift>{}, Motor<Real, drift>{none}, Real(63) / 64);
}

TEST_CASE_TEMPLATE(
    "A body of no inverse mass that can turn is turned by a torque, and by a push off its centre",
    Real, EVERY_PRECISION) {
  const auto spin_after_a_step = [](const auto& effect) {
    World<Real> world(steps_per_second(64));
    RigidBody<Real> flywheel = ball_body<Real>({0, 0, 0}, {0, 0, 0}, {0, 0, 0});
    flywheel.centre.inverse_mass = 0;
    const BodyHandle body = world.add("flywheel", flywheel);
    world.add(effect, {body});
    world.step();
    return world.angular_velocity(body).z();
  };
  // 2 N m on 0.2 kg m² either way.
  CHECK(std::abs(spin_after_a_step(SteadyTorque<Real>{{0, 0, 2}}) - Real(10) / 64) <=
        16 * unit_roundoff<Real>);
  const Thruster<Real> thruster{.force_body = {0, 1, 0}, .point = {2, 0, 0}};
  CHECK(std::abs(spin_after_a_step(thruster) - Real(10) / 64) <= 16 * unit_roundoff<Real>);
}

TEST_CASE_TEMPLATE("A torque that is no number stops the step and is named", Real,
                   EVERY_PRECISION) {
  World<Real> world;
  world.add("point", make_particle<Real>(1));
  const auto ball = mass_properties(Sphere<Real>{1}, 5);
  const BodyHandle body = world.add("ball", make_rigid_body<Real>("ball", ball).body);
  world.add(SteadyTorque<Real>{{0, std::numeric_limits<Real>::infinity(), 0}}, {body});
  std::string said;
  try {
    world.step();
  } catch (const SimulationError& error) {
    said = error.what();
  }
  CHECK(said.find("'ball' at 0 s (step 0): steady torque gives a torque of (0, inf, 0) N m") == 0);
}

namespace {

/// Turns nothing: a rule that somebody wrote who knows double alone.
struct Frozen {
  static constexpr std::string_view name = "frozen";
  void operator()(Topd&, double) const {}
};

}  // namespace

TEST_CASE("A rule of the user's own turns a world, alone and in a list") {
  const auto turned = [](const auto& choose) {
    World<double> world;
    choose(world);
    const BodyHandle box =
        world.add("box", make_rigid_body<double>("box", mass_properties(Box<double>{{1, 2, 3}}, 2),
                                                 {}, Vec3d::Zero(), {1, 2, 3})
                             .body);
    const Vec3d before = world.orientation(box).imaginary;
    world.step();
    CHECK(table_of(world.plan()).find(world.turning_method()) != std::string::npos);
    return !same_bits(before, world.orientation(box).imaginary);
  };
  using List = TurningRules<Steady, Frozen, Splitting>;
  CHECK_FALSE(turned([](auto& world) { world.turn_by(Frozen{}); }));
  CHECK_FALSE(turned([](auto& world) { List::choose(world, 1); }));
  CHECK(turned([](auto& world) { List::choose(world, 0); }));
  CHECK(turned([](auto& world) { List::choose(world, 2); }));
}

TEST_CASE_TEMPLATE("A world turns by the rule that was chosen", Real, EVERY_PRECISION) {
  const RigidBody<Real> box = make_rigid_body<Real>("box", mass_properties(Box<Real>{{1, 2, 3}}, 2),
                                                    {}, Vec3<Real>::Zero(), {1, 2, 3})
                                  .body;
  const auto expect = [&]<class Rule>(const Rule& chosen, void (*rule)(Top<Real>&, Same<Real>)) {
    CAPTURE(Rule::name);
    World<Real> from_the_start(steps_per_second(10), chosen), later(steps_per_second(10));
    later.turn_by(chosen);
    Top<Real> top = box.top;
    rule(top, Real(0.1));
    for (World<Real>* world : {&from_the_start, &later}) {
      const BodyHandle handle = world->add("box", box);
      world->step();
      const Top<Real> turned = world->body(handle).top;
      CHECK(world->turning_method() == Rule::name);
      CHECK(same_bits(turned.orientation.imaginary, top.orientation.imaginary));
      CHECK(same_bits(turned.angular_momentum_body, top.angular_momentum_body));
    }
  };
  expect(Splitting{}, &turn_by_splitting<Real>);
  expect(SplittingWithoutSine{}, &turn_by_splitting_without_sine<Real>);
  expect(AxisByAxis{}, &turn_axis_by_axis<Real>);
  expect(CarryingMomentum{}, &turn_carrying_momentum<Real>);
  expect(ImplicitNewton{}, &turn_implicitly<Real>);
  expect(RestoringMomentum{}, &turn_restoring_momentum<Real>);
  expect(ExplicitEuler{}, &turn_explicitly<Real>);
  expect(Steady{}, &turn_steadily<Real>);
}
