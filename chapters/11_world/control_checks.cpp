// A controller that answers the turn and the spin of a body limits the step, as a spring does.
#include <Eigen/Eigenvalues>
#include <support/checks.hpp>
#include <support/random_world.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

using Matrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;

/// The small turn from one orientation to another, rad, world axes.
template <class Real>
Vec3<Real> small_turn(const Quaternion<Real>& from, const Quaternion<Real>& to) {
  return 2 * (to * conjugate(from)).imaginary;
}

/// Holds an attitude by the torque −K θ − C ω, world axes.
template <class Real>
struct Steering {
  static constexpr std::string_view name = "attitude control";
  static constexpr Quantities reads = quantity::orientation | quantity::spin;
  Mat3<Real> stiffness, damping;
  Quaternion<Real> target;
  Vec3<Real> torque(const Top<Real>& top, Real) const {
    return -stiffness * small_turn(target, top.orientation) - damping * angular_velocity_world(top);
  }
  Response<Real> response(const BodyState<Real>&) const {
    return {.turning_stiffness = stiffness, .turning_damping = damping};
  }
};

/// Holds the attitude of one body relative to another.
template <class Real>
struct SteeringBetween {
  static constexpr std::string_view name = "attitude control between";
  Mat3<Real> stiffness, damping;
  Quaternion<Real> first_target, second_target;
  PairPush<Real> push(const BodyState<Real>& a, const BodyState<Real>& b, Real) const {
    const Vec3<Real> turn =
        small_turn(first_target, a.top.orientation) - small_turn(second_target, b.top.orientation);
    const Vec3<Real> spin = angular_velocity_world(a.top) - angular_velocity_world(b.top);
    const Vec3<Real> torque = -stiffness * turn - damping * spin;
    return {.torque_on_first = torque, .torque_on_second = -torque};
  }
  Response<Real> response(const BodyState<Real>&, const BodyState<Real>&) const {
    return {.turning_stiffness = stiffness, .turning_damping = damping};
  }
};

RigidBody<double> random_body(RandomGenerator& dice) {
  const Vec3d sides = (Vec3d(1, 1, 1) + dice.vector<double>()) / 2 + Vec3d::Constant(0.05);
  return make_rigid_body<double>(
             "box", mass_properties(Box<double>{sides}, std::exp2(3 * dice.real<double>())),
             {Vec3d::Zero(), quaternion_of_rotation_vector<double>(3 * dice.vector<double>())})
      .body;
}

/// A controller's matrix: of one axis, of all alike, or of three that lie anywhere.
Mat3d random_gain(RandomGenerator& dice) {
  const double strength = std::exp2(6 * dice.real<double>());
  const Vec3d axis = dice.vector<double>().normalized();
  if (dice.one_in(3)) return strength * axis * axis.transpose();
  if (dice.one_in(2)) return strength * Mat3d::Identity();
  Mat3d gain = Mat3d::Zero();
  for (int n = 0; n < 3; ++n) {
    const Vec3d v = dice.vector<double>();
    gain += strength * v * v.transpose();
  }
  return gain;
}

/// One controller: on one body, or between two.
struct Loop {
  explicit Loop(std::uint64_t seed) {
    RandomGenerator dice(seed);
    for (std::uint64_t n = 0; n < 1 + seed % 2; ++n) bodies.push_back(random_body(dice));
    stiffness = dice.one_in(4) ? Mat3d::Zero() : random_gain(dice);
    damping = stiffness.isZero() || !dice.one_in(3) ? random_gain(dice) : Mat3d::Zero();
  }

  World<double> world(double time_step) const {
    World<double> world(step_of_nanoseconds(std::int64_t(1e9 * time_step)));
    world.on_warning([](const std::string&) {});
    std::vector<BodyHandle> handles;
    for (const RigidBody<double>& body : bodies)
      handles.push_back(world.add("body " + std::to_string(handles.size()), body));
    const Quaternion<double> first = bodies[0].top.orientation;
    if (bodies.size() == 1)
      world.add(Steering<double>{stiffness, damping, first}, handles);
    else
      world.add(SteeringBetween<double>{stiffness, damping, first, bodies[1].top.orientation},
                handles);
    return world;
  }

