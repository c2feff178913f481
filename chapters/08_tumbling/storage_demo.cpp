// One rule, one needle, in float, with its state kept in three ways from step to step.
#include <support/record.hpp>
#include <support/rules.hpp>

using namespace tumble;
using support::number;

namespace {

//! [storage]
void keep_body_momentum(Topf& top, float time_step) {
  turn_by_splitting(top, time_step);
}

void keep_world_momentum(Topf& top, float time_step) {
  turn_by_splitting(top, time_step);
  const Vec3f stored = angular_momentum_world(top);
  set_angular_momentum_world(top, stored);
}

void keep_world_velocity(Topf& top, float time_step) {
  turn_by_splitting(top, time_step);
  const Vec3f stored = angular_velocity_world(top);
  set_angular_velocity_world(top, stored);
}
//! [storage]

}  // namespace

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  std::printf("moments 1 : 10^6, float, 3600 steps      largest error\n");
  std::printf("kept from step to step                   energy    momentum\n");
  const auto run = [&](const char* name, const char* value, void (*turn)(Topf&, float)) {
    const support::Motion m = support::watched<float>(support::tumbling_problems[3], turn);
    std::printf("%-38s %8.0e  %8.0e\n", name, m.energy_error, m.momentum_error);
    notebook.value(value, number("%.0e", m.energy_error));
    return m;
  };
  const support::Motion body =
      run("angular momentum, body axes", "body_momentum", keep_body_momentum);
  const support::Motion world =
      run("angular momentum, world axes", "world_momentum", keep_world_momentum);
  const support::Motion velocity =
      run("angular velocity, world axes", "world_velocity", keep_world_velocity);
  notebook.value("world_velocity_momentum", number("%.0f %%", 100 * velocity.momentum_error));
  support::expect(body.energy_error < 1e-4, "kept in body axes, the energy holds");
  support::expect(
      world.energy_error > 10 * body.energy_error && velocity.energy_error > 10 * body.energy_error,
      "kept in world axes it does not, in neither form");
  support::expect(velocity.momentum_error > 10 * world.momentum_error,
                  "and with the velocity L is off as well");
}
