// In which order a step in packs does its work, and what each part of it is called.
#include <map>
#include <support/beside_one_by_one.hpp>
#include <support/conveyor.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

/// Turns a velocity a little about an axis: to do so about one axis and then about another is not
/// to do so in the other order.
template <class Real, Phase when, int axis>
struct Swirl {
  static constexpr std::string_view name = "swirl";
  static constexpr Phase phase = when;
  Vec3<Real> velocity(const Particle<Real>& centre, const StepTime<Real>&) const {
    return centre.velocity + Vec3<Real>::Unit(axis).cross(centre.velocity) / 8;
  }
};

template <class Real, Phase when, int axis>
struct SwirlOfSpin {
  static constexpr std::string_view name = "swirl of the spin";
  static constexpr Phase phase = when;
  Vec3<Real> angular_momentum_body(const Top<Real>& top, const StepTime<Real>&) const {
    return top.angular_momentum_body + Vec3<Real>::Unit(axis).cross(top.angular_momentum_body) / 8;
  }
};

/// Rotors about an axis, which two by two do not commute either.
template <class Real, int axis>
struct Wheels {
  static constexpr std::string_view name = "wheels";
  Vec3<Real> rotor_angular_momentum_body(Real time) const {
    return Vec3<Real>::Unit(axis) * (1 + time) / 16;
  }
};

/// Finds those that are near each other now.
template <class Real>
struct Neighbours {
  void find_pairs(const Bodies<Real>& bodies, std::vector<BodyPair>& pairs) const {
    for (BodyIndex a = 0; a < bodies.centres.size(); ++a)
      for (BodyIndex b = a + 1; b < bodies.centres.size(); ++b)
        if ((bodies.centres[a].position - bodies.centres[b].position).squaredNorm() < 4)
          pairs.push_back({a, b});
  }
};

/// They take a part of what they have against each other.
template <class Real>
struct Rubbing : Neighbours<Real> {
  static constexpr std::string_view name = "rubbing";
  PairImpulse<Real> blow(const BodyState<Real>& first, const BodyState<Real>& second,
                         const StepTime<Real>&) const {
    return {.impulse_on_first = (second.centre.velocity - first.centre.velocity) / 8,
            .angular_impulse_on_first = {0, Real(0.125), 0},
            .angular_impulse_on_second = {0, 0, Real(0.125)}};
  }
};

/// They draw each other nearer.
template <class Real>
struct Clinging : Neighbours<Real> {
  static constexpr std::string_view name = "clinging";
  PairPush<Real> push(const BodyState<Real>& first, const BodyState<Real>& second, Real) const {
    return {.force_on_first = second.centre.position - first.centre.position};
  }
};

/// Seventy bodies of all kinds under gravity, and what `add_more` adds.
template <class AnyWorld, class AddMore>
AnyWorld crowd(AnyWorld world, const AddMore& add_more) {
  using Real = decltype(world.time_step());
  RandomGenerator dice(41);
  for (int n = 0; n < 70; ++n) add_random_body(world, dice, "body " + std::to_string(n));
  world.add(Gravity<Real>{});
  add_more(world);
  return world;
}

/// Steps both kinds of world, and lets `meddle` change each before every step.
template <class Real, class AddMore, class Meddle>
void compare(const AddMore& add_more, const Meddle& meddle,
             Scheme scheme = Scheme::semi_implicit_euler, int threads = 1) {
  auto plain = crowd(World<Real>(steps_per_second(60)), add_more);
  auto packed = crowd(ManyBodies<Real>(steps_per_second(60)), add_more);
  plain.step_by(scheme);
  packed.step_by(scheme);
  packed.use_threads(threads);
  for (int step = 0; step < 12; ++step) {
    meddle(plain, step);
    meddle(packed, step);
    plain.step();
    packed.step();
    REQUIRE(same_motion(plain.bodies(), packed.bodies()));
  }
}

constexpr auto nothing = [](auto&, int) {};

}  // namespace

