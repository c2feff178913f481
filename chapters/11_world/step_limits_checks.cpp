#include <Eigen/Eigenvalues>
#include <support/checks.hpp>
#include <support/random_world.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

template <class Real>
RigidBody<Real> random_body(RandomGenerator& dice) {
  const Vec3<Real> sides = (Vec3<Real>(1, 1, 1) + dice.vector<Real>()) / 2;
  return make_rigid_body<Real>(
             "box",
             mass_properties(Box<Real>{sides + Vec3<Real>::Constant(Real(0.05))},
                             std::exp2(3 * dice.real<Real>())),
             {Vec3<Real>::Zero(), quaternion_of_rotation_vector<Real>(3 * dice.vector<Real>())})
      .body;
}

/// What multiplies a force at the arm r to give the acceleration of the point it acts at, world
/// axes, as the texts write it: 1/m − [r]× I⁻¹ [r]×.
Mat3<long double> inverse_mass_matrix(const RigidBody<double>& body, const Vec3d& arm_body) {
  const Mat3<long double> R = matrix_of(body.top.orientation).cast<long double>();
  const Vec3<long double> r = R * arm_body.cast<long double>();
  Mat3<long double> cross;
  cross << 0, -r.z(), r.y(), r.z(), 0, -r.x(), -r.y(), r.x(), 0;
  const Mat3<long double> J =
      R * body.top.inverse_moments.cast<long double>().asDiagonal() * R.transpose();
  return static_cast<long double>(body.centre.inverse_mass) * Mat3<long double>::Identity() -
         cross * J * cross;
}

/// The largest stretch of its spring, as a part of the first one, when a body is held at `arm_body`
/// by one spring along `direction` whose step is `times` its limit.
double growth_on_one_spring(const RigidBody<double>& body, const Vec3d& arm_body,
                            const Vec3d& direction, double times) {
  const auto world_of = [&](std::int64_t nanoseconds) {
    World<double> world(step_of_nanoseconds(nanoseconds));
    world.on_warning([](const std::string&) {});
    const BodyHandle handle = world.add("body", body);
    const Vec3d held = body.centre.position + rotate<double>(body.top.orientation, arm_body);
    world.add(SpringToPoint<double>{.spring = {.stiffness = 100, .rest_length = 1},
                                    .anchor = held - (1 + 1e-9) * direction,
                                    .attachment = arm_body},
              {handle});
    return world;
  };
  const double limit = world_of(1000).step_limit().time_step;
  World<double> world = world_of(std::int64_t(1e9 * times * limit));
  CHECK(world.warnings().empty() == (times < 1));
  const auto energy = [&] {
    const RigidBody<double> now = world.body(world.handle_at(0));
    return kinetic_energy(now.centre) + kinetic_energy(now.top) +
           world.effects()[0].effect->potential_energy({now.centre, now.top},
                                                       {now.centre, now.top});
  };
  const double first = energy();
  double most = first;
  for (int n = 0; n < 200 && most < 1e6 * first; ++n) {
    world.step();
    most = std::max(most, energy());
  }
  return most / first;
}

}  // namespace

