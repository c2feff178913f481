// A world whose step changes, and worlds that go back.
#include <optional>
#include <support/box_body.hpp>
#include <support/checks.hpp>
#include <support/complaint_of_step.hpp>
#include <support/conveyor.hpp>
#include <support/random_world.hpp>
#include <support/size_of_line.hpp>
#include <tumble/drawing.hpp>
#include <tumble/snapshot_file.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

/// A wind that swings with the time.
template <class Real>
struct Swinging {
  static constexpr std::string_view name = "swinging wind";
  Vec3<Real> force(const Particle<Real>& centre, Real time) const {
    return {std::sin(9 * time), centre.position.x(), 0};
  }
};

/// Damps steps that are longer than 1/100 s, and leaves shorter ones alone.
template <class Real>
struct OfLongSteps {
  static constexpr std::string_view name = "of long steps";
  static constexpr Phase phase = Phase::damping;
  bool is_long = false;
  void prepare(Real time_step) { is_long = time_step > Real(0.01); }
  std::string_view skip_reason(const BodyFlags&) const { return is_long ? "" : "short steps"; }
  Vec3<Real> velocity(const Particle<Real>& centre, const StepTime<Real>&) const {
    return centre.velocity / 2;
  }
};

/// Asks its world for another step, in the midst of one.
template <class Real>
struct Meddler {
  static constexpr std::string_view name = "meddler";
  World<Real>* world;
  Vec3<Real> force(const Particle<Real>&, Real) const {
    world->set_step_length(steps_per_second(30));
    return {0, 0, 0};
  }
};

/// Keeps a copy of its world, made in the midst of a step.
template <class Real>
struct Copier {
  static constexpr std::string_view name = "copier";
  World<Real>* world;
  std::optional<World<Real>>* copy;
  Vec3<Real> force(const Particle<Real>&, Real) const {
    *copy = *world;
    return {0, 0, 0};
  }
};

/// A world of the step, with effects that depend on it and on the time.
template <class Real>
World<Real> windy_world(const StepLength& step, RandomGenerator dice) {
  World<Real> world(step);
  std::vector<BodyHandle> bodies;
  for (int n = 0; n < 6; ++n) {
    const BodyHandle body = add_random_body(world, dice, "body " + std::to_string(n));
    if (!world.is_point(body)) bodies.push_back(body);
  }
  bodies.push_back(world.add("box", box_body<Real>({1, 2, 3})));
  world.add(Swinging<Real>{});
  world.add(LinearDamping<Real>{.rate = 2});
  world.add(AngularDamping<Real>{.rate = 1}, bodies);
  for (int n = 0; n < 3; ++n) add_random_effect(world, dice, bodies);
  world.step_by(random_scheme(dice));
  return world;
}

}  // namespace

TEST_CASE_TEMPLATE("A world whose step was changed goes on as one made with that step, to the bit",
                   Real, EVERY_PRECISION) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    CAPTURE(seed);
    const RandomGenerator dice(seed);
    World<Real> changed = windy_world<Real>(steps_per_second(60), dice);
    for (int n = 0; n < 5; ++n) changed.step();
    changed.set_step_length(steps_per_second(144));
    World<Real> made = windy_world<Real>(steps_per_second(144), dice);
    made.restore(changed.save());
    CHECK(made.ticks() == 5);
    CHECK(table_of(made.plan()) == table_of(changed.plan()));
    const Bodies<Real> before = made.bodies();
    for (int n = 0; n < 20; ++n) {
      REQUIRE(same_number(made.time(), changed.time()));
      made.step();
      changed.step();
      REQUIRE(same_motion(made.bodies(), changed.bodies()));
    }
    CHECK_FALSE(same_motion(before, made.bodies()));
  }
}

