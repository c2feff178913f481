// What an effect of the user's own gives is what its bodies get, whatever it sees and gives.
#include <support/checks.hpp>
#include <support/on_path.hpp>
#include <tumble/gravity.hpp>
#include <tumble/ledger.hpp>
#include <tumble/springs.hpp>
#include <tumble/thruster.hpp>
#include <tumble/world.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

/// A body at `place` whose moments are 1 kg m² about each axis, but for those that are locked.
template <class Real>
RigidBody<Real> body_at(const Vec3<Real>& place, const Vec3<Real>& inverse_moments = {1, 1, 1}) {
  RigidBody<Real> body;
  body.centre = make_particle<Real>(1, place);
  body.top.inverse_moments = inverse_moments;
  return body;
}

struct Named {
  std::string name = "own";
};

template <class Real>
struct Elsewhere : Named {
  static constexpr Phase phase = Phase::drift;
  Vec3<Real> place;
  Vec3<Real> position(const Particle<Real>&, const StepTime<Real>&) const { return place; }
};
template <class Real>
struct Facing : Named {
  static constexpr Phase phase = Phase::drift;
  Quaternion<Real> facing;
  Quaternion<Real> orientation(const Top<Real>&, const StepTime<Real>&) const { return facing; }
};
/// The same, by a function that sees the body.
template <class Real>
struct FacingOfBody : Named {
  static constexpr Phase phase = Phase::drift;
  Quaternion<Real> facing;
  Quaternion<Real> orientation(const BodyState<Real>&, const StepTime<Real>&) const {
    return facing;
  }
};
template <class Real>
struct TorqueOnBody : Named {
  Vec3<Real> given;
  Vec3<Real> torque(const BodyState<Real>&, Real) const { return given; }
};
template <class Real>
struct SpinOfBody : Named {
  static constexpr Phase phase = Phase::kick;
  Vec3<Real> given;
  Vec3<Real> angular_momentum_body(const BodyState<Real>&, const StepTime<Real>&) const {
    return given;
  }
};

/// A blow on those that are less than 2 m apart.
template <class Real>
struct Touch : Named {
  PairImpulse<Real> blow(const BodyState<Real>&, const BodyState<Real>&,
                         const StepTime<Real>&) const {
    return {.impulse_on_first = {1, 2, 3},
            .angular_impulse_on_first = {4, 5, 6},
            .angular_impulse_on_second = {7, 8, 9}};
  }
  void find_pairs(const Bodies<Real>& bodies, std::vector<BodyPair>& pairs) const {
    for (BodyIndex b = 1; b < bodies.centres.size(); ++b)
      for (BodyIndex a = 0; a < b; ++a)
        if ((bodies.centres[a].position - bodies.centres[b].position).squaredNorm() < 4)
          pairs.push_back({a, b});
  }
};

/// A force that would be given when the sums have been used up, and a blow before the kick.
struct LateForce : Named {
  static constexpr Phase phase = Phase::damping;
  Vec3d force(const Particle<double>&, double) const { return {1, 0, 0}; }
};
struct EarlyBlow : Named {
  static constexpr Phase phase = Phase::force;
  PairImpulse<double> blow(const BodyState<double>&, const BodyState<double>&,
                           const StepTime<double>&) const {
    return {};
  }
};

/// A joint in which the place of the first body alone stores energy.
template <class Real>
struct OneSided : Named {
  PairPush<Real> push(const BodyState<Real>&, const BodyState<Real>&, Real) const { return {}; }
  Real potential_energy(const BodyState<Real>& first, const BodyState<Real>&) const {
    return first.centre.position.x();
  }
};

/// A force whose other members are each in a form that nobody asks for.
template <class Real>
struct Plain : Named {
  Vec3<Real> force(const Particle<Real>&, Real) const { return {1, 0, 0}; }
};
template <class Real>
struct OfACentre : Plain<Real> {
  Real potential_energy(const Particle<Real>&) const { return 2; }
};
/// An effect that has a number where the world asks for a function.
// NOLINTBEGIN(bugprone-macro-parentheses): a member's name can stand in none
#define TUMBLE_NUMBER(member)              \
  template <class Real>                    \
  struct NumberOf_##member : Plain<Real> { \
    int member = 0;                        \
  }
// NOLINTEND(bugprone-macro-parentheses)
TUMBLE_NUMBER(skip_reason);
TUMBLE_NUMBER(check);
TUMBLE_NUMBER(prepare);
TUMBLE_NUMBER(response);
TUMBLE_NUMBER(gives_torque);
TUMBLE_NUMBER(needs_top);
TUMBLE_NUMBER(needs_second_top);
TUMBLE_NUMBER(depends_on_speed);
TUMBLE_NUMBER(smoothness);
TUMBLE_NUMBER(find_pairs);
TUMBLE_NUMBER(broadcast);
#undef TUMBLE_NUMBER
template <class Real>
struct Misspelt : Plain<Real> {
  std::string_view why_skiped(const BodyFlags&) const { return "never"; }
};
template <class Real>
struct Heard : Plain<Real> {
  std::string_view skip_reason(const BodyFlags&) const { return ""; }
  Real potential_energy(const BodyState<Real>&) const { return 2; }
  bool depends_on_speed() const { return false; }
  int smoothness() const { return 1; }
};

}  // namespace

