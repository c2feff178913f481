// A ball is thrown three times, with coarser and finer steps, and compared with the exact parabola.
#include <support/record.hpp>
#include <tumble/force.hpp>

using namespace tumble;
using tumble::support::number;

namespace {

const Vec3d gravity(0, 0, -9.81);
const Vec3d throw_velocity(8, 0, 10);
const int seconds = 2;

Vec3d exact_position(double time) {
  return throw_velocity * time + gravity * (time * time / 2);
}

/// The ball's height at the end of its flight.
double height_thrown(int steps_per_second) {
  //! [throw]
  const double time_step = checked_time_step(1.0 / steps_per_second);
  Particled ball = make_particle(0.4, Vec3d(0, 0, 0), throw_velocity);
  for (int n = 0; n < seconds * steps_per_second; ++n) {
    add_gravity(ball, gravity);
    step(ball, time_step);
    clear_force(ball);
  }
  //! [throw]
  return ball.position.z();
}

}  // namespace

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  const double exact = exact_position(seconds).z();
  std::printf("The parabola is at %.4f m after %d s.\n\n", exact, seconds);
  std::printf("steps per second   height      too low by   g h t / 2\n");
  for (const int steps_per_second : {10, 20, 60}) {
    const double height = height_thrown(steps_per_second);
    const double predicted = -gravity.z() / steps_per_second * seconds / 2;
    std::printf("%16d   %8.4f m   %8.4f m   %8.4f m\n", steps_per_second, height, exact - height,
                predicted);
    notebook.value(number("error_%.0f", steps_per_second), number("%.4f m", exact - height));
    support::expect(std::abs(exact - height - predicted) < 1e-12 * seconds * steps_per_second,
                    "the ball is too low by g h t / 2");
  }
}
