// What effects answer when they are asked alone: what they refuse, when they are not needed, and
// what energy they store.
#include <course/checks.hpp>
#include <course/random_world.hpp>

using namespace tumble;
using namespace tumble::course;

namespace {

template <class Real>
const Real nan_of = std::numeric_limits<Real>::quiet_NaN();

template <class Real>
RigidBody<Real> random_box(Dice& dice) {
  return make_rigid_body<Real>(
             "box", mass_properties(Box<Real>{{1, 2, 3}}, 2),
             {dice.vector<Real>(), quaternion_of_rotation_vector<Real>(3 * dice.vector<Real>())},
             dice.vector<Real>(), dice.vector<Real>())
      .body;
}

template <class Real>
BodyState<Real> state_of(const RigidBody<Real>& body) {
  return {body.centre, body.top};
}

/// A body of 1 kg at rest.
template <class Real>
RigidBody<Real> still_body(const Vec3<Real>& inverse_moments) {
  RigidBody<Real> body;
  body.centre = make_particle<Real>(1);
  body.top.inverse_moments = inverse_moments;
  return body;
}

}  // namespace

TEST_CASE_TEMPLATE("Each value of each effect is refused where it is no number", Real,
                   EVERY_PRECISION) {
  const Real nan = nan_of<Real>;
  const Vec3<Real> bad(0, nan, 0);
  const auto refused = [](const auto& effect, const std::string& name) {
    CHECK(complaint_of([&] { effect.check(); }).find(name + " is ") == 0);
  };
  refused(QuadraticDrag<Real>{.coefficient = nan}, "drag coefficient");
  refused(QuadraticDrag<Real>{.coefficient = 1, .wind = bad}, "wind");
  refused(Magnus<Real>{.strength = 1, .wind = bad}, "wind");
  refused(Buoyancy<Real>{.density = -1}, "density of the liquid");
  refused(Buoyancy<Real>{.surface = nan}, "height of the surface");
  refused(Buoyancy<Real>{.gravity = -1}, "gravity");
  refused(GravityAsAcceleration<Real>{.gravity = bad}, "gravity");
  refused(PointGravity<Real>{.strength = 1, .centre = bad}, "centre of point gravity");
  refused(SpringToPoint<Real>{.anchor = bad}, "anchor of a spring");
  refused(SpringToPoint<Real>{.attachment = bad}, "attachment of a spring");
  refused(SpringBetween<Real>{.spring = {.stiffness = -1}}, "stiffness of a spring");
  refused(SpringBetween<Real>{.attachment_first = bad}, "first attachment of a spring");
  refused(SpringBetween<Real>{.attachment_second = bad}, "second attachment of a spring");
  refused(Thruster<Real>{.force_body = bad}, "force of a thruster");
  refused(Thruster<Real>{.point = bad}, "place of a thruster");
  refused(Thruster<Real>{.from = nan}, "start of a thruster");
  CHECK(complaint_of([] { Thruster<Real>{.from = 2, .until = 2}.check(); }) == "nothing thrown");
}

TEST_CASE_TEMPLATE("A body that moves and turns needs an effect unless a value of that is zero",
                   Real, EVERY_PRECISION) {
  const Facts facts{.moves = true, .turns = true};
  const auto needed = [&](const auto& effect) { return effect.why_skipped(facts).empty(); };
  CHECK(needed(LinearDamping<Real>{.rate = 1}));
  CHECK_FALSE(needed(LinearDamping<Real>{}));
  CHECK(needed(AngularDamping<Real>{.rate = 1}));
  CHECK_FALSE(needed(AngularDamping<Real>{}));
  CHECK(needed(QuadraticDrag<Real>{.coefficient = 1}));
  CHECK_FALSE(needed(QuadraticDrag<Real>{}));
  CHECK(needed(Magnus<Real>{.strength = 1}));
  CHECK_FALSE(needed(Magnus<Real>{}));
  CHECK(needed(Buoyancy<Real>{.density = 1, .radius = 1, .gravity = 1}));
  CHECK_FALSE(needed(Buoyancy<Real>{.density = 0, .radius = 2}));
  CHECK_FALSE(needed(Buoyancy<Real>{}));  // of no radius
  CHECK_FALSE(needed(Buoyancy<Real>{.radius = 2, .gravity = 0}));
  CHECK(needed(SpringToPoint<Real>{.spring = {.stiffness = 1}}));
  CHECK(needed(SpringToPoint<Real>{.spring = {.damping = 1}}));
  CHECK_FALSE(needed(SpringToPoint<Real>{}));
  const auto joins = [&](const Spring<Real>& spring) {
    return SpringBetween<Real>{.spring = spring}.why_skipped().empty();
  };
  CHECK(joins({.stiffness = 1}));
  CHECK(joins({.damping = 1}));
  CHECK_FALSE(joins({}));
}

