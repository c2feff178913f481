#include <cstdio>
#include <string_view>
#include <tumble/air_and_water.hpp>
#include <tumble/gravity.hpp>
#include <tumble/in_packs.hpp>
#include <tumble/solids.hpp>
#include <tumble/spheres.hpp>
#include <tumble/springs.hpp>
#include <tumble/thruster.hpp>

using namespace tumble;

namespace {

/// Points that fly, balls that coast, and a damping that all of them need.
World<float> coasting() {
  World<float> world;
  for (int n = 0; n < 60; ++n)
    world.add("point " + std::to_string(n), make_particle<float>(1, {float(n), 0, 0}, {1, 0, 0}));
  const auto ball = mass_properties(Sphere<float>{1}, 1);
  for (int n = 0; n < 60; ++n)
    world.add("ball " + std::to_string(n),
              make_rigid_body<float>("ball", ball, {{0, float(n), 0}}, {1, 0, 0}).body);
  world.add(LinearDamping<float>{.rate = 0.01f});
  return world;
}

/// Effects that are in the scene and that no body needs.
void add_idle_effects(World<float>& world) {
  world.add(Gravity<float>{{0, 0, 0}});
  world.add(GravityAsAcceleration<float>{{0, 0, 0}});
  world.add(PointGravity<float>{});
  world.add(QuadraticDrag<float>{});
  world.add(Magnus<float>{.strength = 1});          // nothing spins
  world.add(AngularDamping<float>{.rate = 0.01f});  // nor can anything
  world.add(Buoyancy<float>{.radius = 0});
  world.add(Thruster<float>{}, {world.find("ball 0")});
}

/// `resting` boxes that nothing moves, and behind them `active` ones that fall and tumble. They are
/// whole blocks of packs, so that the active ones lie alike in packs, however many rest.
template <class AnyWorld>
AnyWorld boxes(int resting, int active) {
  AnyWorld world;
  const auto shape = mass_properties(Box<float>{{1, 2, 3}}, 2);
  const RigidBody<float> box = make_rigid_body<float>("box", shape).body,
                         spinning =
                             make_rigid_body<float>("box", shape, {}, {0, 0, 0}, {1, 2, 3}).body;
  std::vector<BodyHandle> falling;
  for (int n = 0; n < resting + active; ++n) {
    const BodyHandle added = world.add("box " + std::to_string(n), n < resting ? box : spinning);
    if (n >= resting) falling.push_back(added);
  }
  world.add(LinearDamping<float>{.rate = 0.01f});
  world.add(AngularDamping<float>{.rate = 0.01f});
  if (active > 0) world.add(Gravity<float>{}, falling);
  return world;
}

/// What is counted. Not taken into its caller, so that it can be found by its name.
template <class AnyWorld>
[[gnu::noinline]] void steps_that_are_counted(AnyWorld& world) {
  for (int step = 0; step < 100; ++step) world.step();
}

/// A box goes from the middle, where the last gets its place; another one comes, gets its first
/// spin, is replaced and gets a velocity.
template <class AnyWorld>
[[gnu::noinline]] void changes_that_are_counted(AnyWorld& world, const RigidBody<float>& box) {
  const BodyHandle middle = world.handle_at(static_cast<BodyIndex>(world.body_count() / 2));
  const std::string name = world.name_of(middle);
  world.remove(middle);
  const BodyHandle body = world.add(name, box);
  world.set_angular_velocity(body, {0, 0, 1});
  world.replace(body, box);
  world.set_velocity(body, {0, 0, 1});
}

/// Changes of one of so many boxes that fall, under five effects.
int count_changes_among(int count) {
  const auto shape = mass_properties(Box<float>{{1, 2, 3}}, 2);
  auto world = boxes<World<float>>(count, 0);
  world.add(QuadraticDrag<float>{.coefficient = 0.1f});
  world.add(Magnus<float>{.strength = 0.1f});
  world.add(GravityAsAcceleration<float>{});
  const RigidBody<float> box = make_rigid_body<float>("box", shape).body;
  for (int n = 0; n < 10; ++n) changes_that_are_counted(world, box);
  return 0;
}

/// A checkpoint in each frame, and a way back from the next one.
template <class AnyWorld>
[[gnu::noinline]] void checkpoints_that_are_counted(AnyWorld& world) {
  for (int frame = 0; frame < 20; ++frame) {
    const Checkpoint<float> checkpoint = world.checkpoint();
    world.step();
    world.restore(checkpoint);
  }
}
template <class AnyWorld>
int count_checkpoints_of(AnyWorld world) {
  world.step();
  world.checkpoint();  // of all bodies
  checkpoints_that_are_counted(world);
  return 0;
}

/// A single step that is counted, and a place at which valgrind writes down the count.
template <class AnyWorld>
[[gnu::noinline]] void one_of_those_that_are_counted(AnyWorld& world) {
  world.step();
}
volatile int steps_over = 0;
[[gnu::noinline]] void count_is_written_down() {
  steps_over = steps_over + 1;
}

/// Steps of a scene in which some rest, some fall and tumble, some hang on springs, and one burns
/// for a second. After the first one, which tells what is new and in packs makes the schedule.
template <class AnyWorld>
int count_each_step(int count) {
  auto world = boxes<AnyWorld>(1024, 1024);
  world.on_warning([](const std::string&) {});
  const BodyHandle first = world.find("box 1024");
  world.add(QuadraticDrag<float>{.coefficient = 0.01f}, {first});
  world.add(Thruster<float>{.force_body = {1, 0, 0}, .point = {0, 1, 0}, .from = 1, .until = 2},
            {first});
  for (int n = 1025; n < 1088; ++n)
    world.add(SpringBetween<float>{.spring = {.stiffness = 1, .rest_length = 1}},
              {world.find("box " + std::to_string(n)), world.find("box " + std::to_string(n + 1))});
  world.step();
  for (int step = 0; step < count; ++step) {
    one_of_those_that_are_counted(world);
    count_is_written_down();
  }
  return 0;
}

/// A scene of so many boxes that fall, under five effects, to the end of its first step.
template <class AnyWorld>
[[gnu::noinline]] void loads_that_are_counted(int count) {
  auto world = boxes<AnyWorld>(0, count);
  world.on_warning([](const std::string&) {});
  world.add(QuadraticDrag<float>{.coefficient = 0.1f});
  world.add(Magnus<float>{.strength = 0.1f});
  world.step();
}
template <class AnyWorld>
int count_loading(int count) {
  loads_that_are_counted<AnyWorld>(count);
  return 0;
}

template <class AnyWorld>
int count_steps_of(AnyWorld world) {
  world.step();  // tells what is new
  steps_that_are_counted(world);
  return 0;
}

}  // namespace

