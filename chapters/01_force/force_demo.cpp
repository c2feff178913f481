// A ball is thrown three times, with coarser and finer steps, and compared with the exact parabola;
// and what the page's two drawings of a step are drawn from.
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

/// One long step: where the velocities before and after the kick lead, and the kick itself.
void draw_step(support::Notebook& notebook) {
  const double h = 0.5;
  support::Table table =
      notebook.table("kick_drift", {"kind", "x (m)", "z (m)", "dx (m)", "dz (m)"});
  const auto row = [&](const char* kind, const Vec3d& from, const Vec3d& by) {
    table.row(kind, from.x(), from.z(), by.x(), by.z());
  };
  Particled ball = make_particle(0.4, Vec3d(0, 0, 0), throw_velocity);
  const Vec3d start = ball.position, old_way = h * ball.velocity;
  add_gravity(ball, gravity);
  kick(ball, h);
  drift(ball, h);
  const Vec3d new_way = ball.position - start;
  row("old", start, old_way);
  row("kick", start + old_way, new_way - old_way);
  row("new", start, new_way);
  row("ball", start, Vec3d::Zero());
  row("ball", ball.position, Vec3d::Zero());
  row("old name", 0.55 * old_way, Vec3d::Zero());
  row("kick name", start + old_way + 0.4 * (new_way - old_way), Vec3d::Zero());
  row("new name", 0.6 * new_way, Vec3d::Zero());
  notebook.value("drawn_step", number("%.1f s", h));
}

/// The velocity upwards of the ball and of ten steps, each of which keeps one velocity.
void draw_staircase(const support::Notebook& notebook) {
  const int steps = 10;
  const double h = double(seconds) / steps;
  support::Table table = notebook.table(
      "staircase", {"time (s)", "true velocity (m/s)", "velocity of the steps (m/s)"});
  Particled ball = make_particle(0.4, Vec3d(0, 0, 0), throw_velocity);
  double lost = 0;  // the triangles' area
  for (int n = 0; n < steps; ++n) {
    const double before = throw_velocity.z() + n * h * gravity.z(),
                 after = before + h * gravity.z();
    add_gravity(ball, gravity);
    step(ball, h);
    clear_force(ball);
    table.row(n * h, before, ball.velocity.z());
    table.row((n + 1) * h, after, ball.velocity.z());
    lost += h * ((before + after) / 2 - ball.velocity.z());
  }
  support::expect(std::abs(exact_position(seconds).z() - ball.position.z() - lost) < 1e-12,
                  "the triangles are what the steps miss");
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
  draw_step(notebook);
  draw_staircase(notebook);
}
