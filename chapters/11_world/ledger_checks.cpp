#include <support/checks.hpp>
#include <support/random_world.hpp>
#include <support/size_of_line.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

/// Gravity with the wrong sign.
template <class Real>
struct Upwards {
  static constexpr std::string_view name = "gravity upwards";
  Vec3<Real> force(const Particle<Real>& centre, Real) const {
    return mass_of(centre) * Vec3<Real>(0, 0, 8);
  }
};

/// Adds 1 m/s² to the velocity with its own hands.
template <class Real, Phase when>
struct OwnKick {
  static constexpr std::string_view name = "own kick";
  static constexpr Phase phase = when;
  Vec3<Real> velocity(const Particle<Real>& centre, const StepTime<Real>& moment) const {
    return centre.velocity + Vec3<Real>(moment.time_step, 0, 0);
  }
};

/// An acceleration that depends on the velocity.
template <class Real>
struct Coriolis {
  static constexpr std::string_view name = "Coriolis";
  Vec3<Real> acceleration(const Particle<Real>& centre, Real) const {
    return Vec3<Real>(0, 0, 2).cross(centre.velocity);
  }
};

}  // namespace

TEST_CASE_TEMPLATE("The books close to rounding: what the effects put in is what the bodies have",
                   Real, EVERY_PRECISION) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    CAPTURE(seed);
    RandomGenerator dice(seed);
    World<Real> world = random_world<Real>(dice);
    Ledger<Real> ledger(world);
    double turnover = size_of(ledger.start());
    const int steps = 60;
    for (int n = 0; n < steps; ++n) {
      ledger.step(world);
      turnover = std::max(turnover, size_of(ledger.now(world)));
    }
    for (const LedgerLine& line : ledger.lines()) turnover += size_of(line);
    // In each step each of up to five bodies rounds its sums, its momenta and its place: 32
    // roundings of numbers that are no larger than what was ever had or turned over.
    const double bound = steps * 5 * 32 * static_cast<double>(unit_roundoff<Real>) * (1 + turnover);
    CHECK(size_of(ledger.rest(world)) <= bound);
  }
}

TEST_CASE_TEMPLATE("A step with books is a step without them, to the bit", Real, EVERY_PRECISION) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    RandomGenerator dice(seed);
    World<Real> booked = random_world<Real>(dice);
    World<Real> plain = booked;
    Ledger<Real> ledger(booked);
    for (int n = 0; n < 20; ++n) {
      ledger.step(booked);
      plain.step();
    }
    REQUIRE(same_motion(booked.bodies(), plain.bodies()));
  }
}

TEST_CASE_TEMPLATE(
    "Gravity's line is m g times the height fallen, less that of half a step at the speed "
    "reached",
    Real, EVERY_PRECISION) {
  World<Real> world(steps_per_second(64));  // 1/64 s is a number without rounding
  world.add("stone", make_particle<Real>(2, {0, 0, 100}));
  world.add(Gravity<Real>{.gravity = {0, 0, -8}});
  Ledger<Real> ledger(world);
  const double before = stored_energy(world);
  for (int n = 0; n < 64; ++n) ledger.step(world);
  const double fallen = 100 - static_cast<double>(world.position(world.find("stone")).z());
  // Kick before drift: the fall is ½ g t (t + h) = 4 · 65/64 m, the speed 8 m/s, all exact in
  // binary.
  CHECK(fallen == 4.0625);
  REQUIRE(ledger.lines().size() == 2);
  CHECK(ledger.lines()[0].name == "gravity");
  CHECK(ledger.lines()[0].energy == 64);  // ½ · 2 kg · (8 m/s)²
  CHECK(ledger.lines()[0].momentum == Vec3d(0, 0, -16));
  // Stored energy fell by m g times the height, which is more by half a step at 8 m/s.
  CHECK(before - stored_energy(world) == 2 * 8 * 4.0625);
  CHECK(ledger.lines()[0].energy == 2 * 8 * (4.0625 - 8.0 / 64 / 2));
  CHECK(energy_of(world).motion == 64);
  CHECK(energy_of(world).sum() == before - 2 * 8 * 4.0625 + 64);
}

TEST_CASE_TEMPLATE("A spring between bodies puts in no momentum and no angular momentum", Real,
                   EVERY_PRECISION) {
  World<Real> world(steps_per_second(1000));
  const auto box = [](const Vec3<Real>& place, const Vec3<Real>& spin) {
    return make_rigid_body<Real>("box", mass_properties(Box<Real>{{1, 2, 3}}, 2), {place},
                                 {0, 1, 0}, spin)
        .body;
  };
  const BodyHandle a = world.add("a", box({0, 0, 0}, {1, 2, 3}));
  const BodyHandle b = world.add("b", box({0, 0, 5}, {0, 0, 0}));
  world.add(SpringBetween<Real>{.spring = {.stiffness = 50, .damping = 1, .rest_length = 2},
                                .attachment_first = {Real(0.5), 1, 0},
                                .attachment_second = {0, -1, Real(0.25)}},
            {a, b});
  Ledger<Real> ledger(world);
  double energy_moved = 0;
  const int steps = 500;
  for (int n = 0; n < steps; ++n) {
    ledger.step(world);
    energy_moved = std::max(energy_moved, std::abs(ledger.lines()[0].energy));
  }
  CHECK(energy_moved > 1);  // it did pull
  // A step's force times h is below 50 · 8 / 1000 N s, its arm below 8 m; 16 roundings a step.
  const double bound = steps * 16 * 0.4 * 8 * static_cast<double>(unit_roundoff<Real>);
  CHECK(ledger.lines()[0].momentum.norm() <= bound);
  CHECK(ledger.lines()[0].angular_momentum.norm() <= bound);
}