/// idle_effects never|idle|needed: steps a world that never heard of most effects; or has them and
/// needs none; or has one that it needs. With one|many|few|few_of_many it steps one box at rest,
/// 200 blocks of 1024 of them, 12 active boxes behind one such block, and behind all; with
/// packs_one and so on the same in packs. changes_of_ and checkpoints_of_ few or many change
/// bodies, or take the world back to a checkpoint, among as many. each and packs_each step a mixed
/// scene 200 times; load_few, load_many and so on load 10,000 boxes or 100,000.
int main(int argument_count, char** arguments) {
  const std::string_view kind = argument_count == 2 ? arguments[1] : "";
  const int block = 1024, many = 200 * block;
  if (kind == "changes_of_few") return count_changes_among(block);
  if (kind == "changes_of_many") return count_changes_among(20 * block);
  if (kind == "one") return count_steps_of(boxes<World<float>>(1, 0));
  if (kind == "many") return count_steps_of(boxes<World<float>>(many, 0));
  if (kind == "few") return count_steps_of(boxes<World<float>>(block, 12));
  if (kind == "few_of_many") return count_steps_of(boxes<World<float>>(many, 12));
  if (kind == "packs_one") return count_steps_of(boxes<ManyBodies<float>>(1, 0));
  if (kind == "packs_many") return count_steps_of(boxes<ManyBodies<float>>(many, 0));
  if (kind == "packs_few") return count_steps_of(boxes<ManyBodies<float>>(block, 12));
  if (kind == "packs_few_of_many") return count_steps_of(boxes<ManyBodies<float>>(many, 12));
  if (kind == "checkpoints_of_few") return count_checkpoints_of(boxes<World<float>>(block, 12));
  if (kind == "checkpoints_of_many") return count_checkpoints_of(boxes<World<float>>(many, 12));
  if (kind == "each") return count_each_step<World<float>>(200);
  if (kind == "packs_each") return count_each_step<ManyBodies<float>>(200);
  if (kind == "load_few") return count_loading<World<float>>(10'000);
  if (kind == "load_many") return count_loading<World<float>>(100'000);
  if (kind == "packs_load_few") return count_loading<ManyBodies<float>>(10'000);
  if (kind == "packs_load_many") return count_loading<ManyBodies<float>>(100'000);
  World<float> world = coasting();
  if (kind == "idle")
    add_idle_effects(world);
  else if (kind == "needed")
    world.add(Gravity<float>{});
  else if (kind != "never") {
    std::fputs(
        "usage: idle_effects "
        "never|idle|needed|[packs_](one|many|few|few_of_many|each|load_few|load_many)|"
        "(changes|checkpoints)_of_(few|many)\n",
        stderr);
    return 2;
  }
  return count_steps_of(world);
}
