// The plan against the step that knows nothing of the bodies and asks nobody.
#include <set>
#include <support/checks.hpp>
#include <support/complaint_of_step.hpp>
#include <support/exhaustive.hpp>
#include <support/random_world.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

// Effects of a user's own: one for each thing that can be given, and each thing that can be seen.

struct Named {
  static constexpr std::string_view name = "own";
};

template <class Real>
struct OwnForce : Named {
  Vec3<Real> force(const Particle<Real>& seen, Real time) const {
    return {seen.position.y(), time, -seen.velocity.x()};
  }
};
template <class Real>
struct OwnForceOfBody : Named {
  Vec3<Real> force(const BodyState<Real>& seen, Real) const {
    return rotate<Real>(seen.top.orientation, {1, 0, 0}) - seen.centre.velocity;
  }
};
template <class Real>
struct OwnTorque : Named {
  Vec3<Real> torque(const Top<Real>& seen, Real) const {
    return {seen.orientation.imaginary.x(), 1, 0};
  }
};
template <class Real>
struct OwnTorqueOfBody : Named {
  Vec3<Real> torque(const BodyState<Real>& seen, Real) const {
    return seen.centre.velocity.cross(angular_velocity_world(seen.top)) + Vec3<Real>(0, 0, 1);
  }
};
template <class Real>
struct OwnPush : Named {
  Push<Real> push(const BodyState<Real>& seen, Real) const {
    return {.force = -seen.centre.position, .torque = Vec3<Real>(0, 1, 0)};
  }
};
template <class Real>
struct OwnAcceleration : Named {
  Vec3<Real> acceleration(const Particle<Real>& seen, Real) const {
    return Vec3<Real>(0, 0, 2).cross(seen.velocity) + Vec3<Real>(1, 0, 0);
  }
};
template <class Real, Phase when>
struct OwnVelocity : Named {
  static constexpr Phase phase = when;
  Vec3<Real> velocity(const Particle<Real>& seen, const StepTime<Real>& moment) const {
    return seen.velocity + moment.time_step * Vec3<Real>(1, seen.position.x(), 0);
  }
};
template <class Real, Phase when>
struct OwnVelocityOfBody : Named {
  static constexpr Phase phase = when;
  Vec3<Real> velocity(const BodyState<Real>& seen, const StepTime<Real>& moment) const {
    return seen.centre.velocity + moment.time_step * rotate<Real>(seen.top.orientation, {0, 1, 0});
  }
};
template <class Real, Phase when>
struct OwnSpin : Named {
  static constexpr Phase phase = when;
  Vec3<Real> angular_momentum_body(const Top<Real>& seen, const StepTime<Real>& moment) const {
    return seen.angular_momentum_body + moment.time_step * Vec3<Real>(1, 2, 3);
  }
};
template <class Real, Phase when>
struct OwnPosition : Named {
  static constexpr Phase phase = when;
  Vec3<Real> position(const Particle<Real>& seen, const StepTime<Real>&) const {
    return {seen.position.x(), seen.position.y(), std::max(seen.position.z(), Real(0))};
  }
};
template <class Real, Phase when>
struct OwnOrientation : Named {
  static constexpr Phase phase = when;
  Quaternion<Real> orientation(const Top<Real>& seen, const StepTime<Real>&) const {
    return renormalized(seen.orientation *
                        quaternion_of_rotation_vector<Real>(Vec3<Real>(0, Real(0.01), 0)));
  }
};
template <class Real>
struct OwnPushBetween : Named {
  PairPush<Real> push(const BodyState<Real>& first, const BodyState<Real>& second, Real) const {
    const Vec3<Real> way = second.centre.position - first.centre.position;
    return {.force_on_first = way, .torque_on_first = way, .torque_on_second = -way};
  }
};
template <class Real>
struct OwnBlowBetween : Named {
  PairImpulse<Real> blow(const BodyState<Real>& first, const BodyState<Real>& second,
                         const StepTime<Real>&) const {
    const Vec3<Real> parting = first.centre.velocity - second.centre.velocity;
    return {.impulse_on_first = (Vec3<Real>(1, 0, 0) - parting) / 64,
            .angular_impulse_on_first = Vec3<Real>(0, 0, Real(0.125)),
            .angular_impulse_on_second = Vec3<Real>(0, Real(0.125), 0)};
  }
};
/// Blows between all bodies that are near each other now.
template <class Real>
struct OwnContact : OwnBlowBetween<Real> {
  void find_pairs(const Bodies<Real>& bodies, std::vector<BodyPair>& pairs) const {
    for (BodyIndex a = 0; a < bodies.centres.size(); ++a)
      for (BodyIndex b = a + 1; b < bodies.centres.size(); ++b)
        if ((bodies.centres[a].position - bodies.centres[b].position).squaredNorm() < 4)
          pairs.push_back({a, b});
  }
};

