// Saving a world's motion, and coming back to it.
#include <support/checks.hpp>
#include <support/random_world.hpp>
#include <tumble/snapshot_file.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

template <class Real>
std::string complaint_of_reading(const std::string& text) {
  std::istringstream in(text);
  try {
    read_snapshot<Real>(in);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "nothing thrown";
}

/// Puts a body to a place, and leaves its velocity alone.
template <class Real>
struct Elsewhere {
  static constexpr std::string_view name = "elsewhere";
  static constexpr Phase phase = Phase::drift;
  Vec3<Real> position(const Particle<Real>&, const StepTime<Real>&) const { return {0, 0, 8}; }
};

}  // namespace

TEST_CASE_TEMPLATE("A world that is taken back moves on with the same bits, from memory or a file",
                   Real, EVERY_PRECISION) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    CAPTURE(seed);
    RandomGenerator dice(seed);
    World<Real> world = random_world<Real>(dice, 8);
    for (int n = 0; n < 5; ++n) world.step();
    const Snapshot<Real> saved = world.save();
    std::stringstream file;
    write_snapshot(file, saved);
    for (int n = 0; n < 20; ++n) world.step();
    const Bodies<Real> there = world.bodies();
    for (int again = 0; again < 2; ++again) {
      // In between somebody plays with it.
      for (BodyIndex body = 0; body < world.body_count(); ++body)
        world.apply_impulse_at(world.handle_at(body), dice.vector<Real>(), dice.vector<Real>());
      world.step();
      world.restore(again ? read_snapshot<Real>(file) : saved);
      CHECK(world.ticks() == 5);
      for (int n = 0; n < 20; ++n) world.step();
      REQUIRE(same_motion(there, world.bodies()));
    }
  }
}

TEST_CASE_TEMPLATE("A world goes back to its checkpoints, in any order, to the bit", Real,
                   EVERY_PRECISION) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    CAPTURE(seed);
    RandomGenerator dice(seed);
    World<Real> world = random_world<Real>(dice, 8);
    // Somebody plays with it, and in each frame it is saved in both ways.
    std::vector<Checkpoint<Real>> checkpoints;
    std::vector<Snapshot<Real>> snapshots;
    const auto play = [&] {
      const BodyHandle body =
          world.handle_at(static_cast<BodyIndex>(dice.below(world.body_count())));
      if (dice.one_in(4)) world.set_position(body, dice.vector<Real>());
      if (dice.one_in(4)) world.apply_impulse_at(body, dice.vector<Real>(), dice.vector<Real>());
      if (dice.one_in(4)) world.push_at(body, dice.vector<Real>(), dice.vector<Real>());
      if (dice.one_in(2)) world.step();
      if (dice.one_in(20)) world.step_by_reference();
    };
    for (int n = 0; n < 30; ++n) {
      play();
      checkpoints.push_back(world.checkpoint());
      snapshots.push_back(world.save());
    }
    World<Real> twin = world;
    for (int n = 0; n < 30; ++n) {
      const std::size_t frame = dice.below(checkpoints.size());
      CAPTURE(frame);
      if (dice.one_in(5)) world.restore(snapshots[dice.below(snapshots.size())]);
      world.restore(checkpoints[frame]);
      twin.restore(snapshots[frame]);
      REQUIRE(world.ticks() == twin.ticks());
      REQUIRE(same_motion(twin.bodies(), world.bodies()));
      REQUIRE(world.flags() == twin.flags());
      for (int k = 0; k < 3; ++k) world.step(), twin.step();
      REQUIRE(same_motion(twin.bodies(), world.bodies()));
      play();
    }
  }
}

