// Gravity as a force and as an acceleration, on a pebble, on a boulder and on a wall.
#include <support/record.hpp>
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
  support::Notebook notebook(argument_count, arguments);
  std::printf("after 1 s         by force              by acceleration\n");
  const auto drop = [](const char* name, const Particled& body) {
    const double by_force = fall_by_force(body), by_acceleration = fall_by_acceleration(body);
    std::printf("%-15s   %-19.16g   %-.16g\n", name, by_force, by_acceleration);
    return std::abs(by_force - by_acceleration);
  };
  drop("stone, 0.17 kg", make_particle(0.17));
  drop("boulder, 700 kg", make_particle(700.0));
  support::expect(drop("wall, static", make_static_particle<double>(Vec3d::Zero())) == 0,
                  "a static body does not fall either way");

  int different = 0;
  double largest = 0;
  for (int n = 1; n <= 1000; ++n) {
    const Particled body = make_particle(0.01 * n);
    const double difference = std::abs(fall_by_force(body) - fall_by_acceleration(body));
    if (difference != 0) ++different;
    largest = std::max(largest, difference);
  }
  std::printf("\nOf 1000 masses up to 10 kg, %d differ, by %.1g m at most.\n", different, largest);
  notebook.value("different", std::to_string(different));
  notebook.value("difference", support::number("%.0e m", largest));
}