TEST_CASE_TEMPLATE("Time goes on where the step changes, and back to where a snapshot was saved",
                   Real, EVERY_PRECISION) {
  World<Real> world(steps_per_second(64));  // all times here have few binary digits
  world.add("stone", make_particle<Real>(1, {0, 0, 0}, {1, 0, 0}));
  for (int n = 0; n < 3; ++n) world.step();
  const Snapshot<Real> saved = world.save();
  const Checkpoint<Real> checkpoint = world.checkpoint();
  for (int n = 0; n < 5; ++n) world.step();
  world.set_step_length(steps_per_second(4));
  CHECK(world.time() == Real(8) / 64);
  CHECK(world.time_step() == Real(0.25));
  CHECK(world.step_length().numerator == 250'000'000);
  world.step();
  CHECK(world.ticks() == 9);
  CHECK(world.time() == Real(8) / 64 + Real(0.25));
  CHECK(world.position(world.find("stone")).x() == world.time());
  const Snapshot<Real> later = world.save();
  std::stringstream file, old_file;
  write_snapshot(file, later);
  const Snapshot<Real> read = read_snapshot<Real>(file);
  world.set_step_length(steps_per_second(2));
  // The step stays the world's; the time is that of then.
  for (const bool by_checkpoint : {false, true}) {
    if (by_checkpoint)
      world.restore(checkpoint);
    else
      world.restore(saved);
    CHECK(world.ticks() == 3);
    CHECK(world.time() == Real(3) / 64);
    world.step();
    CHECK(world.time() == Real(3) / 64 + Real(0.5));
  }
  for (const Snapshot<Real>& then : {later, read}) {
    world.restore(then);
    CHECK(world.ticks() == 9);
    CHECK(world.time() == Real(8) / 64 + Real(0.25));
  }
  // To a world of the same step the snapshot's time is n h still, with the same roundings.
  World<Real> thirds(steps_per_second(3)), again(steps_per_second(3));
  for (int n = 0; n < 7; ++n) thirds.step();
  again.restore(thirds.save());
  CHECK(same_number(again.time(), 7 * thirds.time_step()));
}

TEST_CASE("A file of version 1, which knows no step, is of the world's") {
  const std::string text = "tumble snapshot 1, 64 bits, bodies 0, tops 0, ticks 6\n\n\n",
                    line = [&] {
                      std::ostringstream end;
                      end << "checksum " << std::hex << checksum_of(text) << '\n';
                      return end.str();
                    }();
  std::istringstream file(text + line);
  World<double> world(steps_per_second(2));
  world.restore(read_snapshot<double>(file));
  CHECK(world.ticks() == 6);
  CHECK(world.time() == 3);
  CHECK(world.step_length().denominator == 1);
}

TEST_CASE_TEMPLATE("A step that becomes too long for a spring is warned of before it is taken",
                   Real, EVERY_PRECISION) {
  World<Real> world(steps_per_second(64));
  const BodyHandle stone = world.add("stone", make_particle<Real>(1));
  world.add(SpringToPoint<Real>{.spring = {.stiffness = 400}}, {stone});  // 20 rad/s: up to 0.1 s
  std::vector<std::string> told;
  world.on_warning([&](const std::string& text) { told.push_back(text); });
  world.step();
  CHECK(told.empty());
  world.set_step_length(steps_per_second(8));
  CHECK(world.warnings().size() == 1);
  CHECK(world.plan().warnings.size() == 1);
  CHECK(told.empty());
  world.step();
  world.step();
  REQUIRE(told.size() == 1);
  CHECK(told[0] == world.warnings()[0]);
  CHECK(told[0].find("the time step is 0.125 s, and only up to 0.1 s") != std::string::npos);
  world.set_step_length(steps_per_second(16));
  world.step();
  CHECK(told.size() == 1);
  CHECK(world.plan().warnings.empty());
  // Whoever is warned may shorten the step, and the step that was warned of is never taken.
  world.on_warning([&](const std::string&) { world.set_step_length(steps_per_second(32)); });
  world.set_step_length(steps_per_second(2));
  const Real before = world.time();
  world.step();
  CHECK(world.time() == before + Real(1) / 32);
}

TEST_CASE_TEMPLATE("The plan is made anew where an effect's answer depends on the step", Real,
                   EVERY_PRECISION) {
  World<Real> world(steps_per_second(64));
  const BodyHandle stone = world.add("stone", make_particle<Real>(1, {0, 0, 0}, {1, 0, 0}));
  const EffectHandle effect = world.add(OfLongSteps<Real>{});
  world.step();
  CHECK(world.velocity(stone).x() == Real(0.5));
  world.set_step_length(steps_per_second(128));
  CHECK(world.plan().rows.back().reason != "every body calls for it");
  CHECK_FALSE(world.template effect<OfLongSteps<Real>>(effect).is_long);
  world.step();
  CHECK(world.velocity(stone).x() == Real(0.5));
  REQUIRE_FALSE(world.change_log().empty());
  CHECK(world.change_log().back() ==
        "step 1: of long steps visits 0 of 1, before 1 (a step of 0.0078125 s was chosen)");
}