TEST_CASE_TEMPLATE("A spring between bodies pulls and damps as one to a point that moves along",
                   Real, EVERY_PRECISION) {
  Dice dice(17);
  for (int n = 0; n < 50; ++n) {
    const RigidBody<Real> a = random_box<Real>(dice), b = random_box<Real>(dice);
    const Spring<Real> spring{.stiffness = 3, .damping = 2, .rest_length = Real(0.5)};
    const Vec3<Real> held_a = dice.vector<Real>(), held_b = dice.vector<Real>();
    const SpringBetween<Real> between{
        .spring = spring, .attachment_first = held_a, .attachment_second = held_b};
    const PairPush<Real> push = between.push(state_of(a), state_of(b), 0);
    // By chapter 5's functions: both points, how fast they part, and the torques.
    const Vec3<Real> p = point_outward(pose_of(a), held_a), q = point_outward(pose_of(b), held_b);
    const Real length = (p - q).norm();
    const Vec3<Real> along = (p - q) / length;
    const Real parting = (velocity_at(a, p) - velocity_at(b, q)).dot(along);
    const Vec3<Real> force = -(3 * (length - Real(0.5)) + 2 * parting) * along;
    // Places, arms and speeds below 8, so forces below 64 N and torques below 512 N m, where the
    // direction of a spring of length l loses 1/l; some sixty roundings.
    const Real slack = 64 * unit_roundoff<Real> * (1 + 1 / length);
    CHECK(distance(push.force_on_first, force) <= 64 * slack);
    CHECK(distance(push.torque_on_first, (p - a.centre.position).cross(force)) <= 512 * slack);
    CHECK(distance(push.torque_on_second, (q - b.centre.position).cross(-force)) <= 512 * slack);
    const Real stretch = length - Real(0.5);
    CHECK(std::abs(between.potential_energy(state_of(a), state_of(b)) -
                   3 * stretch * stretch / 2) <= 512 * slack);
    const SpringToPoint<Real> to_point{.spring = spring, .anchor = q, .attachment = held_a};
    CHECK(std::abs(to_point.potential_energy(state_of(a)) - 3 * stretch * stretch / 2) <=
          512 * slack);
  }
}

TEST_CASE_TEMPLATE("A spring between bodies turns them where it is off either centre", Real,
                   EVERY_PRECISION) {
  const Vec3<Real> off(1, 0, 0), none = Vec3<Real>::Zero();
  const auto turns = [](const Vec3<Real>& first, const Vec3<Real>& second) {
    return SpringBetween<Real>{.attachment_first = first, .attachment_second = second}
        .gives_torque();
  };
  CHECK(turns(off, none));
  CHECK(turns(none, off));
  CHECK_FALSE(turns(none, none));
}

TEST_CASE_TEMPLATE("A tether pulls as soon as it is taut, however weakly, and stores what it takes",
                   Real, EVERY_PRECISION) {
  const Spring<Real> tether{.stiffness = 1, .rest_length = 1, .only_pulls = true};
  const auto along_x = [](Real x) { return Vec3<Real>(x, 0, 0); };
  const Vec3<Real> still = Vec3<Real>::Zero();
  CHECK(same_bits(spring_force<Real>(tether, along_x(Real(1.5)), still), along_x(Real(-0.5))));
  CHECK(same_bits(spring_force<Real>(tether, along_x(Real(0.5)), still), still));
  CHECK(spring_energy<Real>(tether, along_x(Real(1.5))) == Real(0.125));
  CHECK(spring_energy<Real>(tether, along_x(Real(0.5))) == 0);
  // Half a metre short of taut, and parting at 4 m/s: the damper has nothing to hold on to.
  const Spring<Real> slack{.stiffness = 1, .damping = 1, .rest_length = 1, .only_pulls = true};
  CHECK(same_bits(spring_force<Real>(slack, {Real(0.5), 0, 0}, {4, 0, 0}), Vec3<Real>(0, 0, 0)));
}