TEST_CASE_TEMPLATE(
    "By each scheme, and with any number of threads, effects of all phases act on packs in the "
    "order in which they act one by one",
    Real, EVERY_PRECISION) {
  const auto add_more = [](auto& world) {
    world.add(Swirl<Real, Phase::drift, 0>{});
    world.add(Swirl<Real, Phase::damping, 1>{});
    world.add(Swirl<Real, Phase::impulse, 2>{});
    world.add(Swirl<Real, Phase::kick, 0>{});
    world.add(Swirl<Real, Phase::force, 1>{});
    std::vector<BodyHandle> tops;
    for (BodyIndex i = 0; i < world.body_count(); ++i)
      if (!world.is_point(world.handle_at(i))) tops.push_back(world.handle_at(i));
    world.add(SwirlOfSpin<Real, Phase::drift, 0>{}, tops);
    world.add(SwirlOfSpin<Real, Phase::damping, 1>{}, tops);
    world.add(SwirlOfSpin<Real, Phase::impulse, 2>{}, tops);
    world.add(SwirlOfSpin<Real, Phase::kick, 0>{}, tops);
    world.add(SwirlOfSpin<Real, Phase::force, 1>{}, tops);
    world.add(Wheels<Real, 0>{}, tops);
    world.add(Wheels<Real, 1>{}, tops);
    world.add_motion(Conveyor{});
  };
  const auto push = [](auto& world, int) {
    for (BodyIndex i = 0; i < world.body_count(); i += 3)
      world.push_at(world.handle_at(i), {1, 2, 3}, {0, 1, 0});
  };
  for (const Scheme scheme : {Scheme::semi_implicit_euler, Scheme::verlet, Scheme::suzuki})
    for (const int threads : {1, 2, 3}) {
      CAPTURE(name_of(scheme));
      CAPTURE(threads);
      compare<Real>(add_more, push, scheme, threads);
    }
}

TEST_CASE_TEMPLATE("An effect that finds its pairs finds them in packs too", Real,
                   EVERY_PRECISION) {
  compare<Real>([](auto& world) { world.add(Rubbing<Real>{}); }, nothing);
  compare<Real>([](auto& world) { world.add(Clinging<Real>{}); }, nothing,
                Scheme::semi_implicit_euler, 2);
}

TEST_CASE_TEMPLATE("Pushes of one step alone move packs as one by one, and no step longer", Real,
                   EVERY_PRECISION) {
  compare<Real>(
      [](auto& world) {
        world.add(
            SpringBetween<Real>{.spring = {.stiffness = 3, .rest_length = 1}},
            {world.handle_at(1), world.handle_at(2), world.handle_at(50), world.handle_at(7)});
      },
      [](auto& world, int step) {
        if (step % 3 != 1) return;
        for (BodyIndex i = static_cast<BodyIndex>(step); i < world.body_count(); i += 5) {
          const Real some = Real(i) / 16;
          world.push_at(world.handle_at(i), {some, 2, -some}, {1, some, some});
          world.push_at(world.handle_at(i), {0, some, 1}, {some, 0, 1});
        }
      });
}

TEST_CASE_TEMPLATE("A push in packs that is given before a step that fails is given in the next",
                   Real, EVERY_PRECISION) {
  ManyBodies<Real> world(steps_per_second(1));
  const BodyHandle ball = world.add("ball", make_particle<Real>(1));
  const MassProperties<Real> sphere = mass_properties(Sphere<Real>{1}, 1);
  const BodyHandle top = world.add("top", make_rigid_body<Real>("top", sphere, {{4, 0, 0}}).body);
  const EffectHandle rope = world.add(PointGravity<Real>{.strength = 1});  // where the ball is
  world.push_at(ball, {3, 0, 0}, {0, 0, 0});
  world.push_at(top, {0, 0, 2}, {4, 1, 0});
  CHECK_THROWS_AS(world.step(), SimulationError);
  CHECK(same_bits(world.body(ball).centre.force, Vec3<Real>(0, 0, 0)));
  CHECK(same_bits(world.body(top).top.torque, Vec3<Real>(0, 0, 0)));
  world.remove(rope);
  world.step();
  world.step();
  CHECK(same_bits(world.velocity(ball), Vec3<Real>(3, 0, 0)));
  CHECK(same_bits(world.velocity(top), Vec3<Real>(0, 0, 2)));
  CHECK(same_bits(world.body(top).top.angular_momentum_body, Vec3<Real>(2, 0, 0)));
}

