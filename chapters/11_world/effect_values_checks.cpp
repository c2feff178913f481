// What effects answer when they are asked alone: what they refuse, when they are not needed, and
// what energy they store.
#include <support/checks.hpp>
#include <support/random_world.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

template <class Real>
const Real nan_of = std::numeric_limits<Real>::quiet_NaN();

template <class Real>
RigidBody<Real> random_box(RandomGenerator& dice) {
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

TEST_CASE_TEMPLATE("A body that moves and turns needs every effect whose strength is not zero",
                   Real, EVERY_PRECISION) {
  const BodyFlags flags{.moves = true, .turns = true};
  const auto needed = [&](const auto& effect) { return effect.skip_reason(flags).empty(); };
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
    return SpringBetween<Real>{.spring = spring}.skip_reason().empty();
  };
  CHECK(joins({.stiffness = 1}));
  CHECK(joins({.damping = 1}));
  CHECK_FALSE(joins({}));
}

TEST_CASE_TEMPLATE("A spring between bodies pulls and damps as one to a point that moves along",
                   Real, EVERY_PRECISION) {
  RandomGenerator dice(17);
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

TEST_CASE_TEMPLATE("A body is whole only if each of its numbers is finite", Real, EVERY_PRECISION) {
  for (const Real bad : {nan_of<Real>, std::numeric_limits<Real>::infinity()}) {
    for (int axis = 0; axis < 3; ++axis) {
      Particle<Real> lost = make_particle<Real>(1), racing = lost;
      CHECK(is_finite(lost));
      lost.position[axis] = bad;
      racing.velocity[axis] = bad;
      CHECK_FALSE(is_finite(lost));
      CHECK_FALSE(is_finite(racing));
      Top<Real> turned, spun;
      CHECK(is_finite(turned));
      turned.orientation.imaginary[axis] = bad;
      spun.angular_momentum_body[axis] = bad;
      CHECK_FALSE(is_finite(turned));
      CHECK_FALSE(is_finite(spun));
    }
    Top<Real> top;
    top.orientation.real = bad;
    CHECK_FALSE(is_finite(top));
  }
  Top<Real> half_turn;
  half_turn.orientation = {.real = 0, .imaginary = {1, 0, 0}};
  CHECK(is_finite(half_turn));
}

TEST_CASE_TEMPLATE("The turn that was too far is told as |ω| h", Real, EVERY_PRECISION) {
  Top<Real> top;
  top.inverse_moments = {1, 1, 1};
  top.angular_momentum_body = {3, 4, 12};
  CHECK(turn_too_far<Real>(top, Real(0.5)).find("6.5 rad in this step") == 0);
}

TEST_CASE_TEMPLATE(
    "Values that an effect is not given are those of water, the Earth and still air, or zero", Real,
    EVERY_PRECISION) {
  CHECK(Buoyancy<Real>{}.density == 1000);
  CHECK(Buoyancy<Real>{}.surface == 0);
  CHECK(Buoyancy<Real>{}.gravity == Real(9.81));
  CHECK(same_bits(Gravity<Real>{}.gravity, Vec3<Real>(0, 0, Real(-9.81))));
  CHECK(PointGravity<Real>{}.strength == 0);
  CHECK(Spring<Real>{}.rest_length == 0);
  CHECK(same_bits(Magnus<Real>{}.wind, Vec3<Real>(0, 0, 0)));
}