  /// How hard the loop pulls back in a step: the largest eigenvalue of h² K + 2 h C in units of
  /// the inertia, for all bodies at once. At 4 one of the motions begins to grow.
  long double pull(double time_step) const {
    const long double h = time_step;
    const Mat3<long double> K =
        (h * h * stiffness.cast<long double>() + 2 * h * damping.cast<long double>());
    const auto count = static_cast<Eigen::Index>(bodies.size());
    Matrix all(3 * count, 3 * count);
    const auto root_of_inverse = [&](Eigen::Index n) -> Mat3<long double> {
      const Top<double>& top = bodies[std::size_t(n)].top;
      const Mat3<long double> R = matrix_of(top.orientation).cast<long double>();
      return R * top.inverse_moments.cast<long double>().cwiseSqrt().asDiagonal() * R.transpose();
    };
    for (Eigen::Index a = 0; a < count; ++a)
      for (Eigen::Index b = 0; b < count; ++b)
        all.block<3, 3>(3 * a, 3 * b) =
            (a == b ? 1 : -1) * root_of_inverse(a) * K * root_of_inverse(b);
    return Eigen::SelfAdjointEigenSolver<Matrix>(all).eigenvalues()[3 * count - 1];
  }

  double true_limit() const {
    double below = 0, above = 1;
    while (pull(above) < 4) above *= 2;
    for (int n = 0; n < 60; ++n) {
      const double middle = (below + above) / 2;
      (pull(middle) < 4 ? below : above) = middle;
    }
    return below;
  }

  std::vector<RigidBody<double>> bodies;
  Mat3d stiffness, damping;
};

double turning_energy_of(const World<double>& world) {
  double sum = 0;
  for (const Top<double>& top : world.bodies().tops) sum += kinetic_energy(top);
  return sum;
}

/// How many times the first kinetic energy it is at most, after a small random spin.
double growth(World<double> world, int steps) {
  RandomGenerator dice(77);
  for (BodyIndex n = 0; n < world.body_count(); ++n)
    world.set_angular_velocity(world.handle_at(n), 1e-9 * dice.vector<double>());
  const double first = turning_energy_of(world);
  double most = first;
  for (int n = 0; n < steps && most < 1e6 * first; ++n) {
    world.step();
    most = std::max(most, turning_energy_of(world));
  }
  return most / first;
}

}  // namespace

TEST_CASE(
    "A loop that holds an attitude is stable below its limit, and grows at a few times that") {
  int sharp = 0;
  for (std::uint64_t seed = 1; seed <= 120; ++seed) {
    CAPTURE(seed);
    const Loop loop(seed);
    const double limit = loop.world(1e-3).step_limit().time_step, truth = loop.true_limit();
    // Some hundred roundings at most.
    CHECK(limit <= truth * (1 + 128 * unit_roundoff<double>));
    // The largest eigenvalues of h² K and of 2 h C are added, and at least one of the two is half
    // of the sum; so the pull at the limit is half of the bound at least, and that of two bodies
    // once more by half. Twice the step doubles it at least.
    CHECK(truth <= limit * 2 * double(loop.bodies.size()));
    sharp += truth < 1.001 * limit;
    for (const Scheme scheme : {Scheme::semi_implicit_euler, Scheme::verlet, Scheme::suzuki}) {
      World<double> below = loop.world(0.99 * limit);
      below.step_by(scheme);
      CHECK(below.warnings().empty());
      // V = dᵀ S d + mᵀ h² K m never grows, see step_limit(). With the pull at 0.99 of 4 no
      // eigenvalue of S is less than 0.01, and the first V is d² at most, or 5 d² by Verlet's.
      CHECK(growth(below, 400) <= 5 / 0.01);
      if (scheme == Scheme::suzuki) continue;  // whose limit is another one
      World<double> above = loop.world(1.05 * truth);
      above.step_by(scheme);
      CHECK(above.warnings().size() == 1);
      CHECK(growth(above, 2000) >= 1e6);
    }
  }
  CHECK(sharp > 20);  // one axis, or all alike without damping
}

