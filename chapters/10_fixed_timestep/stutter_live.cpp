// A ball that rolls evenly, live: drawn at its last state and between two, on a screen whose frames
// are no steps of the world.
#include <support/live.hpp>
#include <tumble/interpolation.hpp>
#include <tumble/semi_implicit_euler.hpp>
#include <tumble/step_clock.hpp>

using namespace tumble;

void tumble::support::run_live(Live& live) {
  const auto rate = static_cast<std::int64_t>(live.knob("rate", "1/s", 60, 20, 240));
  const auto frames = static_cast<std::int64_t>(live.knob("frames", "1/s", 144, 20, 240));
  const double slower = live.knob("slower", "", 24, 1, 48);

  StepClock clock = make_step_clock(steps_per_second(rate));
  const double time_step = time_step_of<double>(clock.step);
  Particled ball = make_particle(1.0, Vec3d(0, 0, 0), Vec3d(3, 0, 0));
  Pose<double> previous, current;

  std::vector<double>&time = live.column("time", "s"), &shown_at = live.column("shown at", "s"),
  &last = live.column("last state", "cm"), &between = live.column("between two", "cm");
  // It has been rolling for two steps and more: before that there are no two states to lie between.
  const std::int64_t second = 1'000'000'000, first = 3 * frames / rate + 2;
  const std::int64_t end = first + (frames + 3) / 4;  // a quarter of a second
  double start = 0;
  for (std::int64_t frame = 0; frame <= end; ++frame) {
    const std::int64_t due =
        steps_due(clock, (frame + 1) * second / frames - frame * second / frames);
    for (std::int64_t n = 0; n < due; ++n) {
      previous = current;
      step(ball, time_step);
      current.position = ball.position;
    }
    const double drawn =
        interpolated(previous, current, fraction_of_step<double>(clock)).position.x();
    if (frame < first) continue;
    if (frame == first) start = drawn;
    time.push_back(static_cast<double>(frame - first) / static_cast<double>(frames));
    shown_at.push_back(slower * time.back());
    last.push_back(100 * (current.position.x() - start));
    between.push_back(100 * (drawn - start));
  }
}
