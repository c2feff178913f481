#include <course/checks.hpp>
#include <course/complaint_of_step.hpp>
#include <course/random_world.hpp>

using namespace tumble;
using namespace tumble::course;

namespace {

const PlanRow* row_of(const Plan& plan, std::string_view effect) {
  for (const PlanRow& row : plan.rows)
    if (row.effect == effect) return &row;
  return nullptr;
}

/// A text with every run of blanks made one.
std::string squeezed(const std::string& text) {
  std::string result;
  for (const char letter : text)
    if (letter != ' ' || result.empty() || result.back() != ' ') result += letter;
  return result;
}

/// A force that is no number after a tenth of a second.
template <class Real>
struct BrokenMotor {
  static constexpr std::string_view name = "broken motor";
  Vec3<Real> force(const Particle<Real>&, Real time) const {
    return {time < Real(0.1) ? Real(0) : std::numeric_limits<Real>::quiet_NaN(), 0, 0};
  }
};

template <class Real>
RigidBody<Real> box_body(const Vec3<Real>& spin = Vec3<Real>::Zero()) {
  return make_rigid_body<Real>("box", mass_properties(Box<Real>{{1, 2, 3}}, 2), {},
                               Vec3<Real>::Zero(), spin)
      .body;
}

}  // namespace

//! [thousand]
TEST_CASE_TEMPLATE("A thousand random worlds move by plan as by the reference run, to the bit",
                   Real, EVERY_PRECISION) {
  int moved = 0;
  for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
    CAPTURE(seed);
    Dice dice(seed);
    World<Real> planned = random_world<Real>(dice);
    World<Real> reference = planned;
    const Bodies<Real> start = planned.bodies();
    Dice planned_dice = dice, reference_dice = dice;
    for (int n = 0; n < 12; ++n) {
      if (n % 4 == 3) {
        meddle(planned, planned_dice, n);
        meddle(reference, reference_dice, n);
      }
      const std::string complaint = complaint_of_step([&] { planned.step(); });
      REQUIRE(complaint_of_step([&] { reference.step_by_reference(); }) == complaint);
      REQUIRE(same_motion(planned.bodies(), reference.bodies()));
    }
    moved += !same_motion(start, planned.bodies());
  }
  CHECK(moved > 800);  // the worlds are not idle: four in five have changed
}
//! [thousand]

//! [both_fail]
TEST_CASE_TEMPLATE("A step that fails by plan fails by the reference run too, in the same words",
                   Real, EVERY_PRECISION) {
  int failed = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    CAPTURE(seed);
    Dice dice(seed);
    World<Real> planned = random_world<Real>(dice);
    planned.add(BrokenMotor<Real>{});
    World<Real> reference = planned;
    for (int n = 0; n < 12; ++n) {
      const Bodies<Real> before = planned.bodies();
      const std::string complaint = complaint_of_step([&] { planned.step(); });
      REQUIRE(complaint_of_step([&] { reference.step_by_reference(); }) == complaint);
      REQUIRE(same_motion(planned.bodies(), reference.bodies()));
      if (complaint.empty()) continue;
      REQUIRE(same_motion(planned.bodies(), before));
      ++failed;
      break;
    }
  }
  CHECK(failed > 50);  // wherever a body is not static
}
//! [both_fail]

TEST_CASE_TEMPLATE("A top with equal moments turns by splitting as it turns steadily", Real,
                   EVERY_PRECISION) {
  Dice dice(7);
  for (int n = 0; n < 100; ++n) {
    Top<Real> steady;
    steady.inverse_moments = Vec3<Real>::Constant(Real(2));
    steady.angular_momentum_body = 3 * dice.vector<Real>();
    steady.orientation = quaternion_of_rotation_vector<Real>(3 * dice.vector<Real>());
    Top<Real> split = steady;
    turn_steadily(steady, Real(0.1));
    turn_by_splitting(split, Real(0.1));
    // Two turns by nothing and the length brought back: eight roundings of numbers up to |L| < 6.
    CHECK(distance(split.angular_momentum_body, steady.angular_momentum_body) <=
          8 * 6 * unit_roundoff<Real>);
    CHECK(distance(split.orientation.imaginary, steady.orientation.imaginary) <=
          16 * unit_roundoff<Real>);
  }
}