TEST_CASE("Controllers, springs and tension on the same bodies are stable below their limit") {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    CAPTURE(seed);
    const auto build = [seed](World<double>& world) {
      RandomGenerator dice(seed);
      std::vector<BodyHandle> boxes;
      world.on_warning([](const std::string&) {});
      for (int n = 0; n < 3; ++n) {
        RigidBody<double> box = random_body(dice);
        box.centre.position = {4.0 * n, 0, 0};
        boxes.push_back(world.add("box " + std::to_string(n), box));
      }
      const auto facing = [&](std::size_t n) { return world.orientation(boxes[n]); };
      const auto gain = [&] { return dice.one_in(3) ? Mat3d::Zero() : random_gain(dice); };
      for (std::size_t n = 0; n < 3; ++n)
        world.add(Steering<double>{gain(), gain(), facing(n)}, {boxes[n]});
      for (std::size_t n = 1; n < 3; ++n)
        world.add(SteeringBetween<double>{gain(), gain(), facing(n - 1), facing(n)},
                  {boxes[n - 1], boxes[n]});
      // The middle box is pulled apart by two springs through its centre, along their line.
      const double tension = std::exp2(6 * dice.real<double>());
      for (const double side : {-1.0, 1.0}) {
        const Vec3d held = {side * 0.5, 0, 0};
        world.add(SpringToPoint<double>{.spring = {.stiffness = tension, .damping = tension / 8},
                                        .anchor = Vec3d(4, 0, 0) + held + Vec3d(side, 0, 0),
                                        .attachment = rotate_back<double>(facing(1), held)},
                  {boxes[1]});
      }
    };
    World<double> asked;
    build(asked);
    const double limit = asked.step_limit().time_step;
    for (const Scheme scheme : {Scheme::semi_implicit_euler, Scheme::verlet, Scheme::suzuki}) {
      World<double> world(step_of_nanoseconds(std::int64_t(0.99e9 * limit)));
      build(world);
      world.step_by(scheme);
      CHECK(world.warnings().empty());
      CHECK(growth(world, 400) <= 5 / 0.01);
    }
  }
}

TEST_CASE_TEMPLATE("The step that a controller bears depends on the least moment that it turns",
                   Real, EVERY_PRECISION) {
  // Moments of 1, 2 and 4 kg m², and a body that faces anywhere: about any axis of the body alike,
  // 2 √(I/k) for the least moment; about its third axis alone, for that of 4 kg m².
  RigidBody<Real> body;
  body.centre = make_particle<Real>(1);
  body.top.inverse_moments = {1, Real(0.5), Real(0.25)};
  body.top.orientation = quaternion_of_rotation_vector<Real>({Real(0.3), Real(-0.9), Real(0.5)});
  const auto limit = [&](const Mat3<Real>& stiffness, const Mat3<Real>& damping) {
    World<Real> world;
    world.on_warning([](const std::string&) {});
    const BodyHandle one = world.add("one", body);
    world.add(Steering<Real>{stiffness, damping, body.top.orientation}, {one});
    return world.step_limit().time_step;
  };
  const Mat3<Real> none = Mat3<Real>::Zero(), all = 9 * Mat3<Real>::Identity();
  const Vec3<Real> third = rotate<Real>(body.top.orientation, {0, 0, 1});
  const auto close = [](Real found, Real expected) {
    return std::abs(found - expected) <= 64 * unit_roundoff<Real> * expected;
  };
  CHECK(close(limit(all, none), Real(2) / 3));
  CHECK(close(limit(9 * third * third.transpose(), none), Real(4) / 3));
  CHECK(close(limit(none, all), Real(2) / 9));  // h c/I < 2
  CHECK(close(limit(none, 9 * third * third.transpose()), Real(8) / 9));
  CHECK(close(limit(all, all), 2 / (Real(4.5) + std::sqrt(Real(4.5) * Real(4.5) + 9))));
  // Two like bodies that turn against each other: each meets twice the stiffness.
  World<Real> world;
  const BodyHandle one = world.add("one", body), other = world.add("other", body);
  world.add(SteeringBetween<Real>{all, none, body.top.orientation, body.top.orientation},
            {one, other});
  CHECK(close(world.step_limit().time_step, 2 / std::sqrt(Real(18))));
  body.top.inverse_moments = {0, 0, 0};
  CHECK(limit(all, all) == std::numeric_limits<Real>::infinity());
}

