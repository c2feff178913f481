#include <benchmark/benchmark.h>

#include <tumble/air_and_water.hpp>
#include <tumble/gravity.hpp>
#include <tumble/in_packs.hpp>
#include <tumble/solids.hpp>

using namespace tumble;

namespace {

constexpr int count = 20'480;

/// Boxes under five effects, of which one in `resting` can't move; none if that is 0.
template <class AnyWorld>
AnyWorld boxes(int resting) {
  AnyWorld world;
  world.on_warning([](const std::string&) {});
  const auto shape = mass_properties(Box<float>{{1, 2, 3}}, 2);
  const RigidBody<float> box = make_rigid_body<float>("box", shape, {}, {1, 0, 0}, {1, 2, 3}).body;
  RigidBody<float> fixed;
  for (int n = 0; n < count; ++n)
    world.add("box " + std::to_string(n), resting && n % resting == 0 ? fixed : box);
  world.add(LinearDamping<float>{.rate = 0.01f});
  world.add(AngularDamping<float>{.rate = 0.01f});
  world.add(GravityAsAcceleration<float>{});
  world.add(Magnus<float>{.strength = 0.1f});
  world.add(Gravity<float>{});
  world.step();
  return world;
}

template <class AnyWorld>
void steps(benchmark::State& state, int resting) {
  auto world = boxes<AnyWorld>(resting);
  for (auto _ : state) world.step();
}

/// A body goes and another comes before each step.
template <class AnyWorld>
void changes(benchmark::State& state, int resting) {
  auto world = boxes<AnyWorld>(resting);
  for (auto _ : state) {
    const BodyHandle middle = world.handle_at(count / 2 + 1);
    const std::string name = world.name_of(middle);
    const RigidBody<float> body = world.body(middle);
    world.remove(middle);
    world.add(name, body);
    world.step();
  }
}

template <class AnyWorld>
void snapshots(benchmark::State& state) {
  auto world = boxes<AnyWorld>(0);
  for (auto _ : state) benchmark::DoNotOptimize(world.save());
}

template <class AnyWorld>
void marks(benchmark::State& state) {
  auto world = boxes<AnyWorld>(0);
  world.mark();
  for (auto _ : state) benchmark::DoNotOptimize(world.mark());
}

template <class AnyWorld>
void ways_back(benchmark::State& state) {
  auto world = boxes<AnyWorld>(0);
  world.mark();
  const Mark<float> mark = world.mark();
  for (auto _ : state) world.restore(mark);
}

using OneByOneWorld = World<float>;
using Packs = ManyBodies<float>;

void step_one_by_one(benchmark::State& state) {
  steps<OneByOneWorld>(state, 0);
}
void change_one_by_one(benchmark::State& state) {
  changes<OneByOneWorld>(state, 0);
}
void step_in_packs(benchmark::State& state) {
  steps<Packs>(state, 0);
}
void change_in_packs(benchmark::State& state) {
  changes<Packs>(state, 0);
}
void step_of_some(benchmark::State& state) {
  steps<Packs>(state, 3);
}
void change_of_some(benchmark::State& state) {
  changes<Packs>(state, 3);
}

}  // namespace

BENCHMARK(step_one_by_one)->Name("a step, one by one");
BENCHMARK(change_one_by_one)->Name("a change and a step, one by one");
BENCHMARK(step_in_packs)->Name("a step in packs");
BENCHMARK(change_in_packs)->Name("a change and a step in packs");
BENCHMARK(step_of_some)->Name("a step in packs, a third fixed");
BENCHMARK(change_of_some)->Name("a change and a step in packs, a third fixed");
BENCHMARK(snapshots<Packs>)->Name("a snapshot in packs");
BENCHMARK(marks<Packs>)->Name("a mark in packs");
BENCHMARK(ways_back<Packs>)->Name("back to a mark in packs");
