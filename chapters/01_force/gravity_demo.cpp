// Gravity as a force and as an acceleration, on a pebble, on a boulder and on a wall.
#include <course/record.hpp>
#include <tumble/force.hpp>

using namespace tumble;

namespace {

const Vec3d gravity(0, 0, -9.81);
const double time_step = 1.0 / 60;

double fall_by_force(Particled body) {
  for (int n = 0; n < 60; ++n) {
    add_gravity(body, gravity);
    step(body, time_step);
    clear_force(body);
  }
  return body.position.z();
}

double fall_by_acceleration(Particled body) {
  for (int n = 0; n < 60; ++n) {
    accelerate(body, gravity, time_step);
    step(body, time_step);
  }
  return body.position.z();
}

}  // namespace

int main(int argument_count, char** arguments) {
  course::Notebook notebook(argument_count, arguments);
  std::printf("after 1 s        by force               by acceleration\n");
  const auto drop = [](const char* name, const Particled& body) {
    const double by_force = fall_by_force(body), by_acceleration = fall_by_acceleration(body);
    std::printf("%-14s   %-20.17g   %-.17g\n", name, by_force, by_acceleration);
    return std::abs(by_force - by_acceleration);
  };
  const double pebble = drop("pebble, 0.05 kg", make_particle(0.05));
  const double boulder = drop("boulder, 700 kg", make_particle(700.0));
  const double wall = drop("wall, static", make_static_particle<double>(Vec3d::Zero()));
  notebook.value("difference", course::number("%.1g m", std::max(pebble, boulder)));
  course::expect(wall == 0, "a static body does not fall either way");
}