//! [nothing]
TEST_CASE_TEMPLATE("A scene of resting points under no force runs no pass at all", Real,
                   EVERY_PRECISION) {
  World<Real> world;
  world.add("a", make_particle<Real>(1, {1, 2, 3}));
  world.add("b", make_static_particle<Real>({0, 0, 0}));
  world.add(LinearDamping<Real>{.rate = 1});
  CHECK(world.plan().passes() == 0);
  CHECK(world.top_count() == 0);
  world.step();
  CHECK(world.ticks() == 1);
}
//! [nothing]

//! [first_spin]
TEST_CASE_TEMPLATE("A first spin changes the plan at once, and the world says so", Real,
                   EVERY_PRECISION) {
  World<Real> world;
  const BodyHandle box = world.add("box", box_body<Real>());
  CHECK(row_of(world.plan(), "tumbling: splitting")->visited == 0);
  CHECK(row_of(world.plan(), "tumbling: splitting")->reason ==
        "not 1: no spin and nothing that can give torque");
  CHECK(world.news().empty());
  for (int n = 0; n < 3; ++n) world.step();
  world.set_angular_velocity(box, {0, 1, 0});
  CHECK(row_of(world.plan(), "tumbling: splitting")->visited == 1);
  REQUIRE(world.news().size() == 1);
  CHECK(world.news()[0] ==
        "step 3: tumbling: splitting visits 1 of 1, before 0 ('box' got its first spin)");
  const Quaternion<Real> before = world.body(box).top.orientation;
  world.step();
  CHECK_FALSE(same_bits(world.body(box).top.orientation.imaginary, before.imaginary));
}
//! [first_spin]

TEST_CASE_TEMPLATE("A first torque calls for turning, and turning for the Magnus force", Real,
                   EVERY_PRECISION) {
  World<Real> world;
  const BodyHandle ball = world.add(
      "ball",
      make_rigid_body<Real>("ball", mass_properties(Sphere<Real>{1}, 2), {}, {1, 0, 0}).body);
  world.add(Magnus<Real>{.strength = 1});  // before the effect that calls for it
  CHECK(row_of(world.plan(), "Magnus force")->visited == 0);
  const EffectHandle thruster =
      world.add(Thruster<Real>{.force_body = {1, 0, 0}, .point = {0, 1, 0}}, {ball});
  CHECK(row_of(world.plan(), "Magnus force")->visited == 1);
  CHECK(row_of(world.plan(), "steady turning")->visited == 1);
  CHECK(row_of(world.plan(), "kick of the spin")->visited == 1);
  world.remove(thruster);  // before the ball turned
  CHECK(row_of(world.plan(), "Magnus force")->visited == 0);
  CHECK(row_of(world.plan(), "kick of the spin")->visited == 0);
}

//! [explain]
TEST_CASE("A plan prints as a table, with a reason in every line") {
  World<double> world;
  for (int n = 0; n < 3; ++n)
    world.add("ball " + std::to_string(n),
              make_rigid_body<double>("ball", mass_properties(Sphere<double>{1}, 2), {},
                                      Vec3d::Zero(), {0, 0, 1})
                  .body);
  world.add("box", box_body<double>({0, 0, 1}));
  world.add(Gravity<double>{});
  const std::string table = squeezed(table_of(world.plan()));
  CHECK(table.find("\ngravity force 4 of 4 mass force every body calls for it\n") !=
        std::string::npos);
  CHECK(table.find("\ntumbling: splitting drift 1 of 4 ") != std::string::npos);
  CHECK(table.find("not 3: equal moments or a locked axis: they turn steadily\n") !=
        std::string::npos);
  CHECK(table.find("\nkick of the spin no pass 0 of 4 ") != std::string::npos);
  for (const Plan plan = world.plan(); const PlanRow& row : plan.rows) {
    CAPTURE(row.effect);
    CHECK(!row.reason.empty());
  }
}
//! [explain]

