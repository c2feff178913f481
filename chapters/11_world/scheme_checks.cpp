// Schemes of higher order for a whole world.
#include <numbers>
#include <support/checks.hpp>
#include <tumble/air_and_water.hpp>
#include <tumble/gravity.hpp>
#include <tumble/solids.hpp>
#include <tumble/springs.hpp>
#include <tumble/world.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

constexpr std::array every_scheme = {Scheme::semi_implicit_euler, Scheme::verlet, Scheme::suzuki};

/// A force that swings, N, for a mass of 1 kg.
template <class Real>
struct Swing {
  static constexpr std::string_view name = "swing";
  static constexpr Quantities reads = quantity::time;
  Vec3<Real> force(const Particle<Real>&, Real time) const { return {std::cos(3 * time), 0, 0}; }
};

/// A thing of 1 kg with what acts on it, and where it is after a second.
template <class Real>
struct Scenario {
  const char* name;
  Particle<Real> start;
  void (*add_effects)(World<Real>& world);
  Vec3<Real> end;
  int most = 4;  ///< the order that the effects allow
};

template <class Real>
std::vector<Scenario<Real>> scenarios() {
  constexpr double pi = std::numbers::pi;
  // ẍ = −4 x − ẋ, from 1 m at rest: e^(−t/2) (cos wt + sin wt / 2w) with w = √(4 − 1/4).
  const double w = std::sqrt(3.75);
  const auto faded = static_cast<Real>(std::exp(-0.5) * (std::cos(w) + std::sin(w) / (2 * w)));
  return {
      {"swinging force",
       make_particle<Real>(1, {0, 0, 0}, {1, 0, 0}),
       [](World<Real>& world) { world.add(Swing<Real>{}); },
       {static_cast<Real>(1 + (1 - std::cos(3.0)) / 9), 0, 0}},
      {"spring",
       make_particle<Real>(1, {1, 0, 0}),
       [](World<Real>& world) {
         world.add(SpringToPoint<Real>{.spring = {.stiffness = 4}, .anchor = {0, 0, 0}},
                   {world.handle_at(0)});
       },
       {static_cast<Real>(std::cos(2.0)), 0, 0}},
      // Half round a star: a = 1 m and GM = π², so a round takes 2 s; from 0.9 m to 1.1 m.
      {"orbit",
       make_particle<Real>(1, {Real(0.9), 0, 0},
                           {0, static_cast<Real>(pi * std::sqrt(2 / 0.9 - 1)), 0}),
       [](World<Real>& world) {
         world.add(PointGravity<Real>{.strength = static_cast<Real>(pi * pi), .centre = {0, 0, 0}});
       },
       {Real(-1.1), 0, 0}},
      {"spring with a damper",
       make_particle<Real>(1, {1, 0, 0}),
       [](World<Real>& world) {
         world.add(
             SpringToPoint<Real>{.spring = {.stiffness = 4, .damping = 1}, .anchor = {0, 0, 0}},
             {world.handle_at(0)});
       },
       {faded, 0, 0},
       1},
      {"spring in air",
       make_particle<Real>(1, {1, 0, 0}),
       [](World<Real>& world) {
         world.add(SpringToPoint<Real>{.spring = {.stiffness = 4}, .anchor = {0, 0, 0}},
                   {world.handle_at(0)});
         world.add(LinearDamping<Real>{.rate = 1});
       },
       {faded, 0, 0},
       1}};
}

/// How far from where it should be a second after its start.
template <class Real>
double error_of(const Scenario<Real>& scenario, Scheme scheme, int steps) {
  World<Real> world(steps_per_second(steps));
  world.step_by(scheme);
  world.add("thing", scenario.start);
  scenario.add_effects(world);
  CHECK(world.plan().accuracy.order == std::min(order_of(scheme), scenario.most));
  for (int n = 0; n < steps; ++n) world.step();
  return static_cast<double>((world.bodies().centres[0].position - scenario.end).norm());
}

}  // namespace

TEST_CASE("A world's error falls with the power of its step that the plan promises") {
  for (const Scenario<double>& scenario : scenarios<double>())
    for (const Scheme scheme : every_scheme) {
      CAPTURE(scenario.name);
      CAPTURE(name_of(scheme));
      const double order =
          std::log2(error_of(scenario, scheme, 128) / error_of(scenario, scheme, 256));
      CAPTURE(order);
      CHECK(std::lround(order) == std::min(order_of(scheme), scenario.most));
    }
}

