// Who is visited, and what is said of it, after bodies and effects have changed.
#include <support/box_body.hpp>
#include <support/checks.hpp>
#include <tumble/air_and_water.hpp>
#include <tumble/gravity.hpp>
#include <tumble/snapshot_file.hpp>
#include <tumble/solids.hpp>
#include <tumble/springs.hpp>
#include <tumble/world.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

/// 2 N m about z.
template <class Real>
struct SteadyTwist {
  static constexpr std::string_view name = "steady twist";
  Vec3<Real> torque(const Top<Real>&, Real) const { return {0, 0, 2}; }
};

/// Leaves the velocity as it is.
template <class Real, Phase when>
struct Still {
  static constexpr Phase phase = when;
  std::string name;
  Vec3<Real> velocity(const Particle<Real>& centre, const StepTime<Real>&) const {
    return centre.velocity;
  }
};

template <class Real>
struct Turn {
  static constexpr std::string_view name = "turn";
  Vec3<Real> torque(const Top<Real>&, Real) const { return {0, 0, 1}; }
};

/// How many bodies the pass of that name visits.
template <class AnyWorld>
std::size_t visited(const AnyWorld& world, const std::string& name) {
  for (const PlanRow& row : world.plan().rows)
    if (row.effect == name) return row.visited;
  return no_index;
}

/// How many effects a phase runs.
template <class AnyWorld>
std::size_t runs(const AnyWorld& world, Phase phase) {
  return world.step_plan().in_phase[static_cast<std::size_t>(phase)].size();
}

}  // namespace

TEST_CASE_TEMPLATE("A body that gets the place of another gets none of its effects", Real,
                   EVERY_PRECISION) {
  // Points stand before the boxes, so that no box's top has the number of its body.
  for (const bool on_tops : {false, true}) {
    World<Real> world(steps_per_second(1));
    world.add("point", make_particle<Real>(1));
    const BodyHandle first = world.add("first", box_body<Real>({1, 0, 0}));
    const BodyHandle second = world.add("second", box_body<Real>({2, 0, 0}));
    const BodyHandle last = world.add("last", box_body<Real>({3, 0, 0}));
    for (const BodyHandle box : {first, second, last}) {
      world.set_velocity(box, {8, 0, 0});
      world.set_angular_velocity(box, {0, 0, 8});
    }
    if (on_tops)
      world.add(AngularDamping<Real>{.rate = 1}, {first, second});
    else
      world.add(LinearDamping<Real>{.rate = 1}, {first, second});
    world.remove(first);
    world.step();
    const RigidBody<Real> slow = world.body(second), free = world.body(last);
    CHECK(free.centre.velocity.x() == 8);
    CHECK(distance<Real>(angular_velocity_body(free.top), {0, 0, 8}) <=
          32 * unit_roundoff<Real>);  // of 8, which is rounded into L and back
    CHECK((on_tops ? angular_velocity_body(slow.top).z() : slow.centre.velocity.x()) < 4);
  }
}

TEST_CASE_TEMPLATE("A spring goes with one of its two bodies, and its other pairs stay as they are",
                   Real, EVERY_PRECISION) {
  World<Real> world(steps_per_second(1));
  std::vector<BodyHandle> row;
  for (int n = 0; n < 5; ++n)
    row.push_back(world.add(std::to_string(n), make_particle<Real>(1, {Real(4 * n), 0, 0})));
  world.add(SpringBetween<Real>{.spring = {.stiffness = Real(0.25)}},
            {row[0], row[1], row[2], row[3]});
  CHECK(visited(world, "kick") == 4);
  world.remove(row[1]);  // the fifth gets its place, and the first is held by nothing
  CHECK(visited(world, "spring between bodies") == 1);
  CHECK(visited(world, "kick") == 2);
  world.step();
  CHECK(world.velocity(row[0]).x() == 0);
  CHECK(world.velocity(row[4]).x() == 0);
  CHECK(world.velocity(row[2]).x() == 1);
  CHECK(world.velocity(row[3]).x() == -1);
}

TEST_CASE_TEMPLATE("A pair is joined while one of the two can be moved, and not when neither can",
                   Real, EVERY_PRECISION) {
  World<Real> world(steps_per_second(1));
  const BodyHandle wall = world.add("wall", make_static_particle<Real>({0, 0, 0}));
  const BodyHandle box = world.add("box", box_body<Real>({4, 0, 0}));
  const BodyHandle other = world.add("other", box_body<Real>({8, 0, 0}));
  world.add(SpringBetween<Real>{.spring = {.stiffness = 1}}, {wall, box, other, box});
  world.add(SpringBetween<Real>{.spring = {.stiffness = 1}, .name = "second"}, {wall, box});
  const std::string spring = "spring between bodies";
  CHECK(visited(world, spring) == 2);
  world.replace(box, make_static_body<Real>("box", {{4, 0, 0}}));
  CHECK(visited(world, spring) == 1);
  const Plan plan = world.plan();
  CHECK(plan.rows[0].effect == spring);
  CHECK(plan.rows[0].of == 2);
  CHECK(plan.rows[0].reason == "not 1: nothing can move either of the two");
  CHECK(plan.rows[1].reason == "not 1: nothing can move either of the two");
  world.replace(box, box_body<Real>({4, 0, 0}));
  CHECK(visited(world, spring) == 2);
  CHECK(world.plan().rows[0].reason == "every pair calls for it");
}