TEST_CASE(
    "A force, a torque or a blow can't name its phase, nor an effect that finds its pairs its "
    "bodies") {
  CHECK(!ActsInItsPhase<LateForce, double>);
  CHECK(!ActsInItsPhase<EarlyBlow, double>);
  CHECK(ActsInItsPhase<Elsewhere<double>, double>);
  CHECK(ActsInItsPhase<TorqueOnBody<double>, double>);
  CHECK(!EffectForSome<Touch<double>, double>);
  CHECK(EffectForSome<OneSided<double>, double>);
}

TEST_CASE_TEMPLATE("A place or an orientation that an effect gives is where the body is then", Real,
                   EVERY_PRECISION) {
  const Quaternion<Real> facing{.real = 0, .imaginary = {0, 1, 0}};
  World<Real> world(steps_per_second(1));
  const BodyHandle resting = world.add("resting", body_at<Real>({0, 0, 0}));
  const BodyHandle other = world.add("other", body_at<Real>({0, 0, 0}));
  world.add(Elsewhere<Real>{{}, {1, 2, 3}}, {resting});
  world.add(Facing<Real>{{}, facing}, {resting});
  world.add(FacingOfBody<Real>{{}, facing}, {other});
  world.step();
  CHECK(same_bits(world.position(resting), Vec3<Real>(1, 2, 3)));
  CHECK(same_bits(world.orientation(resting).imaginary, facing.imaginary));
  CHECK(same_bits(world.orientation(other).imaginary, facing.imaginary));
}

TEST_CASE_TEMPLATE("A step that fails takes back an orientation that an effect has given", Real,
                   EVERY_PRECISION) {
  for (const Vec3<Real>& inverse : {Vec3<Real>(1, 1, 1), Vec3<Real>(0, 0, 0)}) {
    World<Real> world(steps_per_second(1));
    const BodyHandle resting = world.add("resting", body_at<Real>({9, 0, 0}, inverse));
    world.add(Facing<Real>{{}, {.real = 0, .imaginary = {0, 1, 0}}}, {resting});
    world.add(PointGravity<Real>{.strength = 1}, {world.add("lost", make_particle<Real>(1))});
    CHECK_THROWS_AS(world.step(), SimulationError);
    CHECK(same_bits(world.orientation(resting).imaginary, Vec3<Real>(0, 0, 0)));
  }
}

TEST_CASE_TEMPLATE("An effect that sees the whole body can give it a torque or a spin", Real,
                   EVERY_PRECISION) {
  World<Real> world(steps_per_second(1));
  const BodyHandle torqued = world.add("torqued", body_at<Real>({0, 0, 0}));
  const BodyHandle spun = world.add("spun", body_at<Real>({0, 0, 0}, {1, 1, 0}));
  world.add(TorqueOnBody<Real>{{}, {0, 0, Real(0.5)}}, {torqued});
  world.add(SpinOfBody<Real>{{}, {1, 2, 3}}, {spun});
  world.step();
  CHECK(same_bits(world.body(torqued).top.angular_momentum_body, Vec3<Real>(0, 0, Real(0.5))));
  CHECK(same_bits(world.body(spun).top.angular_momentum_body, Vec3<Real>(1, 2, 0)));
}

TEST_CASE_TEMPLATE(
    "A body that is free to turn about one axis alone is turned about that one, whichever it is",
    Real, EVERY_PRECISION) {
  for (int axis = 0; axis < 3; ++axis) {
    CAPTURE(axis);
    World<Real> world(steps_per_second(1));
    const BodyHandle wheel = world.add("wheel", body_at<Real>({0, 0, 0}, Vec3<Real>::Unit(axis)));
    world.push_at(wheel, Vec3<Real>::Unit((axis + 2) % 3), Vec3<Real>::Unit((axis + 1) % 3));
    world.step();
    // The arm times the force: e₂ × e₃ is e₁, and so on around.
    CHECK(
        same_bits(world.body(wheel).top.angular_momentum_body, Vec3<Real>(Vec3<Real>::Unit(axis))));
  }
}

