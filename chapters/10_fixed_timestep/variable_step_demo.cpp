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
  support::Table table = notebook.table("variable_step", {"steps", "time (s)", "size (m)"});
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

  // Each run is drawn at its own times; by turns means 1/30 s, then 1/60 s, and again.
  const auto draw = [&](const char* run, double first, double second) {
    Particled weight = make_particle(1.0, Vec3d(1, 0, 0));
    double time = 0;
    for (int n = 0; time < 0.6 + 1e-9; ++n) {
      table.row(run, time, std::abs(weight.position.x()));
      clear_force(weight);
      add_force(weight, -w * w * weight.position);
      const double time_step = n % 2 == 0 ? first : second;
      step(weight, time_step);
      time += time_step;
      if (std::string_view(run) == "in turn" && std::abs(time - 0.5) < 1e-9)
        notebook.value("half_a_second", number("%.0f m", std::abs(weight.position.x())));
    }
  };
  draw("1/60 s", 1.0 / 60, 1.0 / 60);
  draw("1/30 s", 1.0 / 30, 1.0 / 30);
  draw("in turn", 1.0 / 30, 1.0 / 60);
}
