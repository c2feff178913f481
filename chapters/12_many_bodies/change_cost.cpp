#include <benchmark/benchmark.h>

#include <tumble/air_and_water.hpp>
#include <tumble/gravity.hpp>
#include <tumble/in_packs.hpp>
#include <tumble/solids.hpp>
#include <tumble/springs.hpp>

using namespace tumble;

namespace {

constexpr int count = 20'480;

/// Boxes under five effects, of which one in `fixed` can't move; none if that is 0.
ManyBodies<float> boxes(int fixed) {
  ManyBodies<float> world;
  world.on_warning([](const std::string&) {});
  const auto shape = mass_properties(Box<float>{{1, 2, 3}}, 2);
  const RigidBody<float> box = make_rigid_body<float>("box", shape, {}, {1, 0, 0}, {1, 2, 3}).body;
  const RigidBody<float> wall;
  for (int n = 0; n < count; ++n)
    world.add("box " + std::to_string(n), fixed && n % fixed == 0 ? wall : box);
  world.add(LinearDamping<float>{.rate = 0.01f});
  world.add(AngularDamping<float>{.rate = 0.01f});
  world.add(GravityAsAcceleration<float>{});
  world.add(Magnus<float>{.strength = 0.1f});
  world.add(Gravity<float>{});
  world.step();
  return world;
}

void step(benchmark::State& state, int fixed) {
  auto world = boxes(fixed);
  for (auto _ : state) world.step();
}

/// Each box hangs on a spring from one further on; a step with forces that join two, on so many
/// threads.
void step_of_net(benchmark::State& state, int threads) {
  auto world = boxes(0);
  std::vector<BodyHandle> ends;
  for (BodyIndex n = 0; n < count; ++n)
    ends.insert(ends.end(), {world.handle_at(n), world.handle_at((n + 1000) % count)});
  world.add(SpringBetween<float>{{.stiffness = 1}}, ends);
  world.use_threads(threads);
  for (auto _ : state) world.step();
  state.SetItemsProcessed(state.iterations());  // the time by the clock, not that of one thread
}

/// What a change costs the next step in packs.
void schedule(benchmark::State& state, int fixed) {
  const auto world = boxes(fixed);
  for (auto _ : state) {
    Schedule<float, natural_width<float>> made(world.step_plan());
    benchmark::DoNotOptimize(made);
  }
}

void steps(benchmark::State& state) {
  step(state, 0);
}
void steps_of_some(benchmark::State& state) {
  step(state, 3);
}
void steps_of_two_threads(benchmark::State& state) {
  auto world = boxes(0);
  world.use_threads(2);
  for (auto _ : state) world.step();
  state.SetItemsProcessed(state.iterations());
}
void steps_of_net(benchmark::State& state) {
  step_of_net(state, 1);
}
void steps_of_net_on_two_threads(benchmark::State& state) {
  step_of_net(state, 2);
}
void schedules(benchmark::State& state) {
  schedule(state, 0);
}
void schedules_of_some(benchmark::State& state) {
  schedule(state, 3);
}

/// A body goes and another comes.
void changes(benchmark::State& state) {
  auto world = boxes(0);
  for (auto _ : state) {
    const BodyHandle middle = world.handle_at(count / 2 + 1);
    const std::string name = world.name_of(middle);
    const RigidBody<float> body = world.body(middle);
    world.remove(middle);
    world.add(name, body);
  }
}

/// The next step does this too if an effect that can limit the step was meant for the body.
void limits(benchmark::State& state) {
  auto world = boxes(0);
  world.add(QuadraticDrag<float>{.coefficient = 0.1f});
  for (auto _ : state) benchmark::DoNotOptimize(world.step_limit());
}

void snapshots(benchmark::State& state) {
  const auto world = boxes(0);
  for (auto _ : state) benchmark::DoNotOptimize(world.save());
}

void checkpoints(benchmark::State& state) {
  auto world = boxes(0);
  world.checkpoint();
  for (auto _ : state) benchmark::DoNotOptimize(world.checkpoint());
}

void ways_back(benchmark::State& state) {
  auto world = boxes(0);
  world.checkpoint();
  const Checkpoint<float> checkpoint = world.checkpoint();
  for (auto _ : state) world.restore(checkpoint);
}

}  // namespace

BENCHMARK(steps)->Name("a step");
BENCHMARK(steps_of_two_threads)->Name("a step on two threads")->UseRealTime();
BENCHMARK(steps_of_net)->Name("a step with as many springs")->UseRealTime();
BENCHMARK(steps_of_net_on_two_threads)
    ->Name("a step with as many springs on two threads")
    ->UseRealTime();
BENCHMARK(steps_of_some)->Name("a step, a third of the boxes fixed");
BENCHMARK(changes)->Name("a box goes, and another comes");
BENCHMARK(schedules)->Name("the schedule made anew");
BENCHMARK(schedules_of_some)->Name("the schedule made anew, a third fixed");
BENCHMARK(limits)->Name("the limit of the step, with drag as a sixth effect");
BENCHMARK(snapshots)->Name("a snapshot");
BENCHMARK(checkpoints)->Name("a checkpoint");
BENCHMARK(ways_back)->Name("back to a checkpoint");
