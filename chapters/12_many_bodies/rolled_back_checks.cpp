#include <support/beside_one_by_one.hpp>
#include <tumble/ledger.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

/// A wind of the user's own, who wrote it for one body and never heard of packs. From its hour on
/// it is infinite.
template <class Real>
struct Wind {
  static constexpr std::string_view name = "wind";
  Real hour = 0;  ///< s
  Vec3<Real> force(const Particle<Real>& centre, Real time) const {
    if (time >= hour) return {std::numeric_limits<Real>::infinity(), 0, 0};
    return {centre.position.y(), 0, std::sin(centre.position.x())};
  }
};

}  // namespace

TEST_CASE_TEMPLATE("A step in packs that fails is taken back to the bit, with the same error", Real,
                   EVERY_PRECISION) {
  // 1.5 s are 96 steps: one and a half times as many as can be repeated without another copy.
  RandomGenerator dice(5), same_dice(5);
  World<Real> plain(steps_per_second(64));
  World<Real, InPacks<Real>> packed(steps_per_second(64));
  for (int n = 0; n < 21; ++n) {
    add_random_body(plain, dice, "body " + std::to_string(n));
    add_random_body(packed, same_dice, "body " + std::to_string(n));
  }
  const BodyHandle last = plain.add("kite", make_particle<Real>(1, {1, 2, 3}));
  packed.add("kite", make_particle<Real>(1, {1, 2, 3}));
  plain.add(Wind<Real>{Real(1.5)}, {last});
  packed.add(Wind<Real>{Real(1.5)}, {packed.find("kite")});
  for (int n = 0; n < 96; ++n) {
    if (n == 50 || n == 70 || n == 95) {  // before the last copy, after it, and at the end
      plain.set_velocity(last, {Real(n), 0, 0});
      packed.set_velocity(packed.find("kite"), {Real(n), 0, 0});
    }
    plain.step();
    packed.step();
  }
  for (int again = 0; again < 2; ++again) {
    const std::string complaint = complaint_of_step([&] { plain.step(); });
    CHECK(complaint.find("wind gives a force of (inf, 0, 0) N") != std::string::npos);
    CHECK(complaint_of_step([&] { packed.step(); }) == complaint);
    CHECK(packed.ticks() == 96);
    CHECK(same_motion(plain.bodies(), packed.bodies()));
  }
}

TEST_CASE_TEMPLATE("In packs too a world goes back to its checkpoints, to the bit", Real,
                   EVERY_PRECISION) {
  RandomGenerator dice(6);
  World<Real, InPacks<Real>> world(steps_per_second(64));
  for (int n = 0; n < 40; ++n) add_random_body(world, dice, "body " + std::to_string(n));
  world.add(Gravity<Real>{}, {world.handle_at(3), world.handle_at(17)});
  world.checkpoint();
  for (int n = 0; n < 20; ++n) {
    CAPTURE(n);
    const BodyHandle one = world.handle_at(static_cast<BodyIndex>(dice.below(40)));
    world.set_position(one, dice.vector<Real>());
    world.step();
    const Checkpoint<Real> checkpoint = world.checkpoint();
    const Bodies<Real> there = world.bodies();
    for (int k = 0; k < 3; ++k) world.step();
    const Bodies<Real> later = world.bodies();
    world.set_velocity(world.handle_at(static_cast<BodyIndex>(dice.below(40))), {1, 0, 0});
    world.step();
    world.restore(checkpoint);
    REQUIRE(same_motion(there, world.bodies()));
    for (int k = 0; k < 3; ++k) world.step();
    REQUIRE(same_motion(later, world.bodies()));
  }
}

TEST_CASE_TEMPLATE("In packs too the step can be changed, to the bit", Real, EVERY_PRECISION) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    CAPTURE(seed);
    RandomGenerator dice(seed), same_dice(seed);
    World<Real> plain = random_world<Real>(dice, 40);
    ManyBodies<Real> packed = random_world<Real, InPacks<Real>>(same_dice, 40);
    for (const std::int64_t rate : {144, 30}) {
      plain.add(LinearDamping<Real>{.rate = 1});
      packed.add(LinearDamping<Real>{.rate = 1});
      plain.step();
      packed.step();
      plain.set_step_length(steps_per_second(rate));
      packed.set_step_length(steps_per_second(rate));
      const std::string complaint = complaint_of_step([&] { plain.step(); });
      REQUIRE(complaint_of_step([&] { packed.step(); }) == complaint);
      REQUIRE(same_motion(plain.bodies(), packed.bodies()));
    }
  }
}

