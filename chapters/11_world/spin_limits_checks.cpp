// Up to which step what holds a spinning body can't feed on itself.
#include <Eigen/Eigenvalues>
#include <numbers>
#include <support/checks.hpp>
#include <support/random_world.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

/// Holds the third axis of a body along that of the world, by −K θ against its tilt and −C against
/// how fast that changes.
struct Pointing {
  static constexpr std::string_view name = "pointing";
  static constexpr Quantities reads = quantity::orientation | quantity::spin;
  Mat3d stiffness = Mat3d::Zero(), damping = Mat3d::Zero();  // 0 about the third axis
  Vec3d torque(const Top<double>& top, double) const {
    const Vec3d axis = rotate<double>(top.orientation, {0, 0, 1});
    const Vec3d spin = angular_velocity_world(top);
    return -stiffness * Vec3d(0, 0, 1).cross(axis) - damping * (spin - spin.dot(axis) * axis);
  }
  Response<double> response(const BodyState<double>&) const {
    return {.turning_stiffness = stiffness, .turning_damping = damping};
  }
};

RigidBody<double> top_of(double mass, double across, double along) {
  RigidBody<double> body;
  body.centre = make_particle<double>(mass);
  body.top.inverse_moments = {1 / across, 1 / across, 1 / along};
  return body;
}

World<double> quiet_world(Scheme scheme, double time_step) {
  World<double> world(step_of_nanoseconds(std::int64_t(1e9 * time_step)));
  world.step_by(scheme);
  world.on_warning([](const std::string&) {});
  return world;
}

/// A top that spins about its third axis and is held along it, a little off.
World<double> held_top(const RigidBody<double>& body, double spin, const Pointing& pointing,
                       Scheme scheme, double time_step) {
  World<double> world = quiet_world(scheme, time_step);
  const BodyHandle handle = world.add("top", body);
  world.add(pointing, {handle});
  world.set_angular_velocity(handle, {1e-9, 2e-9, spin});
  return world;
}

/// The energy (J) of the spins across the axes of symmetry, and of the motion of the centres.
double wobble(const World<double>& world) {
  double sum = 0;
  for (const Particle<double>& centre : world.bodies().centres) sum += kinetic_energy(centre);
  for (const Top<double>& top : world.bodies().tops)
    sum += top.inverse_moments.x() * top.angular_momentum_body.head<2>().squaredNorm() / 2;
  return sum;
}

/// How many times the first wobble it is at most. Beyond a million the rest is spared.
double wobble_growth(World<double> world, int steps) {
  const double first = wobble(world);
  double most = first;
  for (int n = 0; n < steps && most < 1e6 * first; ++n) {
    world.step();
    most = std::max(most, wobble(world));
  }
  return most / first;
}

/// N = θ/2 cot θ/2 of a nutation by θ in a step, see step_limit().
double cotangent_of(double angle) {
  return angle / 2 / std::tan(angle / 2);
}

/// What V = d·(N − h² K/4) d + m·h² K m allows the wobble to grow by, where the step is 0.99 of its
/// limit. The first V is the sum of (h v)² at most by Euler's, and 5 times that by Verlet's. Each
/// (N − h² K/4) is at least (1 − 0.99²) N, and a drift is as long as the speed before it says, but
/// for sin(θ/2)/(θ/2), which is 2/π at least. `angle`: the largest nutation in such a step.
double bounded(double angle) {
  return 5 * std::pow(std::numbers::pi / 2, 2) / (1 - 0.99 * 0.99) / cotangent_of(angle);
}

/// The h at which a function of it, which begins below 1, comes to 1.
template <class Function>
double where_one(double below, double above, const Function& of) {
  for (int n = 0; n < 60; ++n) {
    const double middle = (below + above) / 2;
    (of(middle) < 1 ? below : above) = middle;
  }
  return below;
}

constexpr std::array schemes = {Scheme::semi_implicit_euler, Scheme::verlet, Scheme::suzuki};

}  // namespace