TEST_CASE_TEMPLATE("A body is whole only if each of its numbers is", Real, EVERY_PRECISION) {
  for (const Real bad : {nan_of<Real>, std::numeric_limits<Real>::infinity()}) {
    for (int axis = 0; axis < 3; ++axis) {
      Particle<Real> lost = make_particle<Real>(1), racing = lost;
      CHECK(is_whole(lost));
      lost.position[axis] = bad;
      racing.velocity[axis] = bad;
      CHECK_FALSE(is_whole(lost));
      CHECK_FALSE(is_whole(racing));
      Top<Real> turned, spun;
      CHECK(is_whole(turned));
      turned.orientation.imaginary[axis] = bad;
      spun.angular_momentum_body[axis] = bad;
      CHECK_FALSE(is_whole(turned));
      CHECK_FALSE(is_whole(spun));
    }
    Top<Real> top;
    top.orientation.real = bad;
    CHECK_FALSE(is_whole(top));
  }
  Top<Real> half_turn;
  half_turn.orientation = {.real = 0, .imaginary = {1, 0, 0}};
  CHECK(is_whole(half_turn));
}

TEST_CASE_TEMPLATE("The turn that was too far is told as |ω| h", Real, EVERY_PRECISION) {
  Top<Real> top;
  top.inverse_moments = {1, 1, 1};
  top.angular_momentum_body = {3, 4, 12};
  CHECK(turn_too_far<Real>(top, Real(0.5)).find("6.5 rad in this step") == 0);
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
  const SpringLimit<Real> limit = world.spring_limit();
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
  CHECK(limit.entry == 0);
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
    world.add(SpringBetween<Real>{.spring = {.stiffness = 1},
                                  .attachment_first = {0, arm_first, 0},
                                  .attachment_second = {0, arm_second, 0}},
              {a, b});
    return world.spring_limit().time_step;
  };
  for (const auto& [first, second] : {std::pair<Real, Real>(1, 2), std::pair<Real, Real>(2, 0)}) {
    const Real sum = 1 + Real(2.5) * first * first + 1 + Real(2.5) * second * second;
    const Real expected = largest_stable_time_step<Real>(sum, 0, 1);
    CHECK(std::abs(limit(first, second) - expected) <= 32 * unit_roundoff<Real> * expected);
  }
}

TEST_CASE_TEMPLATE(
    "What is not said of an effect is nothing, but for water, the Earth and air at rest", Real,
    EVERY_PRECISION) {
  CHECK(Buoyancy<Real>{}.density == 1000);
  CHECK(Buoyancy<Real>{}.surface == 0);
  CHECK(Buoyancy<Real>{}.gravity == Real(9.81));
  CHECK(same_bits(Gravity<Real>{}.gravity, Vec3<Real>(0, 0, Real(-9.81))));
  CHECK(PointGravity<Real>{}.strength == 0);
  CHECK(Spring<Real>{}.rest_length == 0);
  CHECK(same_bits(Magnus<Real>{}.wind, Vec3<Real>(0, 0, 0)));
}

TEST_CASE_TEMPLATE("Why an effect is skipped can be asked of the effect itself", Real,
                   EVERY_PRECISION) {
  CHECK(why_skipped<Real>(Gravity<Real>{}, Facts{}).empty());
  CHECK(why_skipped<Real>(Gravity<Real>{}, Facts{.is_static = true, .can_turn = true}) ==
        "nothing can move them");
  CHECK(why_skipped<Real>(Gravity<Real>{{0, 0, 0}}, Facts{}) == "gravity is zero");
}

TEST_CASE_TEMPLATE("The arm at either end counts for the body at that end", Real, EVERY_PRECISION) {
  RigidBody<Real> light = still_body<Real>({4, 4, 4}), heavy = still_body<Real>({0, 0, 0});
  for (const bool at_first : {true, false}) {
    World<Real> world;
    const BodyHandle one = world.add("one", light), other = world.add("other", heavy);
    SpringBetween<Real> spring{.spring = {.stiffness = 1}};
    (at_first ? spring.attachment_first : spring.attachment_second) = {1, 0, 0};
    world.add(spring, at_first ? std::vector{one, other} : std::vector{other, one});
    // 1/m + arm²/I is 1 + 4 at the one end and 1 at the other.
    CHECK(std::abs(world.spring_limit().time_step - 2 / std::sqrt(Real(6))) <=
          8 * unit_roundoff<Real>);
  }
}