TEST_CASE_TEMPLATE("A loop that is too stiff for the step is announced by its name and its body",
                   Real, EVERY_PRECISION) {
  World<Real> world(steps_per_second(10));
  std::vector<std::string> told;
  world.on_warning([&](const std::string& warning) { told.push_back(warning); });
  RigidBody<Real> body;
  body.centre = make_particle<Real>(1);
  body.top.inverse_moments = {1, 1, 1};
  const BodyHandle calm = world.add("calm", body), nervous = world.add("nervous", body);
  const auto hold = [&](BodyHandle handle, Real stiffness, Real damping) {
    world.add(Steering<Real>{stiffness * Mat3<Real>::Identity(), damping * Mat3<Real>::Identity(),
                             Quaternion<Real>{}},
              {handle});
  };
  hold(calm, 1, 1);
  world.add(SpringToPoint<Real>{.spring = {.stiffness = 1}}, {calm});
  world.step();
  CHECK(told.empty());
  hold(nervous, 0, 21);
  world.step();
  REQUIRE(told.size() == 1);
  CHECK(told[0].find("'attitude control' on 'nervous' may gain energy without bound") == 0);
}

TEST_CASE_TEMPLATE("Point gravity resists a step aside, as hard as its difference quotient says",
                   Real, EVERY_PRECISION) {
  const PointGravity<long double> pull{.strength = 7, .centre = {1, 2, 3}};
  const Vec3<long double> place(2, 4, 5);  // 3 m away
  Particle<long double> body = make_particle<long double>(2, place);
  const Vec3<long double> aside = Vec3<long double>(2, -1, 0).normalized() * 1e-6L;
  body.position = place + aside;
  const Vec3<long double> after = pull.force(body, 0);
  body.position = place - aside;
  const Vec3<long double> slope = (after - pull.force(body, 0)) / (2 * aside.norm());
  const PointGravity<Real> asked{.strength = 7, .centre = {1, 2, 3}};
  const BodyState<Real> state{make_particle<Real>(2, {2, 4, 5}), {}};
  const Real stiffness = asked.response(state).stiffness;
  // The quotient leaves the square of 1e-6/3.
  CHECK(std::abs(Real(-slope.dot(aside.normalized())) - stiffness) <=
        (8 * unit_roundoff<Real> + Real(1e-12)) * stiffness);
  // Whoever stands at the point itself, or can't move, is held by nothing.
  World<Real> world;
  const BodyHandle planet = world.add("planet", make_static_particle<Real>({1, 2, 3}));
  world.add(asked);
  CHECK(world.step_limit().time_step == std::numeric_limits<Real>::infinity());
  world.set_position(planet, {0, 0, 0});
  CHECK(world.step_limit().time_step == std::numeric_limits<Real>::infinity());
}