/// Steps both worlds side by side, the second exhaustively, and meddles with both alike.
template <class Real>
void step_side_by_side(World<Real>& planned, RandomGenerator dice, int steps, bool meddles) {
  settle(planned);
  World<Real> exhaustive = planned;
  RandomGenerator other_dice = dice;
  for (int n = 0; n < steps; ++n) {
    if (meddles && n % 3 == 2) {
      meddle(planned, dice, n);
      meddle(exhaustive, other_dice, n);
      settle(planned);
      settle(exhaustive);
    }
    const std::string complaint = complaint_of_step([&] { planned.step(); });
    REQUIRE(complaint_of_step([&] { exhaustive.step_exhaustively(); }) == complaint);
    REQUIRE(difference_in_value(planned.bodies(), exhaustive.bodies()) == "");
  }
}

/// Random worlds under an effect of the user's own, for all bodies or for some.
template <class Real, class Effect>
int try_own_effect(const Effect& effect) {
  int moved = 0;
  for (std::uint64_t seed = 1; seed <= 24; ++seed) {
    CAPTURE(seed);
    RandomGenerator dice(seed);
    World<Real> world(steps_per_second(60));
    std::vector<BodyHandle> bodies, with_tops;
    for (int n = 0; n < 7; ++n)
      bodies.push_back(add_random_body(world, dice, "body " + std::to_string(n)));
    // A flywheel on a fixed axle: it can't move, but it can turn.
    RigidBody<Real> flywheel =
        make_rigid_body<Real>("flywheel", mass_properties(Box<Real>{{1, 2, 3}}, 2)).body;
    flywheel.centre.inverse_mass = 0;
    bodies.push_back(world.add("flywheel", flywheel));
    for (const BodyHandle body : bodies)
      if (!world.is_point(body)) with_tops.push_back(body);
    if (seed % 2 == 0) add_random_effect(world, dice, bodies);
    const auto& chosen = form_of<Effect, Real>().sees == Sees::top ? with_tops : bodies;
    const bool for_everyone = FindsPairs<Effect, Real> || seed % 3 == 0;
    if constexpr (EffectForSome<Effect, Real> && EffectOnTwo<Effect, Real>) {
      for (std::size_t i = 1; i < bodies.size(); i += 2)
        world.add(effect, {bodies[i], bodies[i - 1], bodies[i], bodies[0]});
    } else if (for_everyone) {
      world.add(effect);
    } else if constexpr (EffectForSome<Effect, Real>) {
      world.add(effect, {chosen.back(), chosen[0]});
    }
    const Bodies<Real> start = world.bodies();
    step_side_by_side(world, dice, 12, seed % 4 == 0);
    moved += difference_in_value(start, world.bodies()).empty() ? 0 : 1;
  }
  return moved;
}

}  // namespace

TEST_CASE_TEMPLATE(
    "A thousand random worlds move by plan just as they do when nothing is known of any body", Real,
    EVERY_PRECISION) {
  std::set<std::string> kinds;
  for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
    CAPTURE(seed);
    RandomGenerator dice(seed);
    World<Real> world = random_world<Real>(dice);
    CHECK(world.body_count() >= 1);
    CHECK(world.body_count() <= 5);
    CHECK(world.effects().size() <= 10);
    for (const auto& effect : world.effects()) kinds.insert(std::string(effect.effect->name()));
    step_side_by_side(world, dice, 16, true);
  }
  CHECK(kinds.size() == 12);
}

TEST_CASE_TEMPLATE(
    "Effects of the user's own, whatever they see and give, move bodies by plan as when nothing is "
    "known of any",
    Real, EVERY_PRECISION) {
  CHECK(try_own_effect<Real>(OwnForce<Real>{}) > 12);
  CHECK(try_own_effect<Real>(OwnForceOfBody<Real>{}) > 12);
  CHECK(try_own_effect<Real>(OwnTorque<Real>{}) > 12);
  CHECK(try_own_effect<Real>(OwnTorqueOfBody<Real>{}) > 12);
  CHECK(try_own_effect<Real>(OwnPush<Real>{}) > 12);
  CHECK(try_own_effect<Real>(OwnAcceleration<Real>{}) > 12);
  CHECK(try_own_effect<Real>(OwnPushBetween<Real>{}) > 12);
  CHECK(try_own_effect<Real>(OwnBlowBetween<Real>{}) > 12);
  CHECK(try_own_effect<Real>(OwnContact<Real>{}) > 12);
}

TEST_CASE_TEMPLATE(
    "What an effect writes counts in every phase: velocity, spin, position and orientation", Real,
    EVERY_PRECISION) {
  const auto in_phase = [&]<Phase phase>(std::integral_constant<Phase, phase>) {
    CAPTURE(name_of(phase));
    CHECK(try_own_effect<Real>(OwnVelocity<Real, phase>{}) > 12);
    CHECK(try_own_effect<Real>(OwnVelocityOfBody<Real, phase>{}) > 12);
    CHECK(try_own_effect<Real>(OwnSpin<Real, phase>{}) > 12);
    CHECK(try_own_effect<Real>(OwnPosition<Real, phase>{}) > 12);
    CHECK(try_own_effect<Real>(OwnOrientation<Real, phase>{}) > 12);
  };
  in_phase(std::integral_constant<Phase, Phase::force>{});
  in_phase(std::integral_constant<Phase, Phase::kick>{});
  in_phase(std::integral_constant<Phase, Phase::impulse>{});
  in_phase(std::integral_constant<Phase, Phase::damping>{});
  in_phase(std::integral_constant<Phase, Phase::drift>{});
}
