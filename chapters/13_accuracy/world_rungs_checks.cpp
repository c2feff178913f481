#include <support/checks.hpp>
#include <support/orders.hpp>
#include <support/random_boxes.hpp>
#include <support/scene_rules.hpp>
#include <tumble/ladder.hpp>

using namespace tumble;
using namespace tumble::support;

TEST_CASE_TEMPLATE("A world turns by the rung of the ladder that its scene names", Real,
                   EVERY_PRECISION) {
  for (std::size_t rule = first_rung; rule < RungsOfWorlds::names.size(); ++rule) {
    CAPTURE(RungsOfWorlds::names[rule]);
    const TurningRung<Real>& rung = turning_rung<Real>(RungsOfWorlds::names[rule]);
    World<Real> world(steps_per_second(10));
    SceneRules::choose(world, rule);
    add_boxes(world, 1);
    Top<Real> top = world.bodies().tops[0];
    world.step();
    rung.turn(top, Real(0.1));
    CHECK(world.turning_method() == rung.name);
    CHECK(tumbling_of(world.step_plan()).effect->traits().order == rung.claims.order);
    CHECK(tumbling_of(world.step_plan()).effect->traits().is_symmetric == rung.claims.reverses);
    const Top<Real>& turned = world.bodies().tops[0];
    CHECK(same_bits(turned.orientation.imaginary, top.orientation.imaginary));
    CHECK(same_bits(turned.angular_momentum_body, top.angular_momentum_body));
    CHECK(rung.claims.bounded);
  }
}

/// A top with moments over twelve decades that turns by about `turn` rad in a second.
template <class Real>
Top<Real> thrown(RandomGenerator& dice, Real turn) {
  Top<Real> top;
  for (int axis = 0; axis < 3; ++axis) {
    top.inverse_moments[axis] = std::pow(Real(10), 6 * dice.real<Real>());
    top.angular_momentum_body[axis] = dice.real<Real>();
  }
  std::sort(top.inverse_moments.data(), top.inverse_moments.data() + 3);
  top.angular_momentum_body *= turn / (top.inverse_moments[2] * top.angular_momentum_body.norm());
  return top;
}

/// Four steps of a second each by every rung that a scene can name, with 200 tops that turn by 1
/// rad to `farthest`. @return how many were stopped
template <class Real>
int stopped_up_to(Real farthest) {
  int stopped = 0;
  for (std::size_t rung = first_rung; rung < SceneRules::names.size(); ++rung) {
    CAPTURE(SceneRules::names[rung]);
    RandomGenerator dice(17);
    for (int trial = 0; trial < 200; ++trial) {
      World<Real> world(steps_per_second(1));
      SceneRules::choose(world, rung);
      const Real turn = std::pow(farthest, (1 + dice.real<Real>()) / 2);
      world.add("top",
                RigidBody<Real>{.centre = make_particle<Real>(1), .top = thrown(dice, turn)});
      for (int step = 0; step < 4; ++step) {
        const Bodies<Real> before = world.bodies();
        try {
          world.step();
        } catch (const SimulationError&) {
          CHECK(same_motion(before, world.bodies()));
          ++stopped;
          break;
        }
      }
      CHECK(is_finite(world.bodies().tops[0]));
    }
  }
  return stopped;
}

TEST_CASE_TEMPLATE(
    "The rungs that a scene can name stay finite wherever sine and cosine reach, whatever the step",
    Real, EVERY_PRECISION) {
  // All of L about one axis turns no farther than this: the longest portion of a row is 1.32 h, and
  // a turn takes the sine of half its angle.
  CHECK(stopped_up_to(2 * SineCosineConstants<Real>::limit / Real(1.32)) == 0);
}

TEST_CASE_TEMPLATE("Beyond that they are stopped, and never leave a number that is none", Real,
                   EVERY_PRECISION) {
  CHECK(stopped_up_to(1000 * SineCosineConstants<Real>::limit) > 0);
}

/// The forces of a problem as an effect of a world.
template <class Forces>
struct AsEffect {
  static constexpr std::string_view name = "problem";
  static constexpr Quantities reads = quantity::time | quantity::orientation;
  Forces evaluate_forces;
  Vec3<double> torque(Top<double> top, double time) const {
    evaluate_forces(top, time);
    return top.torque;
  }
};

/// How far a world has turned a problem's top aside from `truth` in a second.
template <class Forces>
double turned_aside(const Problem<Top<double>, Forces>& problem, std::size_t rule, Scheme scheme,
                    int steps, const Top<Wide>& truth) {
  World<double> world(steps_per_second(steps));
  SceneRules::choose(world, rule);
  world.step_by(scheme);
  world.add("top", RigidBody<double>{.centre = make_particle<double>(1), .top = problem.start});
  world.add(AsEffect<Forces>{problem.evaluate_forces});
  for (int n = 0; n < steps; ++n) world.step();
  const Quaternion<double>& turned = world.bodies().tops[0].orientation;
  return static_cast<double>(angle_between<Wide>(
      {turned.real, turned.imaginary.template cast<Wide>()}, truth.orientation));
}

template <class Forces>
void check_orders_in_worlds(const Problem<Top<double>, Forces>& problem) {
  // The truth by a rung of order 10, in steps of a thousandth of a second.
  Top<Wide> truth{
      .orientation = {problem.start.orientation.real,
                      problem.start.orientation.imaginary.template cast<Wide>()},
      .angular_momentum_body = problem.start.angular_momentum_body.template cast<Wide>(),
      .inverse_moments = problem.start.inverse_moments.template cast<Wide>()};
  const auto evaluate_forces = exactly(problem.evaluate_forces);
  evaluate_forces(truth, 0);
  for (int n = 0; n < 1000; ++n)
    step_by_row<SofroniouSpaletta>(truth, evaluate_forces, n * Wide(0.001L), Wide(0.001L));
  for (const Scheme scheme : {Scheme::semi_implicit_euler, Scheme::verlet, Scheme::suzuki})
    for (std::size_t rule = 0; rule < SceneRules::names.size(); ++rule) {
      CAPTURE(SceneRules::names[rule]);
      CAPTURE(name_of(scheme));
      World<double> world;
      SceneRules::choose(world, rule);
      world.step_by(scheme);
      world.add("top", RigidBody<double>{.centre = make_particle<double>(1), .top = problem.start});
      const int promised = world.plan().accuracy.order;
      const int steps = 64;
      const double order = std::log2(turned_aside(problem, rule, scheme, steps, truth) /
                                     turned_aside(problem, rule, scheme, 2 * steps, truth));
      CAPTURE(order);
      CHECK(std::lround(order) >= promised);
    }
}

TEST_CASE("Under a torque, by every rule and scheme, a world's error falls as its plan promises") {
  check_orders_in_worlds(driven_top<double>());
  check_orders_in_worlds(heavy_top<double>("heavy top", 5));
}