TEST_CASE_TEMPLATE("A step that cannot be is refused, and so is any inside a step", Real,
                   EVERY_PRECISION) {
  World<Real> world(steps_per_second(64));
  world.add("stone", make_particle<Real>(1, {0, 0, 0}, {1, 0, 0}));
  world.step();
  const auto is_as_before = [&] {
    return world.time() == Real(1) / 64 && world.time_step() == Real(1) / 64 &&
           world.step_length().numerator == 15'625'000 && world.ticks() == 1;
  };
  CHECK(complaint_of([&] {
          world.set_step_length({-1, 1});
        }).find("numerator of the step is -1 ns") == 0);
  CHECK(complaint_of([&] {
          world.set_step_length({1, 0});
        }).find("denominator of the step is 0") == 0);
  CHECK(complaint_of([&] {
          world.set_step_length({3'600'000'000'001, 1});
        }).find("numerator of the step is 3600000000001 ns") == 0);
  CHECK(is_as_before());
  const EffectHandle meddler = world.add(Meddler<Real>{&world});
  CHECK_THROWS_WITH_AS(world.step(), "the time step can't be changed inside a step",
                       std::logic_error);
  CHECK_THROWS_AS(world.step_by_reference(), std::logic_error);
  CHECK_THROWS_AS(world.step_exhaustively(), std::logic_error);
  CHECK(is_as_before());
  world.remove(meddler);
  world.set_step_length({0, 1});  // nothing moves, and no time goes by
  world.step();
  CHECK(world.time() == Real(1) / 64);
  CHECK(world.position(world.find("stone")).x() == Real(1) / 64);
}

TEST_CASE_TEMPLATE("Nothing of a world can be changed inside a step", Real, EVERY_PRECISION) {
  World<Real> world(steps_per_second(64));
  const BodyHandle box = world.add("box", box_body<Real>({0, 0, 0}));
  const EffectHandle gravity = world.add(Gravity<Real>{});
  const Snapshot<Real> saved = world.save();
  const Checkpoint<Real> checkpoint = world.checkpoint();
  const std::vector<std::function<void()>> changes = {
      [&] { world.add("another", make_particle<Real>(1)); },
      [&] {
        world.add(box_body<Real>({1, 0, 0}));
      },
      [&] { world.remove(box); },
      [&] {
        world.replace(box, box_body<Real>({1, 0, 0}));
      },
      [&] {
        world.set_position(box, {1, 0, 0});
      },
      [&] {
        world.set_velocity(box, {1, 0, 0});
      },
      [&] { world.set_orientation(box, Quaternion<Real>{}); },
      [&] {
        world.set_angular_velocity(box, {1, 0, 0});
      },
      [&] {
        world.apply_impulse_at(box, {1, 0, 0}, {0, 0, 0});
      },
      [&] {
        world.push_at(box, {1, 0, 0}, {0, 0, 0});
      },
      [&] { world.add(Gravity<Real>{}); },
      [&] { world.add(Gravity<Real>{}, {box}); },
      [&] { world.remove(gravity); },
      [&] {
        world.change(gravity, Gravity<Real>{{1, 0, 0}});
      },
      [&] { world.turn_by(Steady{}); },
      [&] { world.step_by(Scheme::verlet); },
      [&] { world.add_motion(Conveyor{}); },
      [&] { world.set_step_length(steps_per_second(2)); },
      [&] { world.restore(saved); },
      [&] { world.restore(checkpoint); },
      [&] { (void)world.checkpoint(); },
      [&] { world.step(); },
      [&] { world.step_by_reference(); },
      [&] { world.step_exhaustively(); }};
  for (std::size_t n = 0; n < changes.size(); ++n) {
    CAPTURE(n);
    CHECK_THROWS_WITH_AS(world.step(changes[n]), doctest::Contains(" inside a step"),
                         std::logic_error);
  }
  CHECK(world.ticks() == 0);
  World<Real> untouched(steps_per_second(64));
  untouched.add("box", box_body<Real>({0, 0, 0}));
  untouched.add(Gravity<Real>{});
  world.step();
  untouched.step();
  CHECK(world.velocity(box) == untouched.bodies().centres[0].velocity);
  CHECK(world.position(box) == untouched.bodies().centres[0].position);
  CHECK(world.effects().size() == 1);
  CHECK(world.change_log().empty());
}

TEST_CASE_TEMPLATE("A copy that is made inside a step is not inside one, wherever it goes", Real,
                   EVERY_PRECISION) {
  World<Real> world(steps_per_second(64));
  world.add("stone", make_particle<Real>(1, {0, 0, 0}, {1, 0, 0}));
  std::optional<World<Real>> copy;
  const EffectHandle copier = world.add(Copier<Real>{&world, &copy});
  world.step();
  world.remove(copier);
  world.set_step_length(steps_per_second(32));
  REQUIRE(copy);
  copy->set_step_length(steps_per_second(16));
  world = *copy;
  world.set_step_length(steps_per_second(8));
  CHECK(world.time_step() == Real(0.125));
}