TEST_CASE_TEMPLATE("A spring that is too stiff for the step is announced, and its neighbours count",
                   Real, EVERY_PRECISION) {
  // One spring on one mass: the limit is 2 √(m/k), chapter 6's.
  const auto world_with = [](Real stiffness, int springs) {
    World<Real> world(steps_per_second(100));
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
  CHECK(stiff.body(stiff.find("ball")).centre.position.norm() > 5);
}

//! [mixed_springs]
TEST_CASE_TEMPLATE("The limit of springs holds for springs and dampers in any proportion", Real,
                   EVERY_PRECISION) {
  // One point between two walls or three, on a line, with springs between neighbours.
  const auto build = [](World<Real>& world, std::uint64_t seed) {
    Dice dice(seed);
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
      const Real limit = asked.spring_limit().time_step;
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
          REQUIRE(std::abs(world.body(points[k]).centre.position.x() - Real(k)) < Real(0.1));
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
    return std::pair(world.spring_limit().time_step,
                     std::abs(world.body(ball).centre.position.x()));
  };
  CHECK(pair(Real(1.5)).first <= std::sqrt(Real(5)) - 1);
  CHECK(pair(Real(1.5)).first > Real(0.9));
  CHECK(pair(Real(1.5)).second > 1);
  CHECK(pair(Real(0.9)).second < Real(0.001));
}
//! [mixed_springs]

TEST_CASE_TEMPLATE("A mass ratio of 10^9 on a stiff spring is announced", Real, EVERY_PRECISION) {
  World<Real> world(steps_per_second(60));
  const BodyHandle heavy = world.add("ship", make_particle<Real>(Real(1e6)));
  const BodyHandle light = world.add("bolt", make_particle<Real>(Real(1e-3), {0, 0, 1}));
  world.add(SpringBetween<Real>{.spring = {.stiffness = 1000, .rest_length = 1}}, {heavy, light});
  CHECK(world.plan().warnings.size() == 1);
  CHECK(world.plan().warnings[0].find("'spring between bodies' on 'ship'") == 0);
}

//! [tension]
TEST_CASE_TEMPLATE(
    "The limit of springs leaves out what a tension does to a turn: nobody is warned", Real,
    EVERY_PRECISION) {
  // Two springs pull a box of 1 kg apart along y with F = 70 N/m · 9.8 m = 686 N, at arms of a =
  // 0.2 m. A turn by θ about z meets the torque −2 F a (1 + a/9.8 m) θ = −280 θ N m. With the
  // inverse moment 92 /(kg m²) that is w = 161 /s: w h is 2.7 at 60 steps a second, and 0.67 at
  // 240.
  const auto growth = [](int rate) {
    World<Real> world(steps_per_second(rate));
    const RigidBody<Real> box =
        make_rigid_body<Real>("box",
                              mass_properties(Box<Real>{{Real(0.2), Real(0.3), Real(0.4)}}, 1), {},
                              {0, 0, 0}, Vec3<Real>::Constant(Real(0.1)))
            .body;
    const BodyHandle handle = world.add("box", box);
    for (const Real side : {Real(-1), Real(1)})
      world.add(SpringToPoint<Real>{.spring = {.stiffness = 70},
                                    .anchor = {0, 10 * side, 0},
                                    .attachment =
                                        rotate_back<Real>(box.top.orientation, {0, side / 5, 0})},
                {handle});
    CHECK(world.plan().warnings.empty());
    const Real start = kinetic_energy(box.top);
    Real most = start;
    for (int n = 0; n < 10 * rate; ++n) {
      world.step();
      most = std::max(most, kinetic_energy(world.body(handle).top));
    }
    return most / start;
  };
  CHECK(growth(60) > 1000);
  // There the energy of one oscillation wavers by (1 + w h/2)/(1 − w h/2) = 2, and two may meet.
  CHECK(growth(240) < 4);
}
//! [tension]
