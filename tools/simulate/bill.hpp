/// @file
/// What each effect costs, in nanoseconds for each body and step.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <numeric>
#include <tumble/packed_parts.hpp>
#include <tumble/world.hpp>

namespace tumble::simulate {

/// The parts of a step run in their order on a copy of the bodies, and the clock is read before and
/// after each; beside them run whole steps on a copy of the world. So all lines come from one
/// run. Each round takes a few milliseconds and begins where the world is now. We
/// report the median of the rounds, less what reading the clock costs.
template <class Real, class Backend>
class Bill {
  using Clock = std::chrono::steady_clock;

 public:
  /// `most_steps` is how many steps are known to succeed.
  Bill(World<Real, Backend> world, std::int64_t most_steps)
      : world_(std::move(world)),
        parts_(world_.backend().parts(world_.step_plan())),
        passes_(parts_.size()) {
    samples_.resize(passes_ + 1);
    steps_in_round_ = 1;
    while (2 * steps_in_round_ <= std::min<std::int64_t>(most_steps, 1 << 16) && round() < 2e6)
      steps_in_round_ *= 2;
    for (std::vector<double>& sample : samples_) sample.clear();
    const Clock::time_point begin = Clock::now();
    for (int n = 0; n < 5 || (n < 100 && Clock::now() - begin < std::chrono::seconds(1)); ++n)
      round();
  }

  std::string table() {
    std::vector<double> times;
    for (std::size_t i = 0; i < passes_; ++i) times.push_back(median(samples_[i]));
    const double sum = std::accumulate(times.begin(), times.end(), 0.0);
    std::string text = line("effect", "bodies", "ns per body and step", "part of the step");
    for (std::size_t i = 0; i < passes_; ++i)
      text += line(parts_[i].name, std::to_string(parts_[i].bodies),
                   number(times[i] / static_cast<double>(parts_[i].bodies)),
                   number(100 * times[i] / sum) + " %");
    const std::size_t count = world_.body_count();
    return text + line("a whole step", std::to_string(count),
                       number(median(samples_.back()) / static_cast<double>(count)), "");
  }

 private:
  static std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, value < 99.95 ? "%.1f" : "%.0f", value);
    return text;
  }
  static std::string line(const std::string& effect, const std::string& bodies,
                          const std::string& time, const std::string& part) {
    char text[160];
    std::snprintf(text, sizeof text, "%-28.28s  %10s  %20s  %18s\n", effect.c_str(), bodies.c_str(),
                  time.c_str(), part.c_str());
    return text;
  }
  static double median(std::vector<double>& sample) {
    const auto middle = sample.begin() + static_cast<std::ptrdiff_t>(sample.size() / 2);
    std::nth_element(sample.begin(), middle, sample.end());
    return *middle;
  }
  static double nanoseconds(Clock::duration time) {
    return std::chrono::duration<double, std::nano>(time).count();
  }

  /// One round of the passes, one of whole steps. @return how long the latter took, ns
  double round() {
    std::vector<double> times(passes_ + 1, 0.0);
    double looking = 0;
    World<Real, Backend> world = world_, measured = world_;
    for (std::int64_t step = 0; step < steps_in_round_; ++step) {
      const Real h = world_.time_step();
      const StepTime<Real> moment{world_.time() + static_cast<Real>(step) * h, h};
      for (std::size_t i = 0; i < passes_; ++i) {
        const Clock::time_point before = Clock::now();
        measured.backend().run_part(measured.step_plan(), i, moment);
        times[i] += nanoseconds(Clock::now() - before);
      }
      const Clock::time_point before = Clock::now();
      looking += nanoseconds(Clock::now() - before);
    }
    const Clock::time_point before = Clock::now();
    for (std::int64_t step = 0; step < steps_in_round_; ++step) world.step();
    times.back() = nanoseconds(Clock::now() - before);
    for (std::size_t i = 0; i < times.size(); ++i) {
      const double lost = i < passes_ ? looking : 0;
      samples_[i].push_back(std::max(0.0, times[i] - lost) / static_cast<double>(steps_in_round_));
    }
    return times.back();
  }

  World<Real, Backend> world_;
  std::vector<PackedPart> parts_;
  std::size_t passes_;
  std::vector<std::vector<double>> samples_;  // ns for each step, of the passes and of the whole
  std::int64_t steps_in_round_ = 1;
};

}  // namespace tumble::simulate
