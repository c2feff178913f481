// A tumbling body is damped: its energy and its angular momentum only fall, its speed does not.
#include <support/record.hpp>
#include <support/uneven_top.hpp>
#include <tumble/damping.hpp>

using namespace tumble;
using namespace tumble::support;

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  Topd top = uneven_top(Vec3d(0.01, 1.2, 2));
  const double time_step = 1.0 / 240, kept = fraction_kept(0.01, time_step);
  const double speed = angular_velocity_body(top).norm(), energy = kinetic_energy(top),
               momentum = top.angular_momentum_body.norm();
  support::Table table =
      notebook.table("tumbling", {"time (s)", "angular speed", "energy", "angular momentum"});
  std::printf("  time   |w|       energy    |L|       relative to the start\n");
  double largest = 1, previous_energy = energy;
  for (int n = 0; n <= 240 * 12; ++n) {
    const double now = angular_velocity_body(top).norm() / speed;
    const double energy_now = kinetic_energy(top) / energy;
    const double momentum_now = top.angular_momentum_body.norm() / momentum;
    largest = std::max(largest, now);
    if (n % 24 == 0) table.row(n * time_step, now, energy_now, momentum_now);
    if (n % 240 == 0 && n <= 240 * 8)
      std::printf("%4d s   %.4f    %.4f    %.4f\n", n / 240, now, energy_now, momentum_now);
    drift(top, time_step);
    damp(top, kept);
    support::expect(kinetic_energy(top) < previous_energy, "the energy falls in every step");
    previous_energy = kinetic_energy(top);
  }
  notebook.value("largest", number("%.3f", largest));
  support::expect(largest > 1.03, "the angular speed rises above its start");
}
