// Two balls slow down in air: one as air does it, one by damping that agrees with it at the start.
#include <support/record.hpp>
#include <tumble/damping.hpp>
#include <tumble/drag.hpp>

using namespace tumble;
using tumble::support::number;

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  const double pi = 3.14159265358979323846, time_step = 1.0 / 240, start = 30;
  //! [ball]
  const double radius = 0.11, mass = 0.43;  // a football
  const double coefficient = drag_coefficient(1.2, 0.47, pi * radius * radius);
  const double rate = coefficient * start / mass;  // the same deceleration at 30 m/s
  //! [ball]
  Particled dragged = make_particle(mass, Vec3d(0, 0, 0), Vec3d(start, 0, 0)), damped = dragged;
  support::Table table = notebook.table(
      "drag", {"time (s)", "drag (m/s)", "damping (m/s)", "drag (m)", "damping (m)"});
  std::printf("c = %.4f kg/m, and a damping rate of %.3f 1/s\n", coefficient, rate);
  std::printf("  time   speed: drag   damping  distance: drag   damping\n");
  const double kept = fraction_kept(rate, time_step);
  const auto note = [&notebook](const char* name, const Particled& ball) {
    notebook.value(name, number("%.1f m/s", ball.velocity.x()));
  };
  for (int n = 0; n <= 240 * 64; ++n) {
    if (n % 60 == 0 && n <= 240 * 12)
      table.row(n * time_step, dragged.velocity.x(), damped.velocity.x(), dragged.position.x(),
                damped.position.x());
    if (n == 6 * 240) note("damped_6", damped);
    if (n == 12 * 240) note("dragged_12", dragged);
    const int second = n / 240;
    if (n % 240 == 0 && (second & (second - 1)) == 0)
      std::printf("%4d s %9.3f m/s %8.3f m/s %9.2f m %8.2f m\n", second, dragged.velocity.x(),
                  damped.velocity.x(), dragged.position.x(), damped.position.x());
    clear_force(dragged);
    add_force(dragged, quadratic_drag(coefficient, dragged.velocity, Vec3d(0, 0, 0)));
    kick(dragged, time_step);
    drift(dragged, time_step);
    damp(damped, kept);
    drift(damped, time_step);
  }
  notebook.value("stops_after", number("%.0f m", start / rate));
  support::expect(damped.position.x() < start / rate, "the damped ball stops within v/k");
  support::expect(dragged.position.x() > 2 * damped.position.x(), "the other one goes on");

  std::printf("\nterminal speed of a fall, in m/s\n  mass   drag: root of m g/c   damping: g/k\n");
  for (const double kilograms : {0.1, 0.4, 1.6})
    std::printf("%5.1f kg %15.2f %20.2f\n", kilograms, std::sqrt(kilograms * 9.81 / coefficient),
                9.81 / rate);

  const double fastest = 2 * mass / (coefficient * (1.0 / 60));
  std::printf("\nat 60 steps a second the drag of this ball explodes beyond %.0f m/s\n", fastest);
  notebook.value("fastest", number("%.0f m/s", fastest));
  // A feather: 0.1 g, 20 cm² and a shape number of 1.
  const double of_feather = drag_coefficient(1.2, 1.0, 20e-4);
  notebook.value("fastest_feather", number("%.0f m/s", 2 * 1e-4 / (of_feather * (1.0 / 60))));
}