TEST_CASE_TEMPLATE(
    "The books close for a force of the wrong sign, for velocities that an effect writes, and for "
    "two "
    "accelerations of which the second sees what the first has done",
    Real, EVERY_PRECISION) {
  // A stone of 1 kg that flies at 1 m/s, for a second.
  const auto unexplained = [](const auto&... effects) {
    World<Real> world(steps_per_second(64));
    world.add("stone", make_particle<Real>(1, {0, 0, 0}, {0, 1, 0}));
    (world.add(effects), ...);
    Ledger<Real> ledger(world);
    for (int n = 0; n < 64; ++n) ledger.step(world);
    return std::abs(ledger.rest(world).energy);
  };
  // Numbers below 128, a dozen roundings of them in each step.
  const double rounding = 64 * 12 * 128 * static_cast<double>(unit_roundoff<Real>);
  CHECK(unexplained(Upwards<Real>{}) <= rounding);
  const auto own_kick_in = [&]<Phase phase>(std::integral_constant<Phase, phase>) {
    CAPTURE(int(phase));
    CHECK(unexplained(OwnKick<Real, phase>{}) <= rounding);
    CHECK(unexplained(Upwards<Real>{}, OwnKick<Real, phase>{}, Upwards<Real>{}) <= rounding);
  };
  own_kick_in(std::integral_constant<Phase, Phase::force>());
  own_kick_in(std::integral_constant<Phase, Phase::kick>());
  own_kick_in(std::integral_constant<Phase, Phase::impulse>());
  own_kick_in(std::integral_constant<Phase, Phase::damping>());
  own_kick_in(std::integral_constant<Phase, Phase::drift>());
  const GravityAsAcceleration<Real> sideways{.gravity = {-8, 0, 0}};
  CHECK(unexplained(Coriolis<Real>{}) <= rounding);
  CHECK(unexplained(sideways, Coriolis<Real>{}) <= rounding);
  CHECK(unexplained(Upwards<Real>{}, sideways, Coriolis<Real>{}) <= rounding);
}

TEST_CASE_TEMPLATE("A failed step leaves the books as they were", Real, EVERY_PRECISION) {
  World<Real> world;
  const BodyHandle stone = world.add("stone", make_particle<Real>(1));
  world.add(PointGravity<Real>{.strength = 1});
  Ledger<Real> ledger(world);
  const std::size_t lines = ledger.lines().size();
  CHECK_THROWS_AS(ledger.step(world), SimulationError);
  CHECK(ledger.lines().size() == lines);
  CHECK(world.ticks() == 0);
  world.set_position(stone, {1, 0, 0});
  ledger.step(world);
  CHECK(ledger.lines()[0].momentum.x() < 0);
}

namespace {

/// Drives a top by nothing, and stores where its body is.
template <class Real>
struct Shelf {
  static constexpr std::string_view name = "shelf";
  Vec3<Real> torque(const Top<Real>&, Real) const { return Vec3<Real>::Zero(); }
  Real potential_energy(const BodyState<Real>& body) const { return body.centre.position.x(); }
};

}  // namespace

TEST_CASE_TEMPLATE("What an effect on tops stores is asked of their bodies, also behind points",
                   Real, EVERY_PRECISION) {
  World<Real> world;
  world.add("point", make_particle<Real>(1, {100, 0, 0}));
  RigidBody<Real> body;
  body.centre = make_particle<Real>(1, {6, 0, 0});
  body.top.inverse_moments = {1, 1, 1};
  body.top.angular_momentum_body = {0, 2, 0};
  world.add("body", body);
  world.add(Shelf<Real>{});
  CHECK(stored_energy(world) == 6);
  CHECK(energy_of(world).turning == 2);
}

TEST_CASE_TEMPLATE("The books close for a push of one step, however often the scheme kicks in it",
                   Real, EVERY_PRECISION) {
  for (const Scheme scheme : {Scheme::semi_implicit_euler, Scheme::verlet, Scheme::suzuki}) {
    CAPTURE(name_of(scheme));
    World<Real> world(steps_per_second(8));
    world.step_by(scheme);
    const BodyHandle stone = world.add("stone", make_particle<Real>(1));
    Ledger<Real> ledger(world);
    world.push_at(stone, {16, 0, 0}, {0, 0, 0});
    ledger.step(world);
    // 16 N for 1/8 s; Suzuki's five kicks and their sum are rounded once each.
    CHECK(std::abs(ledger.now(world).momentum.x() - 2) <= 16 * unit_roundoff<Real>);
    CHECK(std::abs(ledger.rest(world).momentum.x()) <= 16 * unit_roundoff<Real>);
  }
}