TEST_CASE(
    "A kink leaves Suzuki's scheme the order that the plan says: 2 where a tether becomes taut, 3 "
    "at the water's surface") {
  const auto world_from = [](double height, const auto& effect, int steps) {
    World<double> world(steps_per_second(steps));
    world.step_by(Scheme::suzuki);
    world.add("thing", make_particle<double>(1, {0, 0, height}, {0, 0, 1}));
    world.add(effect);
    return world;
  };
  const auto end_of = [&](double height, const auto& effect, int steps) {
    World<double> world = world_from(height, effect, steps);
    for (int n = 0; n < steps; ++n) world.step();
    return world.bodies().centres[0].position.z();
  };
  // From 64 heights, so that the kink lies anywhere in its step; the mean of the squares counts.
  const auto order_of = [&](const auto& effect, const auto& truth) {
    double squares = 0, of_half = 0;
    for (int n = 0; n < 64; ++n) {
      const double height = 0.4 + 0.001618 * n, end = truth(height);
      squares += std::pow(end_of(height, effect, 64) - end, 2);
      of_half += std::pow(end_of(height, effect, 128) - end, 2);
    }
    return std::lround(std::log2(squares / of_half) / 2);
  };
  // 1 m/s up to 1 m, and from there on a swing of w = 3 rad/s.
  const SpringToPoint<double> tether{
      .spring = {.stiffness = 9, .rest_length = 1, .only_pulls = true}, .name = "tether"};
  const auto swing = [](double height) { return 1 + std::sin(3 * height) / 3; };
  CHECK(order_of(tether, swing) == 2);
  CHECK(text_of(world_from(0.4, tether, 64).plan().accuracy) ==
        "order 2 in place of 4 (Suzuki): 'tether' has a kink");
  // A ball of 0.3 m that is thrown out of the water, and then flies.
  const Buoyancy<double> water{.density = 50, .radius = 0.3, .surface = 1};
  const auto finely = [&](double height) { return end_of(height, water, 8192); };
  CHECK(order_of(water, finely) == 3);
  CHECK(world_from(0.4, water, 64).plan().accuracy.order == 3);
}

/// A box and a ball on a spring that holds the box at a corner, and both round a star.
template <class Real>
World<Real> world_that_can_go_back(Scheme scheme) {
  World<Real> world(steps_per_second(50));
  world.step_by(scheme);
  const BodyHandle box =
      world.add("box", make_rigid_body<Real>("box", mass_properties(Box<Real>{{1, 2, 3}}, 1), {},
                                             {0, 1, 0}, {1, 2, Real(0.5)})
                           .body);
  const BodyHandle ball = world.add("ball", make_particle<Real>(2, {4, 0, 0}));
  world.add(PointGravity<Real>{.strength = 20, .centre = {0, 0, 9}});
  world.add(SpringBetween<Real>{.spring = {.stiffness = 5, .rest_length = 2},
                                .attachment_first = {Real(0.5), 1, Real(1.5)}},
            {box, ball});
  return world;
}

TEST_CASE_TEMPLATE(
    "By Verlet and by Suzuki a world whose motion is turned round goes back to its start", Real,
    EVERY_PRECISION) {
  for (const Scheme scheme : every_scheme) {
    CAPTURE(name_of(scheme));
    World<Real> world = world_that_can_go_back<Real>(scheme);
    const Snapshot<Real> start = world.save();
    const int steps = 100;
    for (int n = 0; n < steps; ++n) world.step();
    Snapshot<Real> turned = world.save();
    for (CentreMotion<Real>& centre : turned.centres) centre.velocity = -centre.velocity;
    for (TopMotion<Real>& top : turned.tops) top.angular_momentum_body = -top.angular_momentum_body;
    world.restore(turned);
    for (int n = 0; n < steps; ++n) world.step();
    Real missed = 0;
    const Bodies<Real> back = world.bodies();
    for (std::size_t i = 0; i < 2; ++i)
      missed = std::max(missed, (back.centres[i].position - start.centres[i].position).norm());
    missed = std::max(missed, angle_between(back.tops[0].orientation, start.tops[0].orientation));
    // Each of the 200 steps rounds numbers up to 10 some hundred times, and what it misses grows
    // with the time that is left: by not more than 200 in these four seconds.
    const Real roundings = 200 * 100 * 10 * unit_roundoff<Real> * 200;
    if (scheme == Scheme::semi_implicit_euler)
      CHECK(missed > Real(0.01));
    else
      CHECK(missed <= roundings);
  }
}