TEST_CASE_TEMPLATE(
    "The parts of a step in packs are named, counted and, one after another, the step", Real,
    EVERY_PRECISION) {
  auto world = crowd(ManyBodies<Real>(steps_per_second(60)), [](auto& made) {
    made.add(LinearDamping<Real>{.rate = 1}, {made.handle_at(0)});
    made.add(Magnus<Real>{.strength = 1});
  });
  world.push_at(world.handle_at(0), {1, 2, 3}, {0, 1, 0});
  auto in_parts = world;
  const StepPlan<Real>& plan = in_parts.step_plan();
  const auto parts = in_parts.backend().parts(plan);
  const StepTime<Real> moment = in_parts.step_time();
  std::map<std::string, std::size_t> bodies;
  for (std::size_t part = 0; part < parts.size(); ++part) {
    bodies[parts[part].name] += parts[part].bodies;
    in_parts.backend().run_part(plan, part, moment);
  }
  CHECK(parts.front().name == "memory of centres");
  CHECK(parts.back().name == "guard of tops");
  world.step();
  CHECK(same_motion(world.bodies(), in_parts.bodies()));
  const auto visited = [&](std::size_t motion) { return plan.motions[motion].members.size(); };
  CHECK(bodies ==
        std::map<std::string, std::size_t>{{"memory of centres", plan.moving.size()},
                                           {"memory of tops", plan.turning.size()},
                                           {"gravity", plan.effects[0].members.size()},
                                           {"Magnus force", plan.effects[2].members.size()},
                                           {"input", 1},
                                           {"kick", visited(0)},
                                           {"kick of the spin", visited(1)},
                                           {"linear damping", 1},
                                           {"drift", visited(2)},
                                           {"steady turning", visited(3)},
                                           {"tumbling: splitting", visited(4)},
                                           {"guard of centres", plan.moving.size()},
                                           {"guard of tops", plan.turning.size()}});
}

namespace {

/// A rule that takes one top at a time: no packs.
template <class Real>
struct Single {
  static constexpr std::string_view name = "single";
  void operator()(Top<Real>& top, Real time_step) const { turn_by_splitting(top, time_step); }
};

/// As many bricks as fill some packs and a part of one, all of which tumble and move.
template <class AnyWorld>
AnyWorld bricks(AnyWorld world) {
  using Real = decltype(world.time_step());
  const MassProperties<Real> brick = mass_properties(Box<Real>{{1, 2, 3}}, 6);
  for (int n = 0; n < 37; ++n)
    world.add("brick " + std::to_string(n),
              make_rigid_body<Real>("brick", brick, {}, {0, 0, 1}, {1, Real(n + 1) / 4, 2}).body);
  world.turn_by(Single<Real>{});
  return world;
}

}  // namespace

TEST_CASE_TEMPLATE("A rule that takes no packs turns their tops one by one", Real,
                   EVERY_PRECISION) {
  auto plain = bricks(World<Real>(steps_per_second(60)));
  auto packed = bricks(ManyBodies<Real>(steps_per_second(60)));
  const Bodies<Real> start = plain.bodies();
  for (int step = 0; step < 8; ++step) {
    plain.step();
    packed.step();
    REQUIRE(same_motion(plain.bodies(), packed.bodies()));
  }
  CHECK_FALSE(same_motion(start, plain.bodies()));
}