TEST_CASE_TEMPLATE(
    "A blow turns both bodies, and an effect that finds its own pairs acts on those alone", Real,
    EVERY_PRECISION) {
  World<Real> world(steps_per_second(1));
  const BodyHandle first = world.add("first", body_at<Real>({0, 0, 0}));
  const BodyHandle second = world.add("second", body_at<Real>({1, 0, 0}));
  const BodyHandle far = world.add("far", body_at<Real>({9, 0, 0}));
  world.add(Touch<Real>{});
  world.step();
  CHECK(same_bits(world.velocity(first), Vec3<Real>(1, 2, 3)));
  CHECK(same_bits(world.velocity(second), Vec3<Real>(-1, -2, -3)));
  CHECK(same_bits(world.body(first).top.angular_momentum_body, Vec3<Real>(4, 5, 6)));
  CHECK(same_bits(world.body(second).top.angular_momentum_body, Vec3<Real>(7, 8, 9)));
  CHECK(same_bits(world.velocity(far), Vec3<Real>(0, 0, 0)));
  CHECK(world.plan().rows[2].reason != "");
  for (const PlanRow& row : world.plan().rows)
    if (row.effect == "own") {
      CHECK(row.of == 3);
      CHECK(row.reason == "every body calls for it");
    }
}

TEST_CASE_TEMPLATE("The energy of a joint is asked with the first body first; others have none",
                   Real, EVERY_PRECISION) {
  World<Real> world;
  const BodyHandle first = world.add("first", make_particle<Real>(1, {3, 0, 0}));
  const BodyHandle second = world.add("second", make_particle<Real>(1, {5, 0, 0}));
  world.add(OneSided<Real>{}, {first, second});
  world.add(TorqueOnBody<Real>{});
  CHECK(stored_energy(world) == 3);
  const Particle<Real> centre = make_particle<Real>(1, {3, 0, 0});
  const Top<Real> top;
  const EffectOf<Real, TorqueOnBody<Real>> torque(TorqueOnBody<Real>{});
  CHECK(torque.potential_energy({centre, top}, {centre, top}) == 0);
}

TEST_CASE_TEMPLATE("A thruster for everyone pushes no point and leaves no torque on what is locked",
                   Real, EVERY_PRECISION) {
  World<Real> world(steps_per_second(1));
  const BodyHandle point = world.add("point", make_particle<Real>(1));
  const BodyHandle locked = world.add("locked", body_at<Real>({0, 0, 0}, {0, 0, 0}));
  world.add(Thruster<Real>{.force_body = {2, 0, 0}, .point = {0, 1, 0}});
  world.step();
  CHECK(same_bits(world.velocity(point), Vec3<Real>(0, 0, 0)));
  CHECK(same_bits(world.velocity(locked), Vec3<Real>(2, 0, 0)));
  CHECK(same_bits(world.body(locked).top.torque, Vec3<Real>(0, 0, 0)));
  CHECK(world.plan().rows[0].reason == "not 1: points have no orientation");
}

TEST_CASE_TEMPLATE("A body that is given the velocity towards a path is there after each step",
                   Real, float, double) {
  World<Real> world(steps_per_second(64));  // in 1/64 s no square of a time is rounded
  const BodyHandle lift = world.add("lift", make_particle<Real>(1, {0, 0, 0}));
  world.add(Gravity<Real>{});
  world.add(OnPath<Real>{}, {lift});
  for (int n = 0; n < 64; ++n) {
    world.step();
    const Vec3<Real> there(world.time() * world.time(), 0, 0);
    CHECK(same_bits(world.position(lift), there));
  }
}

TEST_CASE_TEMPLATE(
    "A member of an effect in another form, or with a common slip in its name, is refused", Real,
    float, double) {
  static_assert(HeardMembers<Real, Plain<Real>>::value);
  static_assert(HeardMembers<Real, Heard<Real>>::value);
  static_assert(HeardMembers<Real, SpringBetween<Real>>::value);
  CHECK_FALSE(IsHeard<Real, OfACentre<Real>>::potential_energy);
  CHECK_FALSE(IsHeard<Real, NumberOf_skip_reason<Real>>::skip_reason);
  CHECK_FALSE(IsHeard<Real, NumberOf_check<Real>>::check);
  CHECK_FALSE(IsHeard<Real, NumberOf_prepare<Real>>::prepare);
  CHECK_FALSE(IsHeard<Real, NumberOf_response<Real>>::response);
  CHECK_FALSE(IsHeard<Real, NumberOf_gives_torque<Real>>::gives_torque);
  CHECK_FALSE(IsHeard<Real, NumberOf_needs_top<Real>>::needs_top);
  CHECK_FALSE(IsHeard<Real, NumberOf_needs_second_top<Real>>::needs_second_top);
  CHECK_FALSE(IsHeard<Real, NumberOf_depends_on_speed<Real>>::depends_on_speed);
  CHECK_FALSE(IsHeard<Real, NumberOf_smoothness<Real>>::smoothness);
  CHECK_FALSE(IsHeard<Real, NumberOf_find_pairs<Real>>::find_pairs);
  CHECK_FALSE(IsHeard<Real, NumberOf_broadcast<Real>>::broadcast);
  CHECK_FALSE(IsHeard<Real, Misspelt<Real>>::others);
}