TEST_CASE("Below a scheme's limit a spring's swing stays bounded, and a twentieth above it grows") {
  for (const Scheme scheme : every_scheme)
    for (const double damping : {0.0, 0.1, 0.5, 2.0, 6.0, 20.0}) {
      CAPTURE(name_of(scheme));
      CAPTURE(damping);
      // The stiffness s² and the damping s c have a limit in proportion to 1/s.
      const auto world_with = [&](double s) {
        World<double> world(steps_per_second(100));
        world.step_by(scheme);
        world.on_warning([](const std::string&) {});
        world.add("ball", make_particle<double>(1, {1, 0, 0}));
        world.add(SpringToPoint<double>{.spring = {.stiffness = s * s, .damping = s * damping},
                                        .anchor = {0, 0, 0}},
                  {world.handle_at(0)});
        return world;
      };
      const double limit = world_with(1).step_limit().time_step;
      const auto largest_after = [&](double times_the_limit) {
        World<double> world = world_with(times_the_limit * limit * 100);
        CHECK(world.warnings().empty() == (times_the_limit < 1));
        double largest = 0;
        for (int n = 0; n < 2000 && largest < 1e6; ++n) {
          world.step();
          largest = std::max(largest, world.bodies().centres[0].position.norm());
        }
        return largest;
      };
      CHECK(largest_after(0.99) < 100);
      // With dampers Suzuki's limit is Euler's, which is too careful for it: by less than three.
      const bool is_careful = scheme == Scheme::suzuki && damping > 0;
      CHECK(largest_after(is_careful ? 3 : 1.05) >= 1e6);
    }
}

TEST_CASE("Whoever chooses a scheme that a spring is too stiff for is warned at the next step") {
  World<double> world(steps_per_second(10));
  std::vector<std::string> told;
  world.on_warning([&](const std::string& warning) { told.push_back(warning); });
  world.step_by(Scheme::suzuki);
  world.add("ball", make_particle<double>(1, {1, 0, 0}));
  // w h = 2.3, above 2 and below 2.7
  world.add(SpringToPoint<double>{.spring = {.stiffness = 23.0 * 23}, .anchor = {0, 0, 0}},
            {world.handle_at(0)});
  world.step();
  CHECK(told.empty());
  world.step_by(Scheme::verlet);
  world.step();
  world.step();
  REQUIRE(told.size() == 1);
  CHECK(told[0].find("the time step is 0.1 s, and only up to 0.08695652173913") !=
        std::string::npos);
}

/// A force that is no number from a certain time on.
struct Late {
  static constexpr std::string_view name = "late";
  static constexpr Quantities reads = quantity::time;
  double from;  ///< s
  Vec3d force(const Particle<double>&, double time) const {
    return {time < from ? 0 : std::numeric_limits<double>::quiet_NaN(), 0, 0};
  }
};

TEST_CASE("An effect that fails in the middle of a step is named, and the step is taken back") {
  // Suzuki's kicks come at 0.021, 0.062, 0.05, 0.038 and 0.079 s; Verlet's at 0.05 s.
  struct Case {
    Scheme scheme;
    double from;
    bool fails;
  };
  for (const Case& tried : {Case{Scheme::semi_implicit_euler, 0.001, false},
                            Case{Scheme::verlet, 0.049, true}, Case{Scheme::verlet, 0.051, false},
                            Case{Scheme::suzuki, 0.079, true}, Case{Scheme::suzuki, 0.08, false}}) {
    CAPTURE(name_of(tried.scheme));
    CAPTURE(tried.from);
    World<double> world(steps_per_second(10));
    world.step_by(tried.scheme);
    world.add("thing", make_particle<double>(1, {0, 0, 0}, {1, 0, 0}));
    world.add(Late{tried.from});
    const Bodies<double> before = world.bodies();
    std::string complaint;
    try {
      world.step();
    } catch (const SimulationError& error) {
      complaint = error.what();
      CHECK(error.effect == "late");
    }
    CHECK(complaint.find("late gives a force of (nan, 0, 0) N") ==
          (tried.fails ? complaint.find("late") : std::string::npos));
    CHECK(complaint.empty() != tried.fails);
    CHECK((world.bodies().centres[0].position == before.centres[0].position) == tried.fails);
  }
}

/// A speed of t² m/s after t seconds, set with the kicks or at the end of each step.
template <Phase when>
struct Motor {
  static constexpr std::string_view name = "motor";
  static constexpr Quantities reads = quantity::time;
  static constexpr Phase phase = when;
  Vec3d velocity(const Particle<double>&, const StepTime<double>& at) const {
    return {at.time * at.time, 0, 0};
  }
};
/// A place of t² m after t seconds, set with the kicks.
struct Rail {
  static constexpr std::string_view name = "rail";
  static constexpr Quantities reads = quantity::time;
  Vec3d position(const Particle<double>&, const StepTime<double>& at) const {
    return {at.time * at.time, 0, 0};
  }
};

