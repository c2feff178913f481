#include <benchmark/benchmark.h>

#include <tumble/air_and_water.hpp>
#include <tumble/gravity.hpp>
#include <tumble/solids.hpp>
#include <tumble/spheres.hpp>
#include <tumble/springs.hpp>
#include <tumble/thruster.hpp>
#include <tumble/world.hpp>

using namespace tumble;

namespace {

constexpr int count = 10'000;

using Scene = void (*)(World<float>&);

void points_under_gravity(World<float>& world) {
  for (int n = 0; n < count; ++n)
    world.add("point " + std::to_string(n), make_particle<float>(1, {float(n), 0, 0}));
  world.add(Gravity<float>{});
}

void bodies(World<float>& world, const MassProperties<float>& properties, const Vec3f& spin) {
  for (int n = 0; n < count; ++n)
    world.add("body " + std::to_string(n),
              make_rigid_body<float>("body", properties, {{float(n), 0, 0}}, {1, 0, 0}, spin).body);
}

void coasting_balls(World<float>& world) {
  bodies(world, mass_properties(Sphere<float>{1}, 1), {0, 0, 0});
}

void spinning_balls(World<float>& world) {
  bodies(world, mass_properties(Sphere<float>{1}, 1), {1, 2, 3});
}

void tumbling_boxes(World<float>& world) {
  bodies(world, mass_properties(Box<float>{{1, 2, 3}}, 1), {1, 2, 3});
}

void everything(World<float>& world) {
  tumbling_boxes(world);
  world.add(Gravity<float>{});
  world.add(PointGravity<float>{.strength = 1, .centre = {0, 0, -1e6f}});
  world.add(QuadraticDrag<float>{.coefficient = 1e-3f, .wind = {1, 0, 0}});
  world.add(Magnus<float>{.strength = 1e-3f});
  world.add(Buoyancy<float>{.density = 1, .radius = 1});
  world.add(SpringToPoint<float>{.spring = {.stiffness = 1e-3f}, .attachment = {1, 0, 0}});
  world.add(Thruster<float>{.force_body = {1e-3f, 0, 0}, .point = {0, 1, 0}});
  world.add(LinearDamping<float>{.rate = 0.01f});
  world.add(AngularDamping<float>{.rate = 0.01f});
}

void planned(benchmark::State& state, Scene scene) {
  World<float> world;
  scene(world);
  world.step();
  for (auto _ : state) world.step();
  state.SetItemsProcessed(state.iterations() * count);
}

void reference(benchmark::State& state, Scene scene) {
  World<float> world;
  scene(world);
  world.step_by_reference();
  for (auto _ : state) world.step_by_reference();
  state.SetItemsProcessed(state.iterations() * count);
}

}  // namespace

BENCHMARK_CAPTURE(planned, points_under_gravity, points_under_gravity)
    ->Name("points under gravity alone, planned");
BENCHMARK_CAPTURE(reference, points_under_gravity, points_under_gravity)
    ->Name("points under gravity alone, reference run");
BENCHMARK_CAPTURE(planned, coasting_balls, coasting_balls)->Name("coasting balls, planned");
BENCHMARK_CAPTURE(reference, coasting_balls, coasting_balls)->Name("coasting balls, reference run");
BENCHMARK_CAPTURE(planned, spinning_balls, spinning_balls)->Name("spinning balls, planned");
BENCHMARK_CAPTURE(reference, spinning_balls, spinning_balls)->Name("spinning balls, reference run");
BENCHMARK_CAPTURE(planned, tumbling_boxes, tumbling_boxes)->Name("tumbling boxes, planned");
BENCHMARK_CAPTURE(reference, tumbling_boxes, tumbling_boxes)->Name("tumbling boxes, reference run");
BENCHMARK_CAPTURE(planned, everything, everything)->Name("everything at once, planned");
BENCHMARK_CAPTURE(reference, everything, everything)->Name("everything at once, reference run");
