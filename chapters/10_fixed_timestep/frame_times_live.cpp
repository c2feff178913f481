// The spiral of death, live: what a step costs from moment to moment is drawn by hand, and two caps
// say what a frame may take.
#include <support/live.hpp>
#include <tumble/step_clock.hpp>

using namespace tumble;

void tumble::support::run_live(Live& live) {
  const int most_steps = static_cast<int>(live.knob("most steps", "", 1000, 1, 1000));
  const double longest = live.knob("longest frame", "s", 5, 0.02, 5);
  const double picture = live.knob("picture", "ms", 6, 0, 16);

  // A quarter of a second each, ten in all.
  std::vector<double>& costs = live.column("cost", "ms");
  for (std::size_t n = 0; n < 40; ++n) {
    const double cost = n < live.drawn().size() ? live.drawn()[n] : n >= 4 && n < 16 ? 25 : 4;
    require_between("cost of a step", cost, "ms", 0, 60);
    costs.push_back(cost);
  }

  std::vector<double>&time = live.column("time", "s"), &frames = live.column("frame", "ms"),
  &simulated = live.column("simulated", "s"), &dropped = live.column("dropped", "s"),
  &taken = live.column("steps", "");
  // The account of each frame, in ms: what waited, what comes in, what is dropped, what waits then.
  std::vector<double>&waited = live.column("waited", "ms"), &paid = live.column("paid in", "ms"),
  &lost = live.column("lost", "ms"), &waits = live.column("waits", "ms");
  StepClock clock = make_step_clock(steps_per_second(60), nanoseconds_of(longest), most_steps);
  const std::int64_t end = 10'000'000'000, shortest = 1'000'000'000 / 60;
  std::int64_t now = 0, frame = shortest;
  while (now < end) {
    const double step_ms = 1000 * time_step_of<double>(clock.step);
    const double dropped_before = dropped_time<double>(clock);
    waited.push_back(step_ms * fraction_of_step<double>(clock));
    paid.push_back(static_cast<double>(frame) / 1e6);
    const std::int64_t due = steps_due(clock, frame);
    lost.push_back(1000 * (dropped_time<double>(clock) - dropped_before));
    waits.push_back(step_ms * fraction_of_step<double>(clock));
    // Each step costs what is drawn for the moment in which it begins.
    double work = picture * 1e6;
    for (std::int64_t n = 0; n < due; ++n) {
      const auto slot = static_cast<std::size_t>((static_cast<double>(now) + work) / 250e6);
      work += 1e6 * costs[std::min<std::size_t>(slot, costs.size() - 1)];
    }
    frame = std::max(nanoseconds_of(work / 1e9), shortest);  // no more than 60 frames a second
    time.push_back(static_cast<double>(now) / 1e9);
    frames.push_back(static_cast<double>(frame) / 1e6);
    simulated.push_back(simulated_time<double>(clock));
    dropped.push_back(dropped_time<double>(clock));
    taken.push_back(static_cast<double>(due));
    now += frame;
  }
}
