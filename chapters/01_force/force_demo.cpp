// A ball is thrown, three times: with a coarse step, with a fine one, and as the exact parabola.
#include <course/record.hpp>
#include <tumble/force.hpp>

using namespace tumble;
using tumble::course::number;

namespace {

const Vec3d gravity(0, 0, -9.81);
const Vec3d throw_velocity(8, 0, 10);

Vec3d exact_position(double time) {
  return throw_velocity * time + gravity * (time * time / 2);
}

/// Throws the ball and writes a row a step; returns how far the last height is from the parabola.
double throw_ball(int steps_per_second, course::Table table) {
  const double time_step = checked_time_step(1.0 / steps_per_second);
  //! [throw]
  Particled ball = make_particle(0.4, Vec3d(0, 0, 0), throw_velocity);
  for (int n = 0; n <= 2 * steps_per_second; ++n) {
    const double time = n * time_step;
    table.row(time, ball.position.x(), ball.position.z(), exact_position(time).z());
    add_gravity(ball, gravity);
    step(ball, time_step);
    clear_force(ball);
  }
  //! [throw]
  return ball.position.z() - exact_position(2 + time_step).z();
}

}  // namespace

int main(int argument_count, char** arguments) {
  course::Notebook notebook(argument_count, arguments);
  std::printf("steps per second   height after 2 s is off by   a h t / 2\n");
  for (const int steps_per_second : {10, 20, 60}) {
    const std::string suffix = number("_%.0f", steps_per_second);
    const double error = throw_ball(
        steps_per_second, notebook.table("throw" + suffix, {"time (s)", "distance (m)",
                                                            "height (m)", "exact height (m)"}));
    const double predicted = gravity.z() / steps_per_second * 2 / 2;
    std::printf("%16d   %24.6f m   %7.4f m\n", steps_per_second, error, predicted);
    notebook.value("error" + suffix, number("%.3f m", error));
  }
}