TEST_CASE_TEMPLATE("A world in packs can be stepped by reference, and a part of its step alone",
                   Real, EVERY_PRECISION) {
  auto plain = bricks(World<Real>(steps_per_second(60)));
  auto by_reference = bricks(ManyBodies<Real>(steps_per_second(60)));
  auto in_part = by_reference;
  const Bodies<Real> start = in_part.bodies();
  plain.step();
  by_reference.step_by_reference();
  CHECK(same_motion(plain.bodies(), by_reference.bodies()));
  const auto parts = in_part.backend().parts(in_part.step_plan());
  for (std::size_t part = 0; part < parts.size(); ++part)
    if (parts[part].name == "drift") {
      CHECK(parts[part].bodies == 37);
      in_part.backend().run_part(in_part.step_plan(), part, in_part.step_time());
    }
  for (BodyIndex i = 0; i < 37; ++i) {
    const RigidBody<Real> drifted = in_part.body(in_part.handle_at(i));
    CHECK(drifted.centre.position.z() == in_part.time_step());
    CHECK(same_bits(drifted.top.orientation.imaginary, start.tops[i].orientation.imaginary));
  }
}

TEST_CASE_TEMPLATE(
    "A body leaves a world in packs that was stepped by reference as it leaves others", Real,
    EVERY_PRECISION) {
  const auto left = []<class AnyWorld>(AnyWorld world) {
    world = bricks(std::move(world));
    world.step_by_reference();
    world.remove(world.handle_at(3));
    for (int step = 0; step < 4; ++step) world.step();
    return world.bodies();
  };
  const Bodies<Real> plain = left(World<Real>(steps_per_second(60))),
                     packed = left(ManyBodies<Real>(steps_per_second(60)));
  CHECK(plain.centres.size() == 36);
  CHECK(same_motion(plain, packed));
}

TEST_CASE_TEMPLATE("A body's numbers are those of its lane, and no reference into a copy is given",
                   Real, EVERY_PRECISION) {
  const auto packed = crowd(ManyBodies<Real>(), [](auto&) {});
  const auto has_state = [](const auto& world) {
    return requires {
      state_of(world.bodies(), 0);
    };
  };
  CHECK(has_state(World<Real>()));
  CHECK_FALSE(has_state(packed));
  const Bodies<Real> all = packed.bodies();
  for (const BodyHandle body : packed.handles()) {
    const BodyState<Real> state = state_of(all, packed.index_of(body));
    CHECK(same_bits(packed.position(body), state.centre.position));
    CHECK(same_bits(packed.velocity(body), state.centre.velocity));
    if (packed.is_point(body)) continue;
    CHECK(same_bits(packed.orientation(body).imaginary, state.top.orientation.imaginary));
    CHECK(same_bits(packed.angular_velocity(body), angular_velocity_world(state.top)));
  }
}

TEST_CASE_TEMPLATE("The number of threads is not changed inside a step", Real, EVERY_PRECISION) {
  ManyBodies<Real> world;
  world.add(make_particle<Real>(1));
  CHECK_THROWS_AS(world.step([&] { world.use_threads(2); }), std::logic_error);
  world.use_threads(2);
  world.step();
  CHECK(world.ticks() == 1);
}

TEST_CASE_TEMPLATE("A row of passes takes the blocks in which it has members, and no others", Real,
                   EVERY_PRECISION) {
  constexpr int width = 2;
  const std::uint32_t block = Schedule<Real, width>::packs_in_block;
  const std::vector<std::vector<WholePacks>> cases = {
      {{0, block}},
      {{0, block + 1}},
      {{block - 1, block + 1}},
      {{3, 4}, {3 * block, 5 * block}, {7 * block + 1, 7 * block + 2}},
      {{block * block + block - 1, block * block + 2 * block + 1}}};  // far from the first
  for (const std::vector<WholePacks>& runs : cases) {
    StepPlan<Real> plan;
    std::vector<std::uint32_t> expected;
    for (const WholePacks& run : runs)
      for (std::uint32_t pack = run.begin; pack < run.end; ++pack) {
        for (BodyIndex body = pack * width; body < (pack + 1) * width; ++body)
          plan.moving.insert(body);
        const std::uint32_t first = pack - pack % block;
        if (expected.empty() || expected.back() != first) expected.push_back(first);
      }
    const Schedule<Real, width> schedule(plan);
    REQUIRE(schedule.stages.size() == 1);
    CHECK(schedule.stages[0].on_centres.blocks == expected);
    CHECK(schedule.stages[0].on_tops.blocks.empty());
  }
}
