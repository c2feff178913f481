/// @file
/// What the benchmark measured: a time for each contender, scene, precision, count and number of
/// threads.
#pragma once

#include <benchmark/benchmark.h>

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <support/bench/setting.hpp>

namespace tumble::support::bench {

/// One thing to measure.
struct Case {
  std::string contender;  ///< such as "our world"
  Scene scene = Scene::everything;
  std::string precision = "float";
  std::size_t count = 1;
  int threads = 1;

  std::string name() const {
    return contender + ", " + std::string(name_of(scene)) + ", " + precision + ", " +
           std::to_string(count) + " bodies, " + std::to_string(threads) +
           (threads == 1 ? " thread" : " threads");
  }
};

/// The shortest time of each case, ns per body and step. The machine can only add to what a loop
/// needs, so the shortest of several is the least wrong.
class Measurements : public benchmark::ConsoleReporter {
 public:
  Measurements() : ConsoleReporter(OO_Tabular) {}

  /// Measures `repetitions` times `steps` steps of what `make` makes, after one step that does not
  /// count. One thread is charged the time that it computed, two the time that went by.
  template <class Make>
  void add(const Case& subject, int repetitions, std::int64_t steps, const Make& make) {
    const std::string name = subject.name();
    auto* const measured =
        benchmark::RegisterBenchmark(
            name.c_str(),
            [=](benchmark::State& state) {
              const auto bodies = make();
              bodies->run(1);
              for (auto _ : state) bodies->run(static_cast<int>(steps));
              state.SetItemsProcessed(steps * static_cast<std::int64_t>(subject.count));
            })
            ->Iterations(1)
            ->Repetitions(repetitions);
    if (subject.threads > 1) measured->UseRealTime();
  }

  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.run_type != Run::RT_Iteration) continue;  // a mean, say
      const double time = 1e9 / run.counters.at("items_per_second");
      const auto [best, is_first] = times_.emplace(run.run_name.function_name, time);
      if (!is_first) best->second = std::min(best->second, time);
    }
    ConsoleReporter::ReportRuns(runs);
  }

  /// ns per body and step, where it was measured.
  std::optional<double> time(const Case& subject) const {
    const auto found = times_.find(subject.name());
    if (found == times_.end()) return {};
    return found->second;
  }

 private:
  std::map<std::string, double> times_;  // by the names of their cases
};

}  // namespace tumble::support::bench