TEST_CASE("A spinning top is stable up to its limit, and unstable a little above it") {
  for (std::uint64_t seed = 1; seed <= 120; ++seed) {
    CAPTURE(seed);
    RandomGenerator dice(seed);
    const double across = std::exp2(dice.real<double>()), along = std::exp2(dice.real<double>());
    const RigidBody<double> body = top_of(1, across, along);
    const double spin = std::exp2(4 * dice.real<double>()), k = std::exp2(4 * dice.real<double>());
    // K lies anywhere across the axis, with the eigenvalues k and less; dampers are alike.
    const double less = k * (0.3 + 0.2 * dice.real<double>());
    const double c = seed % 2 == 0 ? 0 : std::exp2(3 * dice.real<double>());
    const Vec3d first = Vec3d(dice.real<double>(), dice.real<double>(), 0).normalized();
    const Vec3d second = Vec3d(0, 0, 1).cross(first);
    const Pointing pointing{k * first * first.transpose() + less * second * second.transpose(),
                            Vec3d(c, c, 0).asDiagonal()};
    // Without dampers a tilt against k is thrown back as far as it came where h² k = 4 N I, and one
    // against `less` a little later: between the two it grows.
    const double rate = spin * along / across;
    const auto thrown_back = [&](double stiffness) {
      return where_one(0, std::numbers::pi / rate, [&](double h) {
        return h * h * stiffness / across / (4 * cotangent_of(h * rate));
      });
    };
    for (const Scheme scheme : schemes) {
      CAPTURE(name_of(scheme));
      const auto growth_at = [&](double step, int steps) {
        return wobble_growth(held_top(body, spin, pointing, scheme, step), steps);
      };
      const double limit = held_top(body, spin, pointing, scheme, 1e-3).step_limit().time_step;
      CHECK(held_top(body, spin, pointing, scheme, 0.99 * limit).warnings().empty());
      CHECK(growth_at(0.99 * limit, 1000) <= bounded(0.99 * limit * rate));
      if (c != 0 || scheme == Scheme::suzuki) continue;
      // Near half a turn N falls to 0 and each rounding of the angle counts 1/N times at most.
      const double truth = thrown_back(k);
      CHECK(std::abs(limit / truth - 1) <= 64 * unit_roundoff<double> / cotangent_of(truth * rate));
      CHECK(growth_at(thrown_back((k + less) / 2), 40'000) >= 1e6);
    }
  }
}

TEST_CASE(
    "A disc between two springs bears more spin without any damping than with a breath of it") {
  // Alike in all directions and without damping, it is unstable from h² k = 4 N with N = θ/4 cot
  // θ/4 on, which is the condition |2 cos(θ/2) − h² k sin(θ/2)/(θ/2)| < 2. Any damping makes it
  // θ/2.
  const double k = 3, I = 1, spin = 2;
  const auto from = [&](double part) {
    return where_one(0, std::numbers::pi / (2 * part * spin), [&](double h) {
      return h * h * k / I / (4 * cotangent_of(2 * part * h * spin));
    });
  };
  for (const Scheme scheme : {Scheme::semi_implicit_euler, Scheme::verlet})
    for (const double c : {0.0, 0.01}) {
      const Pointing pointing{Vec3d(k, k, 0).asDiagonal(), Vec3d(c, c, 0).asDiagonal()};
      const auto growth_at = [&](double step) {
        return wobble_growth(held_top(top_of(1, I, I), spin, pointing, scheme, step), 40'000);
      };
      // Of the 4 less 2 h c leaves at least 3.98.
      const double truth = from(c == 0 ? 0.25 : 0.5);
      CHECK(growth_at(0.98 * truth) < bounded(0.98 * from(0.5) * spin));
      CHECK(growth_at(1.02 * truth) >= 1e6);
    }
  CHECK(from(0.5) < 0.9 * from(0.25));
}

TEST_CASE("One spring across the axis of a spinning body, or of two, limits the step exactly") {
  // Of the inverse mass at the end of an arm a, 1/m + f a²/I, only what the turn adds yields more,
  // by f = 1/N. The two spin against each other, and differently fast.
  const auto easing = [](double angle) { return 1 / cotangent_of(angle); };
  const double one = where_one(0, std::numbers::pi / 16, [&](double h) {
    return h * h * 300 * (0.5 + 0.49 * easing(16 * h) / 0.5) / 4;
  });
  const double two = where_one(0, std::numbers::pi / 16, [&](double h) {
    return h * h * 50 * (0.5 + 0.49 * easing(16 * h) / 0.5 + 1 + 0.16 * easing(12 * h) / 0.1) / 4;
  });
  for (const bool joins_two : {false, true}) {
    const auto build = [&](double time_step) {
      World<double> world = quiet_world(Scheme::semi_implicit_euler, time_step);
      const BodyHandle a = world.add("a", top_of(2, 0.5, 0.8));
      if (joins_two) {
        RigidBody<double> other = top_of(1, 0.1, 0.02);
        other.centre.position = {3, 0, 1.1};
        const BodyHandle b = world.add("b", other);
        world.add(SpringBetween<double>{.spring = {.stiffness = 50, .rest_length = 3},
                                        .attachment_first = {0, 0, 0.7},
                                        .attachment_second = {0, 0, -0.4}},
                  {a, b});
        world.set_angular_velocity(b, {0, 0, -60});
      } else {
        world.add(SpringToPoint<double>{.spring = {.stiffness = 300, .rest_length = 3},
                                        .anchor = {3, 0, 0.7},
                                        .attachment = {0, 0, 0.7}},
                  {a});
      }
      world.set_angular_velocity(a, {1e-9, 2e-9, 10});
      return world;
    };
    const double truth = joins_two ? two : one, limit = build(1e-3).step_limit().time_step;
    // The wobble of 1e-9 may tell in the nutation.
    CHECK(std::abs(limit / truth - 1) <= 1e-9);
    const double angle = 16 * limit;
    CHECK(wobble_growth(build(0.99 * limit), 20'000) <= bounded(0.99 * angle));
    CHECK(wobble_growth(build(1.01 * limit), 20'000) >= 1e6);
  }
}

TEST_CASE("Of tops that spin about any axes, joined by springs there, none grows below the limit") {
  double fastest = 0;
  for (std::uint64_t seed = 1; seed <= 150; ++seed) {
    CAPTURE(seed);
    for (const Scheme scheme : {Scheme::semi_implicit_euler, Scheme::verlet}) {
      double nutation = 0;
      const auto build = [&](double time_step) {
        RandomGenerator dice(seed);
        World<double> world = quiet_world(scheme, time_step);
        std::vector<BodyHandle> tops;
        for (std::size_t n = 0, count = 2 + dice.below(4); n < count; ++n) {
          RigidBody<double> body =
              top_of(std::exp2(2 * dice.real<double>()), std::exp2(2 * dice.real<double>()),
                     std::exp2(2 * dice.real<double>()));
          body.centre.position = 4 * dice.vector<double>();
          body.top.orientation = quaternion_of_rotation_vector<double>(3 * dice.vector<double>());
          const BodyHandle top = world.add("top " + std::to_string(n), body);
          const Vec3d axis = rotate<double>(body.top.orientation, {0, 0, 1});
          const auto end_on = [&](BodyHandle held, const Vec3d& arm) -> Vec3d {
            return world.position(held) + rotate<double>(world.orientation(held), arm);
          };
          const auto join = [&](const Vec3d& arm, BodyHandle other, const Vec3d& other_arm) {
            const double length = (end_on(top, arm) - end_on(other, other_arm)).norm();
            world.add(
                SpringBetween<double>{.spring = {.stiffness = std::exp2(4 * dice.real<double>()),
                                                 .rest_length = length},
                                      .attachment_first = arm,
                                      .attachment_second = other_arm},
                {top, other});
          };
          for (const BodyHandle other : tops)
            if (dice.one_in(2) || other == tops.back())
              join({0, 0, dice.real<double>()}, other, {0, 0, dice.real<double>()});
          tops.push_back(top);
          world.set_velocity(top, 1e-9 * dice.vector<double>());
          world.set_angular_velocity(
              top, std::exp2(4 * dice.real<double>()) * axis + 1e-9 * dice.vector<double>());
          nutation = std::max(nutation, nutation_rate(world.body(top).top));
        }
        return world;
      };
      const double step = 0.99 * build(1e-3).step_limit().time_step;
      fastest = std::max(fastest, step * nutation);
      CHECK(wobble_growth(build(step), 1000) <= bounded(step * nutation));
    }
  }
  CHECK(fastest > 3);  // nearly half a turn
}

TEST_CASE_TEMPLATE("A spin that asks for a shorter step is named in the warning", Real,
                   EVERY_PRECISION) {
  // L = 3 across which the inverse moment is 4/3: a nutation of 4 rad/s. What is held at its centre
  // may spin as it likes.
  RigidBody<Real> body;
  body.centre = make_particle<Real>(1);
  body.top.inverse_moments = {Real(4) / 3, Real(4) / 3, 1};
  body.top.angular_momentum_body = {0, 0, 3};
  for (const Real arm : {Real(0), Real(1)}) {
    World<Real> world(step_of_nanoseconds(785'398'163));  // a quarter of π s
    world.on_warning([](const std::string&) {});
    world.add(SpringToPoint<Real>{.spring = {.stiffness = Real(0.01), .rest_length = 3},
                                  .anchor = {3, 0, arm},
                                  .attachment = {0, 0, arm}},
              {world.add("body", body)});
    const StepLimit<Real> limit = world.step_limit();
    CHECK(limit.nutation_rate == (arm == 0 ? 0 : 4));
    CHECK((limit.time_step < limit.at_rest) == (arm != 0));
    REQUIRE(world.warnings().size() == (arm == 0 ? 0 : 1));
    if (arm == 0) continue;
    const std::string warning = world.warnings()[0];
    CHECK(warning.find("'spring' on 'body' may gain energy") == 0);
    CHECK(warning.find(", since 'body' spins, and its nutation turns by 180 degrees in a step") !=
          std::string::npos);
  }
  // A step that would be too long at rest as well is no fault of the spin.
  World<Real> world(steps_per_second(1));
  world.on_warning([](const std::string&) {});
  world.add(SpringToPoint<Real>{.spring = {.stiffness = 100}, .attachment = {0, 0, 1}},
            {world.add("body", body)});
  CHECK(world.warnings().at(0).find("spins") == std::string::npos);
}

TEST_CASE_TEMPLATE("The weakest spring keeps every nutation just below half a turn in a step", Real,
                   EVERY_PRECISION) {
  RandomGenerator dice(9);
  for (int n = 0; n < 200; ++n) {
    RigidBody<Real> body;
    body.centre = make_particle<Real>(1);
    body.top.inverse_moments = Vec3<Real>::Constant(std::exp2(dice.real<Real>()));
    body.top.angular_momentum_body = {0, 0, std::exp2(3 * dice.real<Real>())};
    for (const Scheme scheme : schemes) {
      World<Real> world;
      world.step_by(scheme);
      world.on_warning([](const std::string&) {});
      world.add(SpringToPoint<Real>{.spring = {.stiffness = Real(1e-30), .rest_length = 3},
                                    .anchor = {3, 0, 1},
                                    .attachment = {0, 0, 1}},
                {world.add("body", body)});
      const StepLimit<Real> limit = world.step_limit();
      const Real half_turn = std::numbers::pi_v<Real>;
      CHECK(limit.time_step * limit.nutation_rate < half_turn);
      CHECK(limit.time_step * limit.nutation_rate > (1 - 16 * unit_roundoff<Real>)*half_turn);
    }
  }
}

TEST_CASE("A box that spins about its largest moment between two springs keeps its energy") {
  // There the energy is the least that its angular momentum allows, so the motion itself is stable,
  // though not the same in each step: the box shows the springs another side.
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    CAPTURE(seed);
    for (const Scheme scheme : schemes) {
      double nutation = 0;
      const auto build = [&](double time_step) {
        RandomGenerator dice(seed);
        World<double> world = quiet_world(scheme, time_step);
        const Vec3d sides = (Vec3d(1, 1, 1) + dice.vector<double>()) / 2;
        RigidBody<double> box =
            make_rigid_body<double>(
                "box", mass_properties(Box<double>{sides + Vec3d::Constant(0.05)}, 1), {})
                .body;
        int largest = 0;
        box.top.inverse_moments.minCoeff(&largest);
        const Vec3d axis_body = Vec3d::Unit(largest);
        const Vec3d axis = rotate<double>(box.top.orientation, axis_body);
        const BodyHandle handle = world.add("box", box);
        const double arm = 0.4 * std::abs(dice.real<double>()),
                     spin = std::exp2(5 + 3 * dice.real<double>());
        const Spring<double> spring{.stiffness = 100 * std::exp2(3 * dice.real<double>()),
                                    .rest_length = 4 * std::abs(dice.real<double>())};
        for (const double side : {-1.0, 1.0})
          world.add(SpringToPoint<double>{.spring = spring,
                                          .anchor = 8 * side * axis,
                                          .attachment = arm * side * axis_body},
                    {handle});
        world.set_angular_velocity(handle, spin * (axis + 1e-7 * dice.vector<double>()));
        nutation = nutation_rate(world.body(handle).top);
        return world;
      };
      const double step = 0.99 * build(1e-3).step_limit().time_step;
      World<double> world = build(step);
      const double first = kinetic_energy(world.body(world.handle_at(0)).top);
      for (int n = 0; n < 1000; ++n) world.step();
      // A tilt of 1e-7 has parts of 1e-14 in the energy, and may grow by what a step of 0.99 of the
      // limit allows.
      CHECK(std::abs(kinetic_energy(world.body(world.handle_at(0)).top) / first - 1) <
            1e-12 * bounded(step * nutation));
    }
  }
}

TEST_CASE("Springs that turn with a body make it whirl between two speeds, in any step") {
  // Held across its axis by 2 k (1 − l₀/l) in one direction and more in the other, its centre obeys
  // x'' + 2ω J x' + (K − ω²) x = 0 in the turning axes: stable but for ω² between the two.
  const auto growth = [](double spin, double time_step) {
    World<double> world = quiet_world(Scheme::verlet, time_step);
    const BodyHandle body = world.add("body", top_of(1, 50, 100));
    for (const double side : {-1.0, 1.0})
      for (const double end : {-2.0, 2.0})
        world.add(SpringToPoint<double>{.spring = {.stiffness = 20, .rest_length = 1},
                                        .anchor = {0, 0, end},
                                        .attachment = {0.9 * side, 0, 0}},
                  {body});
    world.set_angular_velocity(body, {0, 0, spin});
    world.set_velocity(body, {1e-7, 0, 0});
    CHECK(world.warnings().empty());
    double most = 0;
    while (world.time() < 30) {
      world.step();
      most = std::max(most, world.velocity(body).norm());
    }
    return most / 1e-7;
  };
  const double length = std::hypot(0.9, 2.0);
  const double soft = std::sqrt(4 * 20 * (1 - 1 / length)),
               hard = std::sqrt(4 * 20 * (1 - 1 / length + 0.81 / std::pow(length, 3)));
  for (const double time_step : {0.001, 0.00025}) {
    CHECK(growth(soft - 0.6, time_step) < 30);
    CHECK(growth((soft + hard) / 2, time_step) > 100);
    CHECK(growth(hard + 0.6, time_step) < 30);
  }
}

TEST_CASE("A damper in one direction of a spinning body lets a motion grow as the fourth power") {
  // A tilt that a stiffness of 1 resists, one that a damper C resists and a mass of 1 on a spring
  // of 1, which brings the second tilt to rest in the true motion: nothing grows there. Steps move
  // it by h²/24, and the damper reads the spin half a nutation later. I = L = 1.
  using Matrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;
  constexpr double C = 0.1;
  const auto growth_rate = [](double h) {
    // What becomes of two tilts, x and their speeds. The speeds of the tilts circle by 1 rad/s.
    Matrix kick = Matrix::Identity(6, 6), drift = kick;
    kick(3, 0) = kick(4, 1) = kick(5, 2) = -h;
    kick(4, 2) = kick(5, 1) = h;
    kick(4, 4) -= h * C;
    drift(2, 5) = h;
    drift(0, 3) = drift(1, 4) = std::sin(h);
    drift(1, 3) = 1 - std::cos(h);
    drift(0, 4) = -drift(1, 3);
    drift(3, 3) = drift(4, 4) = std::cos(h);
    drift(4, 3) = std::sin(h);
    drift(3, 4) = -drift(4, 3);
    const Eigen::EigenSolver<Matrix> solver(drift * kick);
    return std::log(double(solver.eigenvalues().cwiseAbs().maxCoeff())) / h;
  };
  for (const double h : {0.2, 0.1, 0.05}) {
    CAPTURE(h);
    // The first term of a series in h² and in C².
    CHECK(std::abs(growth_rate(h) / (5 * C * std::pow(h, 4) / 2304) - 1) < h * h + C * C);
  }
}