TEST_CASE_TEMPLATE("In packs too a copy is a way back over bodies and effects that come and go",
                   Real, EVERY_PRECISION) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    CAPTURE(seed);
    RandomGenerator dice(seed);
    ManyBodies<Real> world = random_world<Real, InPacks<Real>>(dice, 40);
    world.use_threads(1 + static_cast<int>(seed % 2));
    world.step();
    const ManyBodies<Real> then = world;
    ManyBodies<Real> untouched = world;
    for (int n = 0; n < 20; ++n) {
      meddle(world, dice, n);
      (void)complaint_of_step([&] { world.step(); });
    }
    world = then;
    REQUIRE(world.handles() == untouched.handles());
    for (int n = 0; n < 10; ++n) {
      world.step();
      untouched.step();
      REQUIRE(same_motion(world.bodies(), untouched.bodies()));
    }
  }
}

TEST_CASE_TEMPLATE("A step in packs that fails turns back tops that tumble in packs of their own",
                   Real, EVERY_PRECISION) {
  World<Real, InPacks<Real>> world(steps_per_second(64));
  const MassProperties<Real> brick = mass_properties(Box<Real>{{1, 2, 3}}, 6);
  for (int n = 0; n < 21; ++n)
    world.add("brick " + std::to_string(n),
              make_rigid_body<Real>("brick", brick, {}, {0, 0, 1}, {1, Real(n + 1) / 4, 2}).body);
  world.add(Wind<Real>{0}, {world.add("kite", make_particle<Real>(1, {1, 2, 3}))});
  const Bodies<Real> before = world.bodies();
  CHECK(complaint_of_step([&] { world.step(); }).find("wind gives a force") != std::string::npos);
  CHECK(same_motion(before, world.bodies()));
}

namespace {

/// A spin that is no number.
template <class Real>
struct Jerk {
  static constexpr std::string_view name = "jerk";
  static constexpr Phase phase = Phase::kick;
  Vec3<Real> angular_momentum_body(const Top<Real>&, const StepTime<Real>&) const {
    return {0, std::numeric_limits<Real>::quiet_NaN(), 0};
  }
};

}  // namespace

TEST_CASE_TEMPLATE("A single top that is lost stops the step, in a pack of its own or among others",
                   Real, EVERY_PRECISION) {
  const MassProperties<Real> ball = mass_properties(Sphere<Real>{1}, 6),
                             brick = mass_properties(Box<Real>{{1, 2, 3}}, 6);
  for (const bool tumbles : {false, true})
    for (const int lost : {0, 20}) {
      CAPTURE(tumbles);
      CAPTURE(lost);
      ManyBodies<Real> world(steps_per_second(64));
      for (int n = 0; n < 21; ++n) {
        const std::string name = "body " + std::to_string(n);
        world.add(name, make_rigid_body<Real>(name, tumbles ? brick : ball, {{Real(n), 0, 0}},
                                              {0, 0, 1}, {1, Real(n + 1) / 4, 2})
                            .body);
      }
      const std::string name = "body " + std::to_string(lost);
      world.add(Jerk<Real>{}, {world.find(name)});
      const Bodies<Real> before = world.bodies();
      CHECK(complaint_of_step([&] {
              world.step();
            }).find("'" + name + "' at 0 s (step 0): jerk gives") == 0);
      CHECK(same_motion(before, world.bodies()));
    }
}

TEST_CASE_TEMPLATE("The books of a world in packs are those of one body after another", Real,
                   EVERY_PRECISION) {
  RandomGenerator dice(77), same_dice(77);
  World<Real> plain = random_world<Real>(dice, 40);
  auto packed = random_world<Real, InPacks<Real>>(same_dice, 40);
  Ledger<Real> books(plain), packed_books(packed);
  for (int n = 0; n < 10; ++n) {
    books.step(plain);
    packed_books.step(packed);
  }
  CHECK(same_motion(plain.bodies(), packed.bodies()));
  CHECK(table_of(books, plain) == table_of(packed_books, packed));
}

