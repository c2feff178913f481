#include "parts_of_step.hpp"

#include <support/checks.hpp>
#include <support/random_world.hpp>
#include <support/scene_rules.hpp>
#include <support/shipped_scenes.hpp>
#include <tumble/reaction_wheel.hpp>
#include <tumble/scene/read_scene_file.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

World<double> world_of(const std::filesystem::path& scene) {
  return read_scene_file<double, OneByOne<double>, SceneRules>(scene).world;
}

}  // namespace

TEST_CASE("The parts of a step are the lines of its plan that visit somebody") {
  for (const std::filesystem::path& path : shipped_scenes()) {
    CAPTURE(path.stem().string());
    World<double> world = world_of(path);
    std::string lines, parts;
    for (const PlanRow& row : world.plan().rows)
      if (row.visited > 0) lines += row.effect + '\n';
    for (const simulate::PartOfStep& part : simulate::parts_of(world.step_plan()))
      parts += part.name + '\n';
    CHECK(parts == lines);
  }
}

TEST_CASE(
    "One after another, as often as each occurs in a step, the parts make a step of Euler's") {
  int compared = 0;
  for (const std::filesystem::path& path : shipped_scenes()) {
    CAPTURE(path.stem().string());
    World<double> world = world_of(path);
    if (world.scheme() != Scheme::semi_implicit_euler) continue;
    ++compared;
    // What a wheel does on both sides of the turning is one part, which no order of parts can be.
    for (const auto& entry : std::vector(world.effects()))
      if (entry.effect->phase() == Phase::turn) world.remove(entry.handle);
    Bodies<double> bodies = world.bodies();
    for (int step = 0; step < 2; ++step) {
      for (const simulate::PartOfStep& part : simulate::parts_of(world.step_plan())) {
        CHECK(part.times == 1);
        part.act(bodies, world.step_time());
      }
      world.step();
    }
    CHECK(same_motion(bodies, world.bodies()));
  }
  CHECK(compared >= 10);
}

TEST_CASE(
    "In a step of Suzuki's forces and kicks occur five times, drifts and turns ten, damping once") {
  World<double> world = world_of(scenes_folder() / "everything.json");
  world.step_by(Scheme::suzuki);
  const std::vector<simulate::PartOfStep> parts = simulate::parts_of(world.step_plan());
  for (const std::string name : {"gravity", "kick", "kick of the spin", "reaction wheel", "drift",
                                 "steady turning", "tumbling: splitting", "linear damping"}) {
    CAPTURE(name);
    const auto part = std::find_if(parts.begin(), parts.end(),
                                   [&](const auto& each) { return each.name == name; });
    REQUIRE(part != parts.end());
    CHECK(part->times == (name == "gravity" || name.starts_with("kick") ? 5
                          : name == "linear damping"                    ? 1
                                                                        : 10));
  }
}

TEST_CASE(
    "All that a wheel does in a drift is one part, which turns its body for the whole drift") {
  World<double> world(steps_per_second(8));
  const MassProperties<double> box = mass_properties(Box<double>{{1, 2, 3}}, 6);
  world.add("box", make_rigid_body<double>("box", box).body);
  world.add(ReactionWheel<double>{.axis = {0, 0, 1}, .momentum = 0.5}, {world.handle_at(0)});
  const std::vector<simulate::PartOfStep> parts = simulate::parts_of(world.step_plan());
  const auto wheel = std::find_if(parts.begin(), parts.end(),
                                  [](const auto& part) { return part.name == "reaction wheel"; });
  REQUIRE(wheel != parts.end());
  Bodies<double> bodies = world.bodies();
  wheel->act(bodies, world.step_time());
  const Top<double>& top = bodies.tops[0];
  // About a principal axis the momentum that joins stays what it is, and leaves again. A dozen
  // roundings of numbers below 1.
  CHECK(top.angular_momentum_body.norm() <= 12 * 0x1p-53);
  CHECK(std::abs(angle_between(top.orientation, world.bodies().tops[0].orientation) -
                 0.5 * top.inverse_moments.z() / 8) <= 12 * 0x1p-53);
}
