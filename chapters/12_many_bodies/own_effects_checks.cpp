// Effects that somebody wrote for one body, without a word about packs.
#include <mutex>
#include <set>
#include <support/beside_one_by_one.hpp>
#include <thread>

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
  Vec3<Real> velocity(const Particle<Real>& centre, const StepTime<Real>& moment) const {
    return fuse(moment.time) * Real(0.99) * centre.velocity +
           moment.time_step * Vec3<Real>(centre.position.y(), 0, 0);
  }
};

template <class Real, Phase when>
struct OwnSpin {
  static constexpr std::string_view name = "own spin";
  static constexpr Phase phase = when;
  Fuse<Real> fuse;
  Vec3<Real> angular_momentum_body(const Top<Real>& top, const StepTime<Real>& moment) const {
    return fuse(moment.time) * Real(0.99) * top.angular_momentum_body;
  }
};

template <class Real, class Seen>
struct OwnOrientation {
  static constexpr std::string_view name = "own orientation";
  static constexpr Phase phase = Phase::drift;
  Fuse<Real> fuse;
  Quaternion<Real> orientation(const Seen& seen, const StepTime<Real>& moment) const {
    Quaternion<Real> turn = quaternion_about<Real>({1, 0, 0}, (1 + moment.time) / 16);
    turn.real *= fuse(moment.time) / fuse(moment.time);  // 1, or NaN
    if constexpr (std::is_same_v<Seen, Top<Real>>)
      return seen.orientation * turn;
    else
      return seen.top.orientation * turn;
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
  PairImpulse<Real> blow(const BodyState<Real>& first, const BodyState<Real>& second,
                         const StepTime<Real>& moment) const {
    const Vec3<Real> way = second.centre.velocity - first.centre.velocity;
    return {.impulse_on_first = fuse(moment.time) * way / 8,
            .angular_impulse_on_first = way / 16,
            .angular_impulse_on_second = -way / 32};
  }
};

/// Two in three of seventy bodies of all kinds, or all that have a top, with the effect and
/// gravity, until the fuse burns out after 80 steps. @return whether a step failed
template <class Real, class Effect>
bool is_same_until_burnt_out(Effect effect) {
  effect.fuse.burnt_at = Real(80) / 60;
  const auto made = [&]<class AnyWorld>(AnyWorld world) {
    RandomGenerator dice(29);
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
    packed.use_threads(threads);
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
  CHECK(is_same_until_burnt_out<Real>(OwnOrientation<Real, Top<Real>>{}));
  CHECK(is_same_until_burnt_out<Real>(OwnOrientation<Real, BodyState<Real>>{}));
  CHECK(is_same_until_burnt_out<Real>(OwnAcceleration<Real>{}));
  CHECK(is_same_until_burnt_out<Real>(OwnTorque<Real>{}));
  CHECK(is_same_until_burnt_out<Real>(OwnForce<Real>{}));
  CHECK(is_same_until_burnt_out<Real>(OwnPush<Real>{}));
  CHECK(is_same_until_burnt_out<Real>(OwnPushBetween<Real>{}));
  CHECK(is_same_until_burnt_out<Real>(OwnBlowBetween<Real>{}));
}

namespace {

/// The threads on which an effect was run.
class Threads {
 public:
  void note() {
    const std::lock_guard lock(mutex_);
    seen_.insert(std::this_thread::get_id());
  }
  std::size_t count() const { return seen_.size(); }

 private:
  std::mutex mutex_;
  std::set<std::thread::id> seen_;
};

/// Effects that move nothing and note on which threads they are.
template <class Real>
struct WitnessOfCentre {
  static constexpr std::string_view name = "witness";
  std::shared_ptr<Threads> threads;
  Vec3<Real> force(const Particle<Real>&, Real) const {
    threads->note();
    return Vec3<Real>::Zero();
  }
};
template <class Real>
struct WitnessOfBody {
  static constexpr std::string_view name = "witness";
  std::shared_ptr<Threads> threads;
  Vec3<Real> force(const BodyState<Real>&, Real) const {
    threads->note();
    return Vec3<Real>::Zero();
  }
};
template <class Real>
struct WitnessOfPair {
  static constexpr std::string_view name = "witness";
  std::shared_ptr<Threads> threads;
  PairPush<Real> push(const BodyState<Real>&, const BodyState<Real>&, Real) const {
    threads->note();
    return {};
  }
};

/// On how many threads a step runs an effect on so many points, or on so many pairs of neighbours
/// among one more; 0 threads: nobody asked for a number.
template <class Witness, class Real>
std::size_t threads_of_step(int asked_for, std::size_t count) {
  const Witness witness{.threads = std::make_shared<Threads>()};
  ManyBodies<Real> world;
  std::vector<BodyHandle> points, joined;
  for (std::size_t n = 0; n <= count; ++n) {
    if (n == count && !EffectOnTwo<Witness, Real>) break;
    points.push_back(world.add("point " + std::to_string(n), make_particle<Real>(1)));
    if (n > 0) joined.insert(joined.end(), {points[n - 1], points[n]});
  }
  world.add(witness, EffectOnTwo<Witness, Real> ? joined : points);
  if (asked_for > 0) world.use_threads(asked_for);
  world.step();
  return witness.threads->count();
}

}  // namespace

TEST_CASE_TEMPLATE("As many threads as were asked for share a step that has enough work for each",
                   Real, EVERY_PRECISION) {
  const std::size_t bodies = InPacks<Real>::smallest_share,
                    pairs = OnBoth<Real, natural_width<Real>>::smallest_share_of_pairs;
  CHECK(threads_of_step<WitnessOfCentre<Real>, Real>(0, 2 * bodies) == 1);
  CHECK(threads_of_step<WitnessOfBody<Real>, Real>(0, 2 * pairs) == 1);
  CHECK(threads_of_step<WitnessOfPair<Real>, Real>(0, 2 * pairs) == 1);
  for (std::size_t threads = 1; threads <= 3; ++threads) {
    CAPTURE(threads);
    const int asked_for = static_cast<int>(threads);
    CHECK(threads_of_step<WitnessOfCentre<Real>, Real>(asked_for, threads * bodies) == threads);
    CHECK(threads_of_step<WitnessOfCentre<Real>, Real>(asked_for, threads * bodies - 1) == 1);
    CHECK(threads_of_step<WitnessOfBody<Real>, Real>(asked_for, threads * pairs) == threads);
    // The lanes that are left over in the last pack count too.
    CHECK(threads_of_step<WitnessOfBody<Real>, Real>(asked_for,
                                                     threads * pairs - natural_width<Real>) == 1);
    CHECK(threads_of_step<WitnessOfPair<Real>, Real>(asked_for, threads * pairs) == threads);
    CHECK(threads_of_step<WitnessOfPair<Real>, Real>(asked_for, threads * pairs - 1) == 1);
  }
}