namespace {

/// Effects of the user's own that refuse, each at what it sees.
template <class Real, Phase when>
struct RefusalOfCentre {
  static constexpr std::string_view name = "refusal";
  static constexpr Phase phase = when;
  Vec3<Real> velocity(const Particle<Real>&, const StepTime<Real>&) const {
    throw std::domain_error("off the map");
  }
};
template <class Real, Phase when>
struct RefusalOfTop {
  static constexpr std::string_view name = "refusal";
  static constexpr Phase phase = when;
  Vec3<Real> angular_momentum_body(const Top<Real>&, const StepTime<Real>&) const {
    throw std::domain_error("off the map");
  }
};
template <class Real, Phase when>
struct RefusalOfBody {
  static constexpr std::string_view name = "refusal";
  static constexpr Phase phase = when;
  Vec3<Real> velocity(const BodyState<Real>&, const StepTime<Real>&) const {
    throw std::domain_error("off the map");
  }
};

}  // namespace

TEST_CASE_TEMPLATE("What an effect throws comes through packs and threads, and nothing moves", Real,
                   EVERY_PRECISION) {
  ManyBodies<Real> world(steps_per_second(64));
  const MassProperties<Real> ball = mass_properties(Sphere<Real>{1}, 6),
                             brick = mass_properties(Box<Real>{{1, 2, 3}}, 6);
  // Blocks of points, balls and bricks for two threads.
  constexpr int count = 4 * static_cast<int>(InPacks<Real>::smallest_share);
  for (int n = 0; n < count; ++n) {
    const std::string name = "body " + std::to_string(n);
    if (n % 3 == 0)
      world.add(name, make_particle<Real>(1, {Real(n), 0, 0}, {0, 1, 0}));
    else
      world.add(name, make_rigid_body<Real>(name, n % 3 == 1 ? brick : ball, {{Real(n), 0, 0}},
                                            {0, 0, 1}, {1, 1, Real(n % 7)})
                          .body);
  }
  world.add(Gravity<Real>{.gravity = {0, 0, -8}});
  const BodyHandle middle = world.find("body " + std::to_string(count / 2));
  const auto refused = [&](const auto& refusal) {
    world.step();  // what is remembered of it is no longer where the bodies are
    World twin = world;
    const EffectHandle effect = world.add(refusal, {middle});
    CHECK_THROWS_WITH_AS(world.step(), "off the map", std::domain_error);
    CHECK(world.ticks() == twin.ticks());
    CHECK(same_motion(world.bodies(), twin.bodies()));
    world.remove(effect);
    world.step();
    twin.step();
    CHECK(same_motion(world.bodies(), twin.bodies()));
  };
  for (const int threads : {1, 2}) {
    CAPTURE(threads);
    world.use_threads(threads);
    refused(RefusalOfCentre<Real, Phase::kick>{});
    refused(RefusalOfCentre<Real, Phase::drift>{});
    refused(RefusalOfTop<Real, Phase::kick>{});
    refused(RefusalOfTop<Real, Phase::drift>{});
    refused(RefusalOfBody<Real, Phase::kick>{});
    refused(RefusalOfBody<Real, Phase::drift>{});
  }
}

namespace {

/// Refuses every point, each by its place.
template <class Real>
struct RefusalByPlace {
  static constexpr std::string_view name = "refusal";
  static constexpr Phase phase = Phase::kick;
  Vec3<Real> velocity(const Particle<Real>& centre, const StepTime<Real>&) const {
    throw std::domain_error("refused at " + std::to_string(centre.position.x()) + " m");
  }
};

}  // namespace

TEST_CASE_TEMPLATE("Of all that effects throw in a step of one thread the first is reported", Real,
                   EVERY_PRECISION) {
  const auto refused = []<class AnyWorld>(AnyWorld world) {
    const int three_blocks =
        3 * Schedule<Real, natural_width<Real>>::packs_in_block * natural_width<Real>;
    for (int n = 0; n < three_blocks; ++n)
      world.add("point " + std::to_string(n), make_particle<Real>(1, {Real(n + 1), 0, 0}));
    world.add(RefusalByPlace<Real>{});
    CHECK_THROWS_WITH_AS(world.step(), "refused at 1.000000 m", std::domain_error);
  };
  refused(World<Real>());
  refused(ManyBodies<Real>());
}
