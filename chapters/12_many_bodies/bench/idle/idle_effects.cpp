#include <cstdio>
#include <string_view>
#include <tumble/air_and_water.hpp>
#include <tumble/gravity.hpp>
#include <tumble/solids.hpp>
#include <tumble/spheres.hpp>
#include <tumble/thruster.hpp>
#include <tumble/world.hpp>

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

/// What is counted. Not taken into its caller, so that it can be found by its name.
[[gnu::noinline]] void steps_that_are_counted(World<float>& world) {
  for (int step = 0; step < 100; ++step) world.step();
}

}  // namespace

/// idle_effects never|idle|needed: steps a world that never heard of most effects; or has them and
/// needs none; or has one that it needs.
int main(int argument_count, char** arguments) {
  const std::string_view kind = argument_count == 2 ? arguments[1] : "";
  World<float> world = coasting();
  if (kind == "idle")
    add_idle_effects(world);
  else if (kind == "needed")
    world.add(Gravity<float>{});
  else if (kind != "never") {
    std::fputs("usage: idle_effects never|idle|needed\n", stderr);
    return 2;
  }
  world.step();  // makes the plan
  steps_that_are_counted(world);
}
