// Effects that somebody wrote for one body, without a word about packs.
#include <support/beside_one_by_one.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

/// What the effects below grow by with time, so that none is asked for another moment unseen. From
/// `burnt_at` on (s) they give NaN.
template <class Real>
struct Fuse {
  Real burnt_at = std::numeric_limits<Real>::infinity();
  Real operator()(Real time) const {
    return time < burnt_at ? 1 + time / 16 : std::numeric_limits<Real>::quiet_NaN();
  }
};

template <class Real, Phase when>
struct OwnVelocity {
  static constexpr std::string_view name = "own velocity";
  static constexpr Phase phase = when;
  Fuse<Real> fuse;
  Vec3<Real> velocity(const Particle<Real>& centre, const Moment<Real>& moment) const {
    return fuse(moment.time) * Real(0.99) * centre.velocity +
           moment.time_step * Vec3<Real>(centre.position.y(), 0, 0);
  }
};

template <class Real, Phase when>
struct OwnSpin {
  static constexpr std::string_view name = "own spin";
  static constexpr Phase phase = when;
  Fuse<Real> fuse;
  Vec3<Real> angular_momentum_body(const Top<Real>& top, const Moment<Real>& moment) const {
    return fuse(moment.time) * Real(0.99) * top.angular_momentum_body;
  }
};

template <class Real>
struct OwnAcceleration {
  static constexpr std::string_view name = "own acceleration";
  Fuse<Real> fuse;
  Vec3<Real> acceleration(const Particle<Real>& centre, Real time) const {
    return fuse(time) * Vec3<Real>(0, 0, 2).cross(centre.velocity);
  }
};

template <class Real>
struct OwnTorque {
  static constexpr std::string_view name = "own torque";
  Fuse<Real> fuse;
  Vec3<Real> torque(const Top<Real>& top, Real time) const {
    return fuse(time) * Vec3<Real>(top.orientation.real, 1, 0);
  }
};

template <class Real>
struct OwnForce {
  static constexpr std::string_view name = "own force";
  Fuse<Real> fuse;
  Vec3<Real> force(const BodyState<Real>& body, Real time) const {
    return fuse(time) * (body.top.angular_momentum_body + body.centre.position);
  }
};

template <class Real>
struct OwnPush {
  static constexpr std::string_view name = "own push";
  Fuse<Real> fuse;
  Push<Real> push(const BodyState<Real>& body, Real time) const {
    return {.force = -fuse(time) * body.centre.position, .torque = body.centre.velocity};
  }
};

template <class Real>
struct OwnPushBetween {
  static constexpr std::string_view name = "own push between";
  Fuse<Real> fuse;
  PairPush<Real> push(const BodyState<Real>& first, const BodyState<Real>& second,
                      Real time) const {
    const Vec3<Real> way = second.centre.position - first.centre.position;
    return {.force_on_first = fuse(time) * way, .torque_on_first = way, .torque_on_second = -way};
  }
};

template <class Real>
struct OwnBlowBetween {
  static constexpr std::string_view name = "own blow between";
  Fuse<Real> fuse;
  PairBlow<Real> blow(const BodyState<Real>& first, const BodyState<Real>& second,
                      const Moment<Real>& moment) const {
    const Vec3<Real> way = second.centre.velocity - first.centre.velocity;
    return {.impulse_on_first = fuse(moment.time) * way / 8,
            .turn_on_first = way / 16,
            .turn_on_second = -way / 32};
  }
};

/// Two in three of seventy bodies of all kinds, or all that have a top, with the effect and
/// gravity, until the fuse burns out after 80 steps. @return whether a step failed
template <class Real, class Effect>
bool is_same_until_burnt_out(Effect effect) {
  effect.fuse.burnt_at = Real(80) / 60;
  const auto made = [&]<class AnyWorld>(AnyWorld world) {
    Dice dice(29);
    std::vector<BodyHandle> chosen;
    for (int n = 0; n < 70; ++n) {
      const BodyHandle body = add_random_body(world, dice, "body " + std::to_string(n));
      const bool fits =
          EffectOnTwo<Effect, Real> || EffectOf<Real, Effect>(effect).traits().needs_top
              ? world.body(body).top.inverse_moments.x() != 0
              : n % 3 != 0;
      if (fits) chosen.push_back(body);
    }
    if (EffectOnTwo<Effect, Real> && chosen.size() % 2 == 1) chosen.pop_back();
    world.add(effect, chosen);
    world.add(Gravity<Real>{});
    return world;
  };
  bool fails = true;
  constexpr auto euler = Scheme::semi_implicit_euler;
  for (const auto& [scheme, threads] :
       {std::pair(euler, 1), std::pair(euler, 2), std::pair(Scheme::verlet, 2),
        std::pair(Scheme::suzuki, 1)}) {
    World<Real> plain = made(World<Real>(steps_per_second(60)));
    auto packed = made(ManyBodies<Real>(steps_per_second(60)));
    plain.step_by(scheme);
    packed.step_by(scheme);
    packed.keeping().use_threads(threads);
    std::string complaint;
    for (int n = 0; n < 81 && complaint.empty(); ++n) {
      complaint = complaint_of_step([&] { plain.step(); });
      REQUIRE(complaint_of_step([&] { packed.step(); }) == complaint);
      REQUIRE(same_motion(plain.bodies(), packed.bodies()));
    }
    fails = fails && !complaint.empty();
  }
  return fails;
}

}  // namespace

//! [own_effects]
TEST_CASE_TEMPLATE(
    "Effects of the user's own, of every form and in every phase, move packs as one by one, and "
    "fail alike",
    Real, EVERY_PRECISION) {
  CHECK(is_same_until_burnt_out<Real>(OwnVelocity<Real, Phase::force>{}));
  CHECK(is_same_until_burnt_out<Real>(OwnVelocity<Real, Phase::kick>{}));
  CHECK(is_same_until_burnt_out<Real>(OwnVelocity<Real, Phase::impulse>{}));
  CHECK(is_same_until_burnt_out<Real>(OwnVelocity<Real, Phase::damping>{}));
  CHECK(is_same_until_burnt_out<Real>(OwnVelocity<Real, Phase::drift>{}));
  CHECK(is_same_until_burnt_out<Real>(OwnSpin<Real, Phase::force>{}));
  CHECK(is_same_until_burnt_out<Real>(OwnSpin<Real, Phase::kick>{}));
  CHECK(is_same_until_burnt_out<Real>(OwnSpin<Real, Phase::impulse>{}));
  CHECK(is_same_until_burnt_out<Real>(OwnSpin<Real, Phase::damping>{}));
  CHECK(is_same_until_burnt_out<Real>(OwnSpin<Real, Phase::drift>{}));
  CHECK(is_same_until_burnt_out<Real>(OwnAcceleration<Real>{}));
  CHECK(is_same_until_burnt_out<Real>(OwnTorque<Real>{}));
  CHECK(is_same_until_burnt_out<Real>(OwnForce<Real>{}));
  CHECK(is_same_until_burnt_out<Real>(OwnPush<Real>{}));
  CHECK(is_same_until_burnt_out<Real>(OwnPushBetween<Real>{}));
  CHECK(is_same_until_burnt_out<Real>(OwnBlowBetween<Real>{}));
}
//! [own_effects]
