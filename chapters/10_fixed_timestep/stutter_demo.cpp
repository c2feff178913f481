// A ball rolls evenly; the physics runs at 60 steps a second and the screen at 144 frames.
#include <support/record.hpp>
#include <tumble/interpolation.hpp>
#include <tumble/semi_implicit_euler.hpp>
#include <tumble/step_clock.hpp>

using namespace tumble;
using tumble::support::number;

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  support::Table table =
      notebook.table("stutter", {"frame", "last state (cm)", "interpolated (cm)"});
  std::printf("frame   steps   moved: last state   moved: interpolated\n");
  //! [loop]
  StepClock clock = make_step_clock(steps_per_second(60));
  const double time_step = time_step_of<double>(clock.step);
  Particled ball = make_particle(1.0, Vec3d(0, 0, 0), Vec3d(3, 0, 0));
  Posed previous, current;

  const auto next_frame = [&](std::int64_t nanoseconds) {
    const std::int64_t due = steps_due(clock, nanoseconds);
    for (std::int64_t n = 0; n < due; ++n) {
      previous = current;
      step(ball, time_step);
      current.position = ball.position;
    }
    return interpolated(previous, current, fraction_of_step<double>(clock));
  };
  //! [loop]
  double drawn_last = 0, drawn_between = 0, smallest = 1, largest = 0;
  for (int frame = 0; frame < 144; ++frame) {
    const std::int64_t steps_before = clock.steps;
    const std::int64_t second = 1'000'000'000;
    const Posed between = next_frame((frame + 1) * second / 144 - frame * second / 144);
    const double moved_last = current.position.x() - drawn_last;
    const double moved_between = between.position.x() - drawn_between;
    drawn_last = current.position.x();
    drawn_between = between.position.x();
    if (frame >= 5) {  // until there are two states to draw between
      smallest = std::min(smallest, moved_between);
      largest = std::max(largest, moved_between);
    }
    if (frame < 12 || frame > 143)
      std::printf("%5d %7d %15.2f cm %18.2f cm\n", frame, int(clock.steps - steps_before),
                  100 * moved_last, 100 * moved_between);
    if (frame < 24) table.row(frame, 100 * drawn_last, 100 * drawn_between);
  }
  notebook.value("pose_float", std::to_string(sizeof(Pose<float>)));
  notebook.value("pose_double", std::to_string(sizeof(Pose<double>)));
  notebook.value("even", number("%.2f cm", 100 * largest));
  support::expect(largest - smallest < 1e-7, "between the states the ball moves evenly");
  support::expect(clock.steps == 60, "a second has 60 steps");
}