TEST_CASE_TEMPLATE("A spring that is too stiff for the step is announced, and its neighbours count",
                   Real, EVERY_PRECISION) {
  // One spring on one mass: the limit is 2 √(m/k), chapter 6's.
  const auto world_with = [](Real stiffness, int springs) {
    World<Real> world(steps_per_second(100));
    world.on_warning([](const std::string&) {});
    const BodyHandle ball = world.add("ball", make_particle<Real>(1));
    for (int n = 0; n < springs; ++n)
      world.add(SpringToPoint<Real>{.spring = {.stiffness = stiffness}, .anchor = {1, 0, 0}},
                {ball});
    return world;
  };
  CHECK(world_with(39'000, 1).plan().warnings.empty());
  CHECK(world_with(41'000, 1).plan().warnings.size() == 1);
  CHECK(world_with(13'000, 3).plan().warnings.empty());
  World<Real> stiff = world_with(14'000, 3);
  REQUIRE(stiff.plan().warnings.size() == 1);
  CHECK(stiff.plan().warnings[0].find("'spring' on 'ball' may gain energy without bound: the time "
                                      "step is 0.01 s, and only up to 0.00975") == 0);
  // And it does: with h² k/m = 4.2 the error grows by 1.56 in each step, 1 mm to 66 m in 25.
  stiff.set_position(stiff.find("ball"), {Real(1.001), 0, 0});
  for (int n = 0; n < 25; ++n) stiff.step();
  CHECK(stiff.position(stiff.find("ball")).norm() > 5);
}

TEST_CASE_TEMPLATE("The limit of springs holds for springs and dampers in any proportion", Real,
                   EVERY_PRECISION) {
  // One point between two walls or three, on a line, with springs between neighbours.
  const auto build = [](World<Real>& world, std::uint64_t seed) {
    RandomGenerator dice(seed);
    std::vector<BodyHandle> points;
    for (std::size_t n = 0; n < (seed % 2 == 0 ? 1 : 3); ++n)
      points.push_back(
          world.add("point " + std::to_string(n),
                    make_particle<Real>(std::exp2(3 * dice.real<Real>()), {Real(n), 0, 0})));
    const auto strength = [&dice] { return dice.one_in(3) ? 0 : std::exp2(6 * dice.real<Real>()); };
    const auto spring = [&strength]() -> Spring<Real> {
      const Real stiffness = strength();
      return {.stiffness = stiffness, .damping = strength(), .rest_length = 1};
    };
    const Real end = Real(points.size());
    world.add(SpringToPoint<Real>{.spring = spring(), .anchor = {-1, 0, 0}}, {points.front()});
    world.add(SpringToPoint<Real>{.spring = spring(), .anchor = {end, 0, 0}}, {points.back()});
    for (std::size_t n = 1; n < points.size(); ++n)
      world.add(SpringBetween<Real>{.spring = spring()}, {points[n - 1], points[n]});
    return points;
  };
  int tried = 0;
  for (std::uint64_t seed = 1; seed <= 120; ++seed) {
    CAPTURE(seed);
    for (const Scheme scheme : {Scheme::semi_implicit_euler, Scheme::verlet, Scheme::suzuki}) {
      World<Real> asked;
      asked.step_by(scheme);
      asked.on_warning([](const std::string&) {});
      build(asked, seed);
      const Real limit = asked.step_limit().time_step;
      if (!(limit < 60)) continue;  // nothing but weak springs
      World<Real> world(step_of_nanoseconds(std::int64_t(0.99e9 * double(limit))));
      world.step_by(scheme);
      const std::vector<BodyHandle> points = build(world, seed);
      CHECK(world.plan().warnings.empty());
      world.set_position(points[0], {Real(0.001), 0, 0});
      // Just below its limit a free swing reaches 1/√(1 − 0.99²) = 7 times its start, and two of
      // three points may hand theirs to the third.
      for (int n = 0; n < 400; ++n) {
        world.step();
        for (std::size_t k = 0; k < points.size(); ++k)
          REQUIRE(std::abs(world.position(points[k]).x() - Real(k)) < Real(0.1));
      }
      ++tried;
    }
  }
  CHECK(tried > 300);

  // A spring of 1 N/m and a damper of 1 N s/m on 1 kg: h² + 2 h < 4, so h < √5 − 1.
  const auto pair = [](Real time_step) {
    World<Real> world(step_of_nanoseconds(std::int64_t(1e9 * double(time_step))));
    world.on_warning([](const std::string&) {});
    const BodyHandle ball = world.add("ball", make_particle<Real>(1, {Real(0.001), 0, 0}));
    for (const Real stiffness : {Real(1), Real(0)})
      world.add(
          SpringToPoint<Real>{
              .spring = {.stiffness = stiffness, .damping = 1 - stiffness, .rest_length = 5},
              .anchor = {5, 0, 0}},
          {ball});
    for (int n = 0; n < 30; ++n) world.step();
    return std::pair(world.step_limit().time_step, std::abs(world.position(ball).x()));
  };
  CHECK(pair(Real(1.5)).first <= std::sqrt(Real(5)) - 1);
  CHECK(pair(Real(1.5)).first > Real(0.9));
  CHECK(pair(Real(1.5)).second > 1);
  CHECK(pair(Real(0.9)).second < Real(0.001));
}

TEST_CASE_TEMPLATE("A mass ratio of 10⁹ on a stiff spring is announced", Real, EVERY_PRECISION) {
  World<Real> world(steps_per_second(60));
  const BodyHandle heavy = world.add("ship", make_particle<Real>(Real(1e6)));
  const BodyHandle light = world.add("bolt", make_particle<Real>(Real(1e-3), {0, 0, 1}));
  world.add(SpringBetween<Real>{.spring = {.stiffness = 1000, .rest_length = 1}}, {heavy, light});
  CHECK(world.plan().warnings.size() == 1);
  CHECK(world.plan().warnings[0].find("'spring between bodies' on 'ship'") == 0);
}

TEST_CASE_TEMPLATE("Springs and dampers at either end of a spring add to what limits the step",
                   Real, EVERY_PRECISION) {
  // Two points of 1 kg and 4 kg, joined, and each held by a spring of its own. The joint's bound is
  // √k (w_a Σ_a √k + w_b Σ_b √k) = 3 (1 (3 + 4) + (3 + 1)/4) = 24 for the stiffnesses 9, 16 and 1,
  // and for the dampers of 4, 1 and 9 it is 2 (1 (2 + 1) + (2 + 3)/4) = 8.5.
  World<Real> world(steps_per_second(1));
  const BodyHandle a = world.add("a", make_particle<Real>(1, {0, 0, 0}));
  const BodyHandle b = world.add("b", make_particle<Real>(4, {0, 0, 1}));
  world.add(SpringBetween<Real>{.spring = {.stiffness = 9, .damping = 4}}, {a, b});
  world.add(SpringToPoint<Real>{.spring = {.stiffness = 16, .damping = 1}}, {a});
  world.add(SpringToPoint<Real>{.spring = {.stiffness = 1, .damping = 9}}, {b});
  const StepLimit<Real> limit = world.step_limit();
  // Those of the others are 4 · 1 · 7 = 28 with 1 · 3, and 1 · 4/4 with 3 · 5/4: of the three, the
  // joint damps the most and would limit the step to h. But the springs are in other proportions
  // than the dampers, so their strengths h² k + 2 h c are bounded once more.
  const Real h = largest_stable_time_step<Real>(24, Real(8.5), 1);
  const Real joint = std::sqrt(9 * h * h + 8 * h), left = std::sqrt(16 * h * h + 2 * h),
             right = std::sqrt(h * h + 18 * h);
  const Real bound = joint * (joint + left + (joint + right) / 4);
  CHECK(bound > left * (joint + left));
  CHECK(bound > right * (joint + right) / 4);
  const Real expected = h * 4 / bound;
  CHECK(limit.effect == 0);
  CHECK(std::abs(limit.time_step - expected) <= 64 * unit_roundoff<Real> * expected);
  // The truth is the larger eigenvalue of h² K + 2 h C, with two coordinates in units of √m.
  const auto strongest = [](Real step) {
    const auto both = [step](Real k, Real c) { return step * step * k + 2 * step * c; };
    const Real first = both(25, 5), second = both(Real(2.5), Real(3.25)),
               joins = both(Real(4.5), 2);
    return (first + second) / 2 + std::hypot((first - second) / 2, joins);
  };
  CHECK(strongest(limit.time_step) < 4);
  CHECK(strongest(limit.time_step) > 3);
}

TEST_CASE_TEMPLATE("A spring held far from the centre of either body limits the step the more",
                   Real, EVERY_PRECISION) {
  // A sphere of 1 kg and radius 1 m turns with an inverse moment of 5/2: held at arm r it moves
  // with the inverse mass 1 + 5/2 r².
  const auto limit = [](Real arm_first, Real arm_second) {
    World<Real> world(steps_per_second(1));
    const auto ball = [](Real x) {
      return make_rigid_body<Real>("ball", mass_properties(Sphere<Real>{1}, 1), {{x, 0, 0}}).body;
    };
    const BodyHandle a = world.add("a", ball(0)), b = world.add("b", ball(4));
    // As long as it rests: under tension it would limit the step by that too.
    world.add(
        SpringBetween<Real>{
            .spring = {.stiffness = 1, .rest_length = std::hypot(Real(4), arm_second - arm_first)},
            .attachment_first = {0, arm_first, 0},
            .attachment_second = {0, arm_second, 0}},
        {a, b});
    return world.step_limit().time_step;
  };
  for (const auto& [first, second] : {std::pair<Real, Real>(1, 2), std::pair<Real, Real>(2, 0)}) {
    const Real sum = 1 + Real(2.5) * first * first + 1 + Real(2.5) * second * second;
    const Real expected = largest_stable_time_step<Real>(sum, 0, 1);
    CHECK(std::abs(limit(first, second) - expected) <= 32 * unit_roundoff<Real> * expected);
  }
}

TEST_CASE_TEMPLATE("The arm at either end counts for the body at that end", Real, EVERY_PRECISION) {
  // A mass of 1 kg that turns with 4 /(kg m²), and one that does not turn.
  RigidBody<Real> light, heavy;
  light.centre = heavy.centre = make_particle<Real>(1);
  light.top.inverse_moments = {4, 4, 4};
  for (const bool at_first : {true, false}) {
    World<Real> world;
    const BodyHandle one = world.add("one", light), other = world.add("other", heavy);
    SpringBetween<Real> spring{.spring = {.stiffness = 1}};
    (at_first ? spring.attachment_first : spring.attachment_second) = {1, 0, 0};
    world.add(spring, at_first ? std::vector{one, other} : std::vector{other, one});
    // 1/m + arm²/I is 1 + 4 at the one end and 1 at the other.
    CHECK(std::abs(world.step_limit().time_step - 2 / std::sqrt(Real(6))) <=
          8 * unit_roundoff<Real>);
  }
}

TEST_CASE_TEMPLATE("No force moves the point that it acts at more easily than the bound says", Real,
                   EVERY_PRECISION) {
  RandomGenerator dice(5);
  for (int n = 0; n < 200; ++n) {
    const RigidBody<double> body = random_body<double>(dice);
    const Vec3d arm = dice.vector<double>();
    const Eigen::SelfAdjointEigenSolver<Mat3<long double>> solver(inverse_mass_matrix(body, arm));
    RigidBody<Real> here;
    here.centre.inverse_mass = Real(body.centre.inverse_mass);
    here.top.inverse_moments = body.top.inverse_moments.cast<Real>();
    const auto expected = Real(solver.eigenvalues()[2]);
    // Some twenty roundings of numbers that are all positive but one, which is smaller.
    CHECK(std::abs(largest_inverse_mass_at<Real>(here, arm.cast<Real>()) - expected) <=
          32 * unit_roundoff<Real> * expected);
    CHECK(largest_inverse_mass_at<Real>(here, {0, 0, 0}) == here.centre.inverse_mass);
  }
}

TEST_CASE("What resists a small turn is the change of the torque") {
  RandomGenerator dice(6);
  for (int n = 0; n < 50; ++n) {
    const Vec3d arm = dice.vector<double>(), turn = 1e-5 * dice.vector<double>();
    // In equilibrium another force takes away the torque; here one along the arm has none.
    const Vec3d force = dice.real<double>() * arm;
    const auto torque_at = [&](const Vec3d& rotation_vector) -> Vec3d {
      return rotate<double>(quaternion_of_rotation_vector<double>(rotation_vector), arm)
          .cross(force);
    };
    const Vec3d change = (torque_at(turn) - torque_at(-turn)) / 2;
    // The difference of two steps leaves the third power of the turn, and roundings of the torques.
    CHECK((turning_stiffness<double>(arm, force) * turn + change).norm() <=
          arm.norm() * force.norm() * (std::pow(turn.norm(), 3) + 8 * unit_roundoff<double>));
  }
  // Of two forces at once, the parts that no energy gives cancel with the torques.
  const Vec3d a(1, 2, 3), F(4, 5, 6), G(-4, -5, -6);
  const Mat3d both = turning_stiffness<double>(a, F) + turning_stiffness<double>(a, G);
  CHECK(both == Mat3d::Zero());
}

TEST_CASE("One spring is stable up to its limit in every direction, and unstable above it in one") {
  RandomGenerator dice(8);
  for (int n = 0; n < 40; ++n) {
    const RigidBody<double> body = random_body<double>(dice);
    const Vec3d arm = dice.vector<double>();
    const Eigen::SelfAdjointEigenSolver<Mat3<long double>> solver(inverse_mass_matrix(body, arm));
    const Vec3d hardest = solver.eigenvectors().col(2).cast<double>();
    CHECK(growth_on_one_spring(body, arm, hardest, 1.05) >= 1e6);
    // E (1 − w h/2) never exceeds what E (1 + w h/2) was: chapter 6.
    CHECK(growth_on_one_spring(body, arm, hardest, 0.99) <= 1.99 / 0.01);
    CHECK(growth_on_one_spring(body, arm, dice.vector<double>().normalized(), 0.99) <= 1.99 / 0.01);
  }
}

TEST_CASE_TEMPLATE("A spring under tension limits the step by what it does to a turn", Real,
                   EVERY_PRECISION) {
  // Two springs pull a box of 1 kg apart along y with F = 70 N/m · 9.8 m = 686 N, at arms of a =
  // 0.2 m. A turn by θ about z meets the torque −2 F a (1 + a/9.8 m) θ = −280 θ N m. With the
  // inverse moment 92 /(kg m²) that is w = 161 /s: w h is 2.7 at 60 steps a second, and 0.67 at
  // 240.
  const auto box_between = [](int rate, Real k) {
    World<Real> world(steps_per_second(rate));
    world.on_warning([](const std::string&) {});
    const RigidBody<Real> box =
        make_rigid_body<Real>("box",
                              mass_properties(Box<Real>{{Real(0.2), Real(0.3), Real(0.4)}}, 1), {},
                              {0, 0, 0}, Vec3<Real>::Constant(Real(0.1)))
            .body;
    const BodyHandle handle = world.add("box", box);
    for (const Real side : {Real(-1), Real(1)})
      world.add(SpringToPoint<Real>{.spring = {.stiffness = k},
                                    .anchor = {0, 10 * side, 0},
                                    .attachment =
                                        rotate_back<Real>(box.top.orientation, {0, side / 5, 0})},
                {handle});
    return world;
  };
  const auto growth = [&](int rate) {
    World<Real> world = box_between(rate, 70);
    CHECK(world.plan().warnings.empty() == (rate == 240));
    const Real start = kinetic_energy(world.body(world.handle_at(0)).top);
    Real most = start;
    for (int n = 0; n < 10 * rate; ++n) {
      world.step();
      most = std::max(most, kinetic_energy(world.body(world.handle_at(0)).top));
    }
    return most / start;
  };
  CHECK(growth(60) > 1000);
  // There the energy of one oscillation wavers by (1 + w h/2)/(1 − w h/2) = 2, and two may meet.
  CHECK(growth(240) < 4);
  // Of the pull that limits the step 97 % are the tension's, and its bound is too careful by 3 %.
  const Real w = std::sqrt(2 * 70 * Real(9.8) * Real(0.2) * (1 + Real(0.2 / 9.8)) * 12 /
                           (Real(0.2 * 0.2) + Real(0.3 * 0.3)));
  const Real limit = box_between(60, 70).step_limit().time_step;
  CHECK(limit < 2 / w);
  CHECK(limit > Real(0.97) * 2 / w);
}

namespace {

/// A force that keeps its size and direction, at a point of the body: a tow rope, say.
template <class Real>
struct PullAtPoint {
  static constexpr std::string_view name = "pull";
  Vec3<Real> pull, point;  // N, world axes; m, body axes
  Push<Real> push(const BodyState<Real>& body, Real) const {
    return {pull, arm_of<Real>(body, point).cross(pull)};
  }
  Response<Real> response(const BodyState<Real>& body) const {
    return {.arm_first = arm_of<Real>(body, point), .force = pull};
  }
};

}  // namespace

TEST_CASE_TEMPLATE("Two forces without stiffness that pull a body apart limit the step by its turn",
                   Real, EVERY_PRECISION) {
  // A turn by θ meets the torque −2 F a θ: h = 2 √(I/(2 F a)), 9.3 ms.
  const Real F = 1000, a = Real(0.23), I = Real(0.01), limit = 2 * std::sqrt(I / (2 * F * a));
  for (const Real times : {Real(0.99), Real(1.07)}) {
    World<Real> world(step_of_nanoseconds(std::int64_t(1e9 * double(times * limit))));
    world.on_warning([](const std::string&) {});
    RigidBody<Real> body;
    body.centre = make_particle<Real>(1);
    body.top.inverse_moments = Vec3<Real>::Constant(1 / I);
    const BodyHandle handle = world.add("body", body);
    for (const Real side : {Real(-1), Real(1)})
      world.add(PullAtPoint<Real>{{side * F, 0, 0}, {side * a, 0, 0}}, {handle});
    CHECK(std::abs(world.step_limit().time_step - limit) <= 16 * unit_roundoff<Real> * limit);
    CHECK(world.warnings().empty() == (times < 1));
    world.set_angular_velocity(handle, {0, 0, Real(1e-3)});
    Real fastest = 0;
    for (int n = 0; n < 200; ++n) {
      world.step();
      fastest = std::max(fastest, world.angular_velocity(handle).norm());
    }
    CHECK((fastest < 1) == (times < 1));
  }
}

TEST_CASE("A chain of boxes under tension is stable below its limit, whatever its boxes") {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    CAPTURE(seed);
    // Boxes along x, each held at two points of that line, and equal tensions: all in equilibrium.
    // How many times as easily the ends of a box yield as its centre does, at most:
    double yielding = 1;
    const auto build = [seed, &yielding](World<double>& world) {
      RandomGenerator dice(seed);
      const double tension = std::exp2(8 * dice.real<double>());
      const std::size_t count = 1 + dice.below(3);
      std::vector<BodyHandle> boxes;
      std::vector<double> arms;
      for (std::size_t n = 0; n < count; ++n) {
        RigidBody<double> box = random_body<double>(dice);
        box.centre.position = {double(4 * n), 0, 0};
        boxes.push_back(world.add("box " + std::to_string(n), box));
        arms.push_back(0.8 + 0.7 * dice.real<double>());
        const Eigen::SelfAdjointEigenSolver<Mat3<long double>> solver(inverse_mass_matrix(
            box, rotate_back<double>(box.top.orientation, {arms.back(), 0, 0})));
        yielding = std::max(yielding, double(solver.eigenvalues()[2]) / box.centre.inverse_mass);
      }
      const auto held = [&](std::size_t n, double side) {
        return rotate_back<double>(world.orientation(boxes[n]), {side * arms[n], 0, 0});
      };
      const auto spring_over = [&](double length) -> Spring<double> {
        const double stiffness = tension / length * (1 + std::exp2(4 * dice.real<double>()));
        return {.stiffness = stiffness, .rest_length = length - tension / stiffness};
      };
      for (const auto& [n, side] : {std::pair(std::size_t(0), -1.0), std::pair(count - 1, 1.0)}) {
        const double length = 4 - arms[n];
        world.add(SpringToPoint<double>{.spring = spring_over(length),
                                        .anchor = {double(4 * n) + side * 4, 0, 0},
                                        .attachment = held(n, side)},
                  {boxes[n]});
      }
      for (std::size_t n = 1; n < count; ++n)
        world.add(SpringBetween<double>{.spring = spring_over(4 - arms[n - 1] - arms[n]),
                                        .attachment_first = held(n - 1, 1),
                                        .attachment_second = held(n, -1)},
                  {boxes[n - 1], boxes[n]});
    };
    const auto kinetic = [](const World<double>& world) {
      double sum = 0;
      for (const Particle<double>& centre : world.bodies().centres) sum += kinetic_energy(centre);
      for (const Top<double>& top : world.bodies().tops) sum += kinetic_energy(top);
      return sum;
    };
    World<double> asked;
    asked.on_warning([](const std::string&) {});
    build(asked);
    const StepLimit<double> limit = asked.step_limit();
    const auto growth = [&](Scheme scheme, double time_step) {
      World<double> world(step_of_nanoseconds(std::int64_t(1e9 * time_step)));
      world.on_warning([](const std::string&) {});
      build(world);
      world.step_by(scheme);
      CHECK(world.warnings().empty() == (time_step < limit.time_step));
      RandomGenerator dice(seed + 1000);
      for (BodyIndex n = 0; n < world.body_count(); ++n) {
        world.set_velocity(world.handle_at(n), 1e-6 * dice.vector<double>());
        world.set_angular_velocity(world.handle_at(n), 1e-6 * dice.vector<double>());
      }
      const double first = kinetic(world);
      double most = first;
      for (int n = 0; n < 400 && most < 1e6 * first; ++n) {
        world.step();
        most = std::max(most, kinetic(world));
      }
      return most / first;
    };
    // How many times too careful the limit can be. A box that is moved alone along the chain feels
    // w S, with the inverse mass w of its centre and the sum S of its two springs, and one that is
    // turned alone at least what the tension does to the turn. The fastest swing has at least the
    // larger of these. The bound adds to the latter a hold's √k (w_a Σ_a √k + w_b Σ_b √k), where w
    // is `yielding` times as large at most; √k (√k + √k') is (1 + √2)/2 times k + k' at most, and
    // each end has no more than the largest w S.
    const double times = std::sqrt(1 + (1 + std::numbers::sqrt2) * yielding);
    for (const Scheme scheme : {Scheme::semi_implicit_euler, Scheme::verlet}) {
      // As above; and of the small motions' next order there is a thousandth at most.
      CHECK(growth(scheme, 0.99 * limit.time_step) <= 1.001 * 1.99 / 0.01);
      CHECK(growth(scheme, 1.01 * times * limit.time_step) >= 1e6);
    }
  }
}

TEST_CASE("A chain of points under tension explodes from 1.56 times its limit on") {
  // Nothing turns, and the springs hold the centres: the factor of the case before is √(1 + √2).
  const double times = std::sqrt(1 + std::numbers::sqrt2);
  double sharpest = times;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    CAPTURE(seed);
    RandomGenerator dice(seed);
    const std::size_t count = 1 + dice.below(8);
    const bool are_alike = dice.one_in(3);
    const double tension = std::exp2(4 * dice.real<double>());
    std::vector<double> masses, stiffnesses;
    for (std::size_t n = 0; n <= count; ++n) {
      masses.push_back(are_alike ? 1 : std::exp2(3 * dice.real<double>()));
      stiffnesses.push_back(tension * (are_alike ? 2 : 1 + std::exp2(5 * dice.real<double>())));
    }
    const auto chain = [&](double time_step) {
      World<double> world(step_of_nanoseconds(std::int64_t(1e9 * time_step)));
      world.on_warning([](const std::string&) {});
      std::vector<BodyHandle> points;
      for (std::size_t n = 0; n < count; ++n)
        points.push_back(world.add(
            "point " + std::to_string(n),
            make_particle<double>(masses[n], {double(n), 0, 0}, 1e-6 * dice.vector<double>())));
      const auto spring = [&](std::size_t n) -> Spring<double> {
        return {.stiffness = stiffnesses[n], .rest_length = 1 - tension / stiffnesses[n]};
      };
      world.add(SpringToPoint<double>{.spring = spring(0), .anchor = {-1, 0, 0}}, {points[0]});
      for (std::size_t n = 1; n < count; ++n)
        world.add(SpringBetween<double>{.spring = spring(n)}, {points[n - 1], points[n]});
      world.add(SpringToPoint<double>{.spring = spring(count), .anchor = {double(count), 0, 0}},
                {points.back()});
      return world;
    };
    const auto grows = [&](double time_step) {
      World<double> world = chain(time_step);
      const double first = 1e-6 * double(count);
      for (int n = 0; n < 1000; ++n) {
        world.step();
        double off = 0;
        for (std::size_t k = 0; k < count; ++k)
          off += (world.bodies().centres[k].position - Vec3d(double(k), 0, 0)).norm();
        if (off > 1000 * first) return true;
      }
      return false;
    };
    const double limit = chain(1e-3).step_limit().time_step;
    CHECK(!grows(0.99 * limit));
    CHECK(grows(1.01 * times * limit));
    // The truth: the fastest swing along the chain.
    const auto size = static_cast<Eigen::Index>(count);
    using Matrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;
    Matrix A = Matrix::Zero(size, size);
    for (std::size_t n = 0; n < count; ++n) {
      const auto i = static_cast<Eigen::Index>(n);
      A(i, i) = (stiffnesses[n] + stiffnesses[n + 1]) / masses[n];
      if (n > 0) A(i, i - 1) = A(i - 1, i) = -stiffnesses[n] / std::sqrt(masses[n] * masses[n - 1]);
    }
    const Eigen::SelfAdjointEigenSolver<Matrix> solver(A);
    const double truth = 2 / std::sqrt(double(solver.eigenvalues()[size - 1]));
    CHECK(limit <= truth * (1 + 64 * unit_roundoff<double>));
    CHECK(truth <= times * limit);
    sharpest = std::min(sharpest, truth / limit);
  }
  // For a single point between two like springs it is sharp: √k (√k + √k) w = 2 k w.
  CHECK(sharpest < 1 + 64 * unit_roundoff<double>);
}

TEST_CASE_TEMPLATE(
    "Below the limit drag only slows, beyond it throws back more slowly, and beyond twice the "
    "limit it explodes",
    Real, EVERY_PRECISION) {
  RandomGenerator dice(9);
  for (int n = 0; n < 100; ++n) {
    const Real mass = std::exp2(3 * dice.real<Real>()), c = std::exp2(3 * dice.real<Real>());
    const Vec3<Real> velocity = 10 * dice.vector<Real>(), wind = 10 * dice.vector<Real>();
    const auto feather_at = [&](std::int64_t nanoseconds) {
      World<Real> world(step_of_nanoseconds(nanoseconds));
      world.on_warning([](const std::string&) {});
      world.add("feather", make_particle<Real>(mass, {0, 0, 0}, velocity));
      world.add(QuadraticDrag<Real>{c, wind});
      return world;
    };
    const double limit = double(feather_at(1000).step_limit().time_step);
    // h · 2 c |u|/m = 2
    CHECK(limit == doctest::Approx(double(mass / (c * (velocity - wind).norm()))).epsilon(1e-6));
    // One step of h leaves 1 - h c |u|/m of the motion through the air.
    for (const double times : {0.5, 1.0, 1.5, 1.9}) {
      World<Real> world = feather_at(std::int64_t(1e9 * times * limit));
      world.step();
      const Vec3<Real> left = world.body(world.handle_at(0)).centre.velocity - wind;
      const Real share = left.dot(velocity - wind) / (velocity - wind).squaredNorm();
      const double nanosecond = 1e-9 / limit;
      CHECK(std::abs(double(share) - (1 - times)) <=
            nanosecond + 8 * unit_roundoff<Real> * (1 + wind.norm() / (velocity - wind).norm()));
    }
    for (const double times : {0.1, 0.99, 2.1}) {
      World<Real> world = feather_at(std::int64_t(1e9 * times * limit));
      CHECK(world.warnings().empty() == (times < 1));
      Real speed = (velocity - wind).norm();
      const Real first = speed;
      for (int k = 0; k < 8 && speed < 1000 * first; ++k) {
        world.step();
        const Real now = (world.body(world.handle_at(0)).centre.velocity - wind).norm();
        if (times < 1)
          CHECK(now <= speed + 8 * unit_roundoff<Real> * wind.norm());
        else
          CHECK(now > speed);
        speed = now;
      }
      if (times > 1) CHECK(speed > 100 * first);
    }
  }
}

TEST_CASE("Where drag balances weight, the speed settles below the limit and hunts above") {
  // κ = h c/m and v = −√(m g/c): a small change of v is multiplied by 1 − 2 κ |v|, which is −1
  // where κ |v| = 1.
  const double mass = 1e-5, c = 1e-3, terminal = std::sqrt(mass * 9.81 / c);
  for (const double times : {0.5, 0.95, 1.05}) {
    World<double> world(step_of_nanoseconds(std::int64_t(1e9 * times * mass / (c * terminal))));
    world.on_warning([](const std::string&) {});
    const BodyHandle mote =
        world.add("mote", make_particle<double>(mass, {0, 0, 0}, {0, 0, -terminal * 1.001}));
    world.add(Gravity<double>{});
    world.add(QuadraticDrag<double>{c});
    CHECK(world.warnings().empty() == (times < 1));
    for (int n = 0; n < 1000; ++n) world.step();
    const double off = std::abs(world.velocity(mote).z() / -terminal - 1);
    CHECK((off < 1e-6) == (times < 1));
    CHECK((off > 0.01) == (times > 1));
  }
}

TEST_CASE("A floating ball is stable up to its limit where it floats by half, and not above") {
  // There the surface cuts a great circle: k = ρ g π r².
  const double radius = 0.1, half = 2.0 / 3 * std::numbers::pi * std::pow(radius, 3) * 1000;
  for (const double times : {0.99, 1.02}) {
    const double limit = 2 / std::sqrt(1000 * 9.81 * std::numbers::pi * radius * radius / half);
    World<double> world(step_of_nanoseconds(std::int64_t(1e9 * times * limit)));
    world.on_warning([](const std::string&) {});
    const BodyHandle ball = world.add("ball", make_particle<double>(half, {0, 0, 1e-6}));
    world.add(Gravity<double>{});
    world.add(Buoyancy<double>{.radius = radius});
    CHECK(world.warnings().empty() == (times < 1));
    double most = 0;
    for (int n = 0; n < 200; ++n) {
      world.step();
      most = std::max(most, std::abs(world.position(ball).z()));
    }
    CHECK((most < 1e-4) == (times < 1));
  }
}

TEST_CASE("Numbers beyond all measure limit the step, and stop nothing") {
  World<double> world;
  std::vector<std::string> told;
  world.on_warning([&](const std::string& warning) { told.push_back(warning); });
  const BodyHandle point = world.add("point", make_particle<double>(1e-300, {1e300, 0, 0}));
  world.add(SpringToPoint<double>{.spring = {.stiffness = 1e300}}, {point});
  CHECK(world.step_limit().time_step < 1e-100);
  CHECK(world.warnings().size() == 1);
}