TEST_CASE_TEMPLATE("An effect that nobody needs any more is in no phase", Real, EVERY_PRECISION) {
  World<Real> world;
  world.add("wall", make_static_particle<Real>({0, 0, 0}));
  const BodyHandle stone = world.add("stone", make_particle<Real>(1));
  const BodyHandle box = world.add("box", box_body<Real>({0, 0, 0}));
  const BodyHandle nail = world.add("nail", make_static_particle<Real>({0, 0, 0}));
  world.set_velocity(box, {1, 0, 0});
  world.set_angular_velocity(box, {0, 0, 1});
  world.add(AngularDamping<Real>{.rate = 1});
  world.add(LinearDamping<Real>{.rate = 1}, {box, nail});
  const EffectHandle gravity = world.add(Gravity<Real>{}, {stone, nail});
  CHECK(runs(world, Phase::force) == 1);
  CHECK(runs(world, Phase::damping) == 2);
  world.change(gravity, Gravity<Real>{{0, 0, 0}});
  CHECK(runs(world, Phase::force) == 0);
  world.change(gravity, Gravity<Real>{});
  CHECK(runs(world, Phase::force) == 1);
  world.remove(stone);  // what is left of the two can't be moved
  CHECK(runs(world, Phase::force) == 0);
  world.remove(box);
  CHECK(runs(world, Phase::damping) == 0);
  World<Real> alone;
  alone.add(Gravity<Real>{});
  const BodyHandle only = alone.add("only", make_particle<Real>(1));
  CHECK(runs(alone, Phase::force) == 1);
  alone.remove(only);
  CHECK(runs(alone, Phase::force) == 0);
}

TEST_CASE_TEMPLATE(
    "A body taken back to rest is visited no more, and one taken back to motion is visited again",
    Real, EVERY_PRECISION) {
  World<Real> world;
  const BodyHandle mover = world.add("mover", box_body<Real>({0, 0, 0}));
  const BodyHandle spinner = world.add("spinner", box_body<Real>({5, 0, 0}));
  world.add("idle", box_body<Real>({9, 0, 0}));
  const auto plan = [&] {
    return std::pair(visited(world, "drift"), visited(world, "tumbling: splitting"));
  };
  const Snapshot<Real> at_rest = world.save();
  world.set_velocity(mover, {1, 0, 0});
  const Snapshot<Real> moving = world.save();
  world.set_angular_velocity(spinner, {0, 0, 1});
  const Snapshot<Real> both = world.save();
  std::stringstream file;
  write_snapshot(file, moving);
  CHECK(plan() == std::pair<std::size_t, std::size_t>(1, 1));
  world.restore(at_rest);
  CHECK(plan() == std::pair<std::size_t, std::size_t>(0, 0));
  world.restore(both);
  CHECK(plan() == std::pair<std::size_t, std::size_t>(1, 1));
  CHECK(world.flags()[0].moves);
  CHECK_FALSE(world.flags()[0].turns);
  CHECK(world.flags()[1].turns);
  world.restore(read_snapshot<Real>(file));
  CHECK(plan() == std::pair<std::size_t, std::size_t>(1, 0));
  CHECK(world.flags()[0].moves);
}

TEST_CASE_TEMPLATE("A push of one step calls for one kick, and for none if the world is taken back",
                   Real, EVERY_PRECISION) {
  World<Real> world(steps_per_second(1));
  const BodyHandle box = world.add("box", box_body<Real>({0, 0, 0}));
  const Snapshot<Real> saved = world.save();
  const auto kicks = [&] {
    return std::pair(visited(world, "kick"), visited(world, "kick of the spin"));
  };
  world.push_at(box, {2, 0, 0}, {0, 1, 0});
  CHECK(kicks() == std::pair<std::size_t, std::size_t>(1, 1));
  World<Real> reference = world, exhaustive = world;
  reference.step_by_reference();
  exhaustive.step_exhaustively();
  CHECK(reference.velocity(box).x() == 1);
  reference.step_by_reference();  // the push is over
  CHECK(reference.velocity(box).x() == 1);
  CHECK(exhaustive.velocity(box).x() == 1);
  world.step();
  CHECK(world.velocity(box).x() == 1);
  CHECK(kicks() == std::pair<std::size_t, std::size_t>(0, 0));
  world.push_at(box, {2, 0, 0}, {0, 1, 0});
  world.restore(saved);
  CHECK(kicks() == std::pair<std::size_t, std::size_t>(0, 0));
  world.step();
  CHECK(world.velocity(box).x() == 0);
  CHECK(complaint_of([&] {
          world.push_at(box, {0, std::numeric_limits<Real>::infinity(), 0}, {0, 0, 0});
        }) == "box: force is (0, inf, 0) N; every component must be finite");
  CHECK(complaint_of([&] {
          world.push_at(box, {0, 0, 0}, {0, 0, std::numeric_limits<Real>::infinity()});
        }) == "box: point of the force is (0, 0, inf) m; every component must be finite");
}

