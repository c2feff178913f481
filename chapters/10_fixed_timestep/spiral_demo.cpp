// The spiral of death, on a clock of its own: a step that takes longer than the time it simulates.
#include <support/record.hpp>
#include <tumble/step_clock.hpp>

using namespace tumble;
using tumble::support::number;

namespace {

const std::int64_t millisecond = 1'000'000, second = 1'000'000'000;

struct Run {
  StepClock clock;
  std::int64_t longest_frame = 0;
  int frames = 0;
};

/// Plays for `duration` nanoseconds. A frame costs 6 ms and each of its steps 4 ms; but a step that
/// is begun between the first and the fourth second costs 25 ms, for something happens there.
Run play(StepClock clock, std::int64_t duration, support::Table table) {
  Run run{.clock = clock};
  std::int64_t now = 0, frame = second / 60;
  while (now < duration) {
    const std::int64_t due = steps_due(run.clock, frame);
    const double simulated = simulated_time<double>(run.clock);
    std::int64_t work = 6 * millisecond;
    for (std::int64_t step = 0; step < due; ++step) {
      const bool is_slow = now + work >= second && now + work < 4 * second;
      work += is_slow ? 25 * millisecond : 4 * millisecond;
    }
    frame = std::max(work, second / 60);  // the screen does not show more than 60 frames
    table.row(double(now) / 1e9, double(frame) / 1e6, simulated);
    now += frame;
    table.row(double(now) / 1e9, double(frame) / 1e6, simulated);
    run.longest_frame = std::max(run.longest_frame, frame);
    ++run.frames;
  }
  return run;
}

}  // namespace

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  //! [caps]
  const StepClock capped = make_step_clock(steps_per_second(60), 250 * millisecond, 4);
  const StepClock uncapped = make_step_clock(steps_per_second(60), 3600 * second, 1'000'000);
  //! [caps]
  const auto show = [&notebook](const char* name, const StepClock& clock) {
    const Run run = play(
        clock, 10 * second,
        notebook.table(std::string("spiral_") + name, {"time (s)", "frame (ms)", "simulated (s)"}));
    std::printf("%-9s %5d frames, the longest %6.0f ms; simulated %6.2f s, dropped %5.2f s\n", name,
                run.frames, double(run.longest_frame) / 1e6, simulated_time<double>(run.clock),
                dropped_time<double>(run.clock));
    return run;
  };
  const Run with_cap = show("capped", capped), without = show("uncapped", uncapped);
  notebook.value("longest_capped", number("%.0f ms", double(with_cap.longest_frame) / 1e6));
  notebook.value("longest_uncapped", number("%.2f s", double(without.longest_frame) / 1e9));
  notebook.value("dropped", number("%.1f s", dropped_time<double>(with_cap.clock)));
  support::expect(with_cap.longest_frame == 106 * millisecond, "the cap bounds the frame");
  support::expect(without.longest_frame > 2 * with_cap.longest_frame, "without a cap frames grow");
  support::expect(without.clock.dropped_time == 0 && without.clock.dropped_steps == 0,
                  "nothing is dropped without a cap");

  std::printf("\nif it never ends, without a cap:\nframe        steps    duration\n");
  StepClock clock = uncapped;
  std::int64_t frame = 17 * millisecond;
  for (int n = 0; n <= 20; ++n) {
    const std::int64_t due = steps_due(clock, frame);
    frame = 6 * millisecond + due * 25 * millisecond;
    if (n % 5 == 0)
      std::printf("%5d %12d %9.2f s\n", n, static_cast<int>(due), double(frame) / 1e9);
  }
  notebook.value("twentieth", number("%.0f s", double(frame) / 1e9));
}
