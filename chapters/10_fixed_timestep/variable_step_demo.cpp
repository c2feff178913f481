// A mistake, run on purpose: the duration of each frame is used as the time step.
#include <support/record.hpp>
#include <tumble/semi_implicit_euler.hpp>
#include <tumble/step_clock.hpp>

using namespace tumble;
using tumble::support::number;

namespace {

/// How high a jump of 5 m/s gets, stepped `steps_per_second` times a second.
double jump(double time_step) {
  Particled jumper = make_particle(70.0, Vec3d(0, 0, 0), Vec3d(0, 0, 5));
  double highest = 0;
  while (jumper.velocity.z() > 0) {
    accelerate(jumper, Vec3d(0, 0, -9.81), time_step);
    step(jumper, time_step);
    highest = std::max(highest, jumper.position.z());
  }
  return highest;
}

/// The same jump on a screen with `frames` frames a second, stepped by the clock.
double jump_by_clock(int frames) {
  StepClock clock = make_step_clock(steps_per_second(60));
  Particled jumper = make_particle(70.0, Vec3d(0, 0, 0), Vec3d(0, 0, 5));
  double highest = 0;
  while (jumper.velocity.z() > 0)
    for (std::int64_t due = steps_due(clock, 1'000'000'000 / frames); due > 0; --due) {
      accelerate(jumper, Vec3d(0, 0, -9.81), time_step_of<double>(clock.step));
      step(jumper, time_step_of<double>(clock.step));
      highest = std::max(highest, jumper.position.z());
    }
  return highest;
}

}  // namespace

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  std::printf("a jump with 5 m/s: %.3f m on paper\n", 25 / (2 * 9.81));
  std::printf("frames per second   stepped by frames   by the clock, 60 steps\n");
  const double by_clock = jump_by_clock(60);
  for (const int frames : {20, 30, 60, 144, 240}) {
    std::printf("%17d %17.3f m %22.3f m\n", frames, jump(1.0 / frames), jump_by_clock(frames));
    support::expect(jump_by_clock(frames) == by_clock, "by the clock all jumps are equally high");
  }
  notebook.value("difference", number("%.0f cm", 100 * (jump(1.0 / 240) - jump(1.0 / 20))));

  // A weight on a spring with w = 54 rad/s: stable at 60 steps a second and at 30.
  const double w = 54;
  support::Table table = notebook.table(
      "variable_step", {"time (s)", "60 frames (m)", "30 frames (m)", "in turn (m)"});
  const auto largest_after = [w](double first, double second) {
    Particled weight = make_particle(1.0, Vec3d(1, 0, 0));
    double largest = 0;
    for (int n = 0; n * (first + second) / 2 < 1; ++n) {
      clear_force(weight);
      add_force(weight, -w * w * weight.position);
      step(weight, n % 2 == 0 ? first : second);
      largest = std::max(largest, std::abs(weight.position.x()));
    }
    return largest;
  };
  const double fast = largest_after(1.0 / 60, 1.0 / 60), slow = largest_after(1.0 / 30, 1.0 / 30);
  const double in_turn = largest_after(1.0 / 30, 1.0 / 60);
  std::printf("\na weight on a spring, w = %g rad/s: its largest swing in a second\n", w);
  std::printf("60 frames: %.2f m   30 frames: %.2f m   1/30 s and 1/60 s in turn: %.3g m\n", fast,
              slow, in_turn);
  support::expect(fast < 1.2 && slow < 2.4 && in_turn > 100,
                  "each step alone is stable, the two in turn are not");
  notebook.value("steady", number("%.1f m", std::max(fast, slow)));

  Particled even = make_particle(1.0, Vec3d(1, 0, 0)), coarse = even, turns = even;
  const auto pull_and_step = [w](Particled& weight, double time_step) {
    clear_force(weight);
    add_force(weight, -w * w * weight.position);
    step(weight, time_step);
  };
  for (int n = 0; n <= 12; ++n) {
    // Three of the steps of 1/60 s are one of 1/30 s and one of 1/60 s.
    table.row(n * 0.05, std::abs(even.position.x()), std::abs(coarse.position.x()),
              std::abs(turns.position.x()));
    if (n == 10) notebook.value("half_a_second", number("%.0f m", std::abs(turns.position.x())));
    for (int k = 0; k < 3; ++k) pull_and_step(even, 1.0 / 60);
    for (int k = 0; k < (n % 2 == 0 ? 2 : 1); ++k) pull_and_step(coarse, 1.0 / 30);
    pull_and_step(turns, 1.0 / 30);
    pull_and_step(turns, 1.0 / 60);
  }
}