TEST_CASE(
    "What sets a velocity or a place itself leaves a step of first order, and the plan says so") {
  const auto order_of_motion = [](const auto& effect, Scheme scheme) {
    std::array<double, 2> errors{};
    for (std::size_t i = 0; i < 2; ++i) {
      const int steps = i == 0 ? 256 : 512;
      World<double> world(steps_per_second(steps));
      world.step_by(scheme);
      world.add("thing", make_particle<double>(1));
      world.add(effect);
      CHECK(world.plan().accuracy.order == 1);
      const bool is_limited = scheme != Scheme::semi_implicit_euler;
      CHECK(world.plan().accuracy.limits.size() == (is_limited ? 1 : 0));
      for (int n = 0; n < steps; ++n) world.step();
      const Particle<double>& thing = world.bodies().centres[0];
      if constexpr (requires { effect.velocity(thing, StepTime<double>{}); })
        errors[i] = std::abs(thing.position.x() - 1 / 3.0) + std::abs(thing.velocity.x() - 1);
      else
        errors[i] = std::abs(thing.position.x() - 1);
    }
    return std::lround(std::log2(errors[0] / errors[1]));
  };
  for (const Scheme scheme : every_scheme) {
    CAPTURE(name_of(scheme));
    CHECK(order_of_motion(Motor<Phase::kick>{}, scheme) == 1);
    CHECK(order_of_motion(Motor<Phase::force>{}, scheme) == 1);
    CHECK(order_of_motion(Motor<Phase::drift>{}, scheme) == 1);
    CHECK(order_of_motion(Rail{}, scheme) == 1);
  }
}

TEST_CASE(
    "A ball that leaves the water costs Verlet no order: the force and its slope do not jump") {
  const auto state_after = [](Scheme scheme, int steps) {
    World<double> world(steps_per_second(steps));
    world.step_by(scheme);
    world.add("ball", make_particle<double>(300, {0, 0, -0.8}));
    world.add(Gravity<double>{});
    world.add(Buoyancy<double>{.radius = 0.5});
    bool has_been_out = false;
    for (int n = 0; n < steps; ++n) {
      world.step();
      has_been_out |= world.bodies().centres[0].position.z() > 0.5;
    }
    CHECK(has_been_out);
    return world.bodies().centres[0].position.z();
  };
  const double end = state_after(Scheme::suzuki, 20'000);
  // The mean of three times half the step: in which step the ball comes out varies.
  const double coarse = std::abs(state_after(Scheme::verlet, 100) - end);
  const double fine = std::abs(state_after(Scheme::verlet, 800) - end);
  CAPTURE(coarse);
  CAPTURE(fine);
  CHECK(std::lround(std::log2(coarse / fine) / 3) == 2);
}

/// A rule that says it is of second order, and not that it is symmetric.
struct Lopsided {
  static constexpr std::string_view name = "lopsided";
  static constexpr int order = 2;
  void operator()(Top<double>& top, double h) const { turn_by_splitting(top, h); }
};

/// A rule of the user's own.
struct Unsaid {
  static constexpr std::string_view name = "my own";
  void operator()(Top<double>& top, double h) const { turn_by_splitting(top, h); }
};

TEST_CASE("A plan says of which order the step is, and what stands in the way of a higher one") {
  World<double> world = world_that_can_go_back<double>(Scheme::semi_implicit_euler);
  const auto last_line = [&] {
    const std::string table = table_of(world.plan());
    return table.substr(table.rfind('\n', table.size() - 2) + 1);
  };
  CHECK(last_line() == "order 1: semi-implicit Euler\n");
  world.step_by(Scheme::suzuki);
  CHECK(last_line() == "order 4: Suzuki\n");
  world.turn_by(CarryingMomentum{});
  CHECK(last_line() ==
        "order 1 in place of 4 (Suzuki): turning by carrying momentum is of order 1\n");
  world.turn_by(Lopsided{});
  CHECK(last_line() == "order 2 in place of 4 (Suzuki): turning by lopsided is of order 2\n");
  world.turn_by(Unsaid{});
  CHECK(last_line() ==
        "order 0 in place of 4 (Suzuki): turning by my own does not say its order\n");
  world.step_by(Scheme::semi_implicit_euler);
  world.turn_by(Steady{});
  CHECK(last_line() ==
        "order 0 in place of 1 (semi-implicit Euler): turning by steady is of order 0\n");
  world.turn_by(AxisByAxis{});
  world.step_by(Scheme::verlet);
  const EffectHandle air = world.add(LinearDamping<double>{.rate = 1});
  world.add(QuadraticDrag<double>{.coefficient = 1});
  CHECK(last_line() ==
        "order 1 in place of 2 (Verlet): 'linear damping' acts apart from the kicks; 'quadratic "
        "drag' depends on a velocity or a spin\n");
  world.remove(air);
  // An effect that visits nobody limits nothing, nor does a rule by which nobody turns.
  World<double> points;
  points.step_by(Scheme::verlet);
  points.turn_by(CarryingMomentum{});
  points.add("point", make_particle<double>(1));
  points.add(AngularDamping<double>{.rate = 1});
  CHECK(points.plan().accuracy.order == 2);
}