TEST_CASE_TEMPLATE(
    "A checkpoint holds the bodies that may have moved since the first one, and no others", Real,
    EVERY_PRECISION) {
  World<Real> world;
  for (int n = 0; n < 9; ++n)
    world.add("body " + std::to_string(n), make_particle<Real>(1, {Real(n), 0, 0}));
  const BodyHandle mover = world.find("body 3");
  world.set_velocity(mover, {1, 0, 0});
  const EffectHandle weight = world.add(Gravity<Real>{}, {world.find("body 5")});
  CHECK(world.checkpoint().moved.empty());
  CHECK(world.checkpoint().moved.size() == 2);
  world.step();
  world.set_position(world.find("body 7"), {0, 9, 0});
  CHECK(world.checkpoint().moved.size() == 3);
  // Who falls no more has fallen; and so for a body that was put somewhere and back to rest.
  world.remove(weight);
  world.set_velocity(world.find("body 5"), {0, 0, 0});
  const Checkpoint<Real> checkpoint = world.checkpoint();
  CHECK(checkpoint.moved.size() == 3);
  world.set_position(world.find("body 1"), {5, 5, 5});
  world.restore(checkpoint);
  CHECK(same_bits(world.position(world.find("body 1")), Vec3<Real>(1, 0, 0)));
  CHECK(same_bits(world.position(world.find("body 7")), Vec3<Real>(0, 9, 0)));
  world.add("tenth", make_particle<Real>(1));
  CHECK(world.checkpoint().moved.empty());  // of a new list of all
  try {
    world.restore(checkpoint);
    FAIL("it was taken");
  } catch (const std::invalid_argument& error) {
    CHECK(std::string(error.what()) ==
          "the checkpoint is of another world, or a body has come or gone since; a copy of the "
          "world outlasts bodies that come and go");
  }
}

TEST_CASE_TEMPLATE("A checkpoint of a point is refused where a body with a top has taken its place",
                   Real, EVERY_PRECISION) {
  World<Real> world;
  const BodyHandle point = world.add("point", make_particle<Real>(1));
  const Checkpoint<Real> checkpoint = world.checkpoint();
  world.set_position(point, {1, 0, 0});
  world.remove(point);
  CHECK_THROWS_AS(world.restore(checkpoint), std::invalid_argument);
  world.restore(world.checkpoint());  // of nobody, as nobody is there, though a body was touched
  CHECK(world.body_count() == 0);
  const auto shape = mass_properties(Sphere<Real>{1}, 2);
  world.add("ball", make_rigid_body<Real>("ball", shape).body);
  CHECK_THROWS_AS(world.restore(checkpoint), std::invalid_argument);
}

TEST_CASE("A checkpoint is refused by another world, and where a body has come for another") {
  World<double> world, twin;
  for (World<double>* each : {&world, &twin})
    for (const char* name : {"one", "two", "three"}) each->add(name, make_particle(1.0));
  const Checkpoint<double> checkpoint = world.checkpoint();
  World<double> copy = world;
  copy.set_position(copy.find("two"), {1, 0, 0});
  copy.restore(checkpoint);
  CHECK(copy.position(copy.find("two")) == Vec3d::Zero());
  CHECK_THROWS_AS(twin.restore(checkpoint), std::invalid_argument);
  for (World<double>* each : {&world, &copy}) {
    each->remove(each->find(each == &copy ? "one" : "two"));
    CHECK_THROWS_AS(each->restore(checkpoint), std::invalid_argument);
  }
  CHECK_THROWS_AS(copy.restore(world.checkpoint()), std::invalid_argument);  // of others
  for (World<double>* each : {&world, &copy}) {
    each->add("four", make_particle(1.0));
    CHECK_THROWS_AS(each->restore(checkpoint), std::invalid_argument);
  }
}

TEST_CASE_TEMPLATE("A checkpoint holds the place where an effect, since removed, has put a body",
                   Real, EVERY_PRECISION) {
  World<Real> world;
  const BodyHandle body = world.add("body", make_particle<Real>(1));
  world.checkpoint();
  const EffectHandle effect = world.add(Elsewhere<Real>{}, {body});
  world.step();
  world.remove(effect);  // the body has no velocity: nothing can move it now
  CHECK(world.step_plan().moving.empty());
  const Checkpoint<Real> checkpoint = world.checkpoint();
  world.set_position(body, {1, 2, 3});
  world.restore(checkpoint);
  CHECK(same_bits(world.position(body), Vec3<Real>(0, 0, 8)));
}