namespace {

/// Reads where a body is, and does not say how it answers.
struct Silent {
  std::string name = "silent";
  static constexpr Quantities reads = quantity::time | quantity::position;
  Vec3d force(const Particle<double>&, double) const { return {0, 0, 0}; }
};
struct Blind {
  static constexpr std::string_view name = "blind";
  static constexpr Quantities reads = quantity::time | quantity::mass;
  Vec3d force(const Particle<double>&, double) const { return {0, 0, 0}; }
};
struct Harmless : Silent {
  NoResponse response(const BodyState<double>&) const { return {}; }
};
/// Says how it answers, but not whom.
struct Finder {
  static constexpr std::string_view name = "finder";
  PairPush<double> push(const BodyState<double>&, const BodyState<double>&, double) const {
    return {};
  }
  void find_pairs(const Bodies<double>&, std::vector<BodyPair>&) const {}
  Response<double> response(const BodyState<double>&, const BodyState<double>&) const {
    return {.stiffness = 1};
  }
};

}  // namespace

TEST_CASE(
    "An effect that reads how a body moves and does not say how it answers is named in the plan") {
  World<double> world;
  const BodyHandle body = world.add("body", make_particle<double>(1));
  const BodyHandle post = world.add("post", make_static_particle<double>({1, 0, 0}));
  world.add(Blind{}, {body});
  world.add(Harmless{{"harmless"}}, {body});
  world.add(Silent{"idle"}, {post});  // which nothing can move
  world.add(Gravity<double>{});
  world.add(SpringToPoint<double>{.spring = {.stiffness = 1}}, {body});
  world.add(LinearDamping<double>{.rate = 1});
  CHECK(world.plan().unknown.empty());
  CHECK(table_of(world.plan()).find("unknown") == std::string::npos);
  world.add(Silent{}, {body});
  world.add(Finder{});
  REQUIRE(world.plan().unknown.size() == 2);
  CHECK(world.plan().unknown[0] == "'silent' reads position, and has no response()");
  CHECK(world.plan().unknown[1] ==
        "'finder' reads position, velocity, orientation, spin, of pairs that it finds itself");
  CHECK(
      table_of(world.plan())
          .find("\nlimit of the step unknown: 'silent' reads position, and has no response()\n") !=
      std::string::npos);
  CHECK(world.warnings().empty());
}

TEST_CASE("Damping of turns alone keeps Suzuki's scheme at Euler's limit") {
  RigidBody<double> body;
  body.centre = make_particle<double>(1);
  body.top.inverse_moments = {1, 1, 1};
  const auto limit = [&](Scheme scheme, double damping) {
    World<double> world;
    world.step_by(scheme);
    world.add(Steering<double>{4 * Mat3d::Identity(), damping * Mat3d::Identity(), {}},
              {world.add("body", body)});
    return world.step_limit().time_step;
  };
  CHECK(limit(Scheme::suzuki, 1) == limit(Scheme::semi_implicit_euler, 1));
  CHECK(limit(Scheme::suzuki, 0) > 1.3 * limit(Scheme::semi_implicit_euler, 0));
}

TEST_CASE("Of two controllers the one is named that pulls harder, where a damper counts twice") {
  // h² K + 2 h C = 4 with C < h K < 2 C: at h = 8/7 the damper pulls by 2.3, the spring by 1.7.
  RigidBody<double> body;
  body.centre = make_particle<double>(1);
  body.top.inverse_moments = {1, 1, 1};
  World<double> world;
  const BodyHandle handle = world.add("body", body);
  world.add(Steering<double>{1.3125 * Mat3d::Identity(), Mat3d::Zero(), {}}, {handle});
  world.add(Steering<double>{Mat3d::Zero(), Mat3d::Identity(), {}}, {handle});
  const StepLimit<double> limit = world.step_limit();
  CHECK(std::abs(limit.time_step - 8.0 / 7) <= 16 * unit_roundoff<double>);
  CHECK(limit.effect == 1);
}