TEST_CASE_TEMPLATE("A torque of one step alone changes L by itself times the step, and no velocity",
                   Real, EVERY_PRECISION) {
  World<Real> world(steps_per_second(1));
  const BodyHandle box = world.add("box", box_body<Real>({0, 0, 0}));
  world.push(box, {.torque = {0, 0, 2}});
  world.step();
  world.step();
  CHECK(world.body(box).top.angular_momentum_body.norm() == 2);
  CHECK(world.velocity(box) == Vec3<Real>(0, 0, 0));
  CHECK(complaint_of([&] {
          world.push(box, {.torque = {0, std::numeric_limits<Real>::infinity(), 0}});
        }) == "box: torque is (0, inf, 0) N m; every component must be finite");
}

TEST_CASE_TEMPLATE("A torque calls for no drift, a force for no turn, and a plan lists every phase",
                   Real, EVERY_PRECISION) {
  World<Real> world;
  world.add("box", box_body<Real>({0, 0, 0}));
  const EffectHandle turn = world.add(Turn<Real>{});
  CHECK(world.flags()[0] ==
        BodyFlags{.can_turn = true, .is_gyroscopic = true, .is_torqued = true, .turns = true});
  world.remove(turn);
  world.add(Gravity<Real>{});
  CHECK(world.flags()[0] ==
        BodyFlags{.can_turn = true, .is_gyroscopic = true, .is_pushed = true, .moves = true});
  world.add(Still<Real, Phase::drift>{"e"});
  world.add(Still<Real, Phase::damping>{"d"});
  world.add(Still<Real, Phase::impulse>{"c"});
  world.add(Still<Real, Phase::kick>{"b"});
  world.add(Still<Real, Phase::force>{"a"});
  std::vector<std::string> names;
  for (const PlanRow& row : world.plan().rows) names.push_back(row.effect);
  CHECK(names == std::vector<std::string>{"gravity", "a", "b", "kick", "kick of the spin", "c", "d",
                                          "drift", "steady turning", "tumbling: splitting", "e"});
}

TEST_CASE_TEMPLATE("Whatever may change the work of a step gives it a new number", Real,
                   EVERY_PRECISION) {
  World<Real> world;
  std::uint64_t before = world.step_plan().version;
  const auto is_new = [&] { return std::exchange(before, world.step_plan().version) != before; };
  const BodyHandle box = world.add("box", box_body<Real>({0, 0, 0}));
  CHECK(is_new());
  world.add("stone", make_particle<Real>(1));
  CHECK(is_new());
  const EffectHandle gravity = world.add(Gravity<Real>{}, {box});
  CHECK(is_new());
  world.change(gravity, Gravity<Real>{{0, 0, 1}});
  CHECK(is_new());
  world.turn_by(Steady{});
  CHECK(is_new());
  world.set_velocity(box, {1, 0, 0});
  CHECK(is_new());
  world.remove(gravity);
  CHECK(is_new());
  world.remove(world.find("stone"));
  CHECK(is_new());
}

TEST_CASE_TEMPLATE("A body that only a copy has is unknown to the original", Real,
                   EVERY_PRECISION) {
  World<Real> world;
  world.add("a", make_particle<Real>(1));
  World<Real> copy = world;
  const BodyHandle more = copy.add("b", make_particle<Real>(1));
  CHECK(copy.contains(more));
  CHECK_FALSE(world.contains(more));
}

TEST_CASE("A torque stays with its body where that has the last top and a point is the last body") {
  World<double> world(steps_per_second(2));
  const BodyHandle a = world.add("a", box_body<double>({0, 0, 0})),
                   b = world.add("b", box_body<double>({1, 0, 0}));
  world.add("point", make_particle<double>(1));
  world.add(SteadyTwist<double>{}, {b});
  world.remove(a);
  world.step();
  CHECK(world.body(b).top.angular_momentum_body.norm() == 1);
}