TEST_CASE_TEMPLATE("A snapshot of more bodies or of fewer is refused with both counts", Real,
                   EVERY_PRECISION) {
  World<Real> world;
  world.add("a", make_particle<Real>(1));
  const Snapshot<Real> saved = world.save();
  world.add("b", make_particle<Real>(1));
  try {
    world.restore(saved);
    FAIL("it was taken");
  } catch (const std::invalid_argument& error) {
    CHECK(std::string(error.what()) ==
          "the snapshot has 1 bodies, 0 of them with a top; the world has 2 and 0; a copy of the "
          "world outlasts bodies that come and go");
  }
  // It does not know which bodies they were: one that came takes over how one that went has moved.
  world.remove(world.find("a"));
  world.set_position(world.find("b"), {5, 0, 0});
  world.restore(saved);
  CHECK(same_bits(world.position(world.find("b")), Vec3<Real>(0, 0, 0)));
}

TEST_CASE_TEMPLATE("A damaged file is refused and says why, whichever letter has changed", Real,
                   EVERY_PRECISION) {
  World<Real> world;
  world.add("a", make_particle<Real>(1, {1, 2, 3}, {Real(0.1), 0, 0}));
  std::ostringstream out;
  write_snapshot(out, world.save());
  const std::string good = out.str(), refused = "not a snapshot that can be used: ";
  CHECK(complaint_of_reading<Real>(good) == "nothing thrown");
  CHECK(complaint_of_reading<Real>("a poem") ==
        refused + "it does not begin with \"tumble snapshot \"");
  CHECK(complaint_of_reading<Real>(good.substr(0, good.size() / 2)) ==
        refused + "its end is missing");
  std::string newer = good;
  newer[newer.find('2')] = '3';
  CHECK(complaint_of_reading<Real>(newer) == refused + "it is of version 3, and this is 2");
  using Other = std::conditional_t<std::is_same_v<Real, float>, double, float>;
  CHECK(complaint_of_reading<Other>(good).find("its numbers have ") == refused.size());
  // Any of 255 letters in place of each, to the line's end behind the checksum.
  for (std::size_t i = 0; i < good.size(); ++i) {
    int accepted = 0;
    std::string damaged = good;
    for (int change = 1; change < 256; ++change) {
      damaged[i] = static_cast<char>(good[i] ^ change);
      accepted += complaint_of_reading<Real>(damaged) == "nothing thrown";
    }
    CAPTURE(i);
    CHECK(accepted == 0);
  }
}

TEST_CASE_TEMPLATE("A world of no bodies is saved and read, and half a first line is refused", Real,
                   EVERY_PRECISION) {
  World<Real> empty;
  empty.step();
  std::stringstream file;
  write_snapshot(file, empty.save());
  const Snapshot<Real> read = read_snapshot<Real>(file);
  CHECK(read.ticks == 1);
  CHECK(read.has_moved.empty());
  CHECK(read.has_turned.empty());
  empty.restore(read);
  // With a checksum that is right.
  const auto closed = [](const std::string& text) {
    std::ostringstream end;
    end << text << "checksum " << std::hex << checksum_of(text) << '\n';
    return end.str();
  };
  const std::string refused = "not a snapshot that can be used: ";
  CHECK(complaint_of_reading<Real>(closed("tumble snapshot \n")) ==
        refused + "it is of version 0, and this is 2");
  CHECK(complaint_of_reading<Real>(closed("tumble snapshot 1, 64 bits\n")) ==
        refused + "its first line does not say what it holds");
  CHECK(complaint_of_reading<Real>(
            closed("tumble snapshot 2, 64 bits, bodies 0, tops 0, ticks 6\n")) ==
        refused + "its first line does not say what it holds");
}

TEST_CASE("The checksum is that of Fowler, Noll and Vo") {
  CHECK(checksum_of("") == 0xcbf29ce484222325);
  CHECK(checksum_of("a") == 0xaf63dc4c8601ec8c);
}
