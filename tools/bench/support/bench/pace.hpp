/// @file
/// Whether all steps take about as long: single steps, each timed by the processor's own clock.
#pragma once

#include <algorithm>
#include <ctime>
#include <memory>
#include <vector>

namespace tumble::support::bench {

/// Of many single steps of one world, ns each.
struct Pace {
  double median = 0, slowest_of_hundred = 0;  ///< 99 of 100 steps take at most the latter
};

/// The time in which this thread has computed, ns. What else the machine does is not counted.
inline double computed() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return 1e9 * static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec);
}

/// Steps `bodies` so often, after one step that does not count.
template <class Bodies>
Pace pace_of(Bodies& bodies, std::size_t steps) {
  bodies.run(1);
  std::vector<double> times(steps);
  for (double& time : times) {
    const double begun = computed();
    bodies.run(1);
    time = computed() - begun;
  }
  std::sort(times.begin(), times.end());
  return {.median = times[steps / 2], .slowest_of_hundred = times[steps - 1 - steps / 100]};
}

}  // namespace tumble::support::bench