TEST_CASE_TEMPLATE("The books close, and the picture goes on, over a change of the step", Real,
                   EVERY_PRECISION) {
  // With these numbers nothing is rounded.
  World<Real> world(steps_per_second(64));
  const BodyHandle stone = world.add("stone", make_particle<Real>(1, {0, 0, 0}, {8, 0, 0}));
  world.add(Gravity<Real>{{0, 0, -8}});
  Ledger<Real> ledger(world);
  Drawing<Real> drawing;
  drawing.note(world);
  StepClock clock = make_step_clock(world.step_length());
  const auto frame = [&](std::int64_t nanoseconds) {
    for (std::int64_t due = steps_due(clock, nanoseconds); due > 0; --due) {
      ledger.step(world);
      drawing.note(world);
    }
    return drawing.pose(stone, fraction_of_step<Real>(clock)).position.x();
  };
  CHECK(frame(15'625'000 + 7'812'500) == Real(0.5) / 8);
  world.set_step_length(steps_per_second(128));
  clock = make_step_clock(world.step_length());
  CHECK(frame(7'812'500) == 8 * Real(1) / 64);
  CHECK(frame(3'906'250) == 8 * (Real(1) / 64 + Real(0.5) / 128));
  CHECK(world.time() == Real(1) / 64 + Real(1) / 128);
  CHECK(size_of(ledger.rest(world)) == 0);
}

TEST_CASE_TEMPLATE("Where a warning or an effect asks for another step, the books know", Real,
                   EVERY_PRECISION) {
  // With these numbers nothing is rounded.
  World<Real> world(steps_per_second(4));
  world.add("stone", make_particle<Real>(1, {1, 0, 0}));
  world.add(SpringToPoint<Real>{.spring = {.stiffness = 256}});  // 16 rad/s: up to an eighth
  world.on_warning([&](const std::string&) { world.set_step_length(steps_per_second(64)); });
  Ledger<Real> ledger(world);
  ledger.step(world);
  CHECK(world.time() == Real(1) / 64);
  CHECK(size_of(ledger.rest(world)) == 0);
  // What an effect asks for is refused before anything is booked or changed.
  world.add(Meddler<Real>{&world});
  CHECK_THROWS_AS(ledger.step(world), std::logic_error);
  CHECK(world.time_step() == Real(1) / 64);
  CHECK(world.ticks() == 1);
  CHECK(size_of(ledger.rest(world)) == 0);
}

TEST_CASE_TEMPLATE(
    "A copy is a way back over bodies and effects that have come and gone, to the bit", Real,
    EVERY_PRECISION) {
  int changed = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    CAPTURE(seed);
    RandomGenerator dice(seed);
    World<Real> world = random_world<Real>(dice, 8);
    for (int n = 0; n < 5; ++n) world.step();
    const World<Real> then = world;
    World<Real> untouched = world;
    const std::vector<BodyHandle> handles = world.handles();
    for (int n = 0; n < 30; ++n) {
      meddle(world, dice, n);
      (void)complaint_of_step([&] { world.step(); });
    }
    changed += world.handles() != handles;
    world = then;
    REQUIRE(world.handles() == handles);
    for (const BodyHandle body : handles) {
      CHECK(world.name_of(body) == untouched.name_of(body));
      CHECK(world.find(world.name_of(body)) == body);
    }
    CHECK(table_of(world.plan()) == table_of(untouched.plan()));
    for (std::size_t n = 0; n < world.effects().size(); ++n) {
      CHECK(world.effects()[n].handle == untouched.effects()[n].handle);
      CHECK(world.effects()[n].targets == untouched.effects()[n].targets);
    }
    for (int n = 0; n < 20; ++n) {
      world.step();
      untouched.step();
      REQUIRE(same_motion(world.bodies(), untouched.bodies()));
    }
  }
  CHECK(changed > 30);
}

TEST_CASE_TEMPLATE("What came after a copy was made is gone with it, and what went is there again",
                   Real, EVERY_PRECISION) {
  World<Real> world(steps_per_second(64));
  const BodyHandle ball = world.add("ball", box_body<Real>({0, 0, 0}));
  const BodyHandle target = world.add("target", box_body<Real>({5, 0, 0}));
  const EffectHandle weight = world.add(Gravity<Real>{}, {target});
  const World<Real> then = world;
  world.remove(target);  // and with it the effect, which was meant for nobody else
  const BodyHandle shot = world.add("shot", make_particle<Real>(1));
  CHECK_FALSE(world.contains(target));
  world = then;
  CHECK(world.find("target") == target);
  CHECK(world.template effect<Gravity<Real>>(weight).gravity.z() < 0);
  CHECK_FALSE(world.contains(shot));
  CHECK(world.contains(ball));
  world.remove(target);
  CHECK(world.add("shot", make_particle<Real>(1)) == shot);  // played again, it is the same
}
