#include <support/bench/report.hpp>

using namespace tumble::support;
using namespace tumble::support::bench;

/// many_bodies_bench [FOLDER] [--full] [Google Benchmark's options]: measures, prints the tables
/// and writes them to the folder.
int main(int argument_count, char** arguments) {
  std::vector<char*> passed_on = {arguments[0]}, own = {arguments[0]};
  // All kinds take turns, so that a busy moment of the machine does not hit one of them alone.
  std::string take_turns = "--benchmark_enable_random_interleaving=true";
  passed_on.push_back(take_turns.data());
  bool full = false;
  for (int i = 1; i < argument_count; ++i) {
    const std::string_view argument = arguments[i];
    if (argument == "--full")
      full = true;
    else
      (argument.starts_with("--") ? passed_on : own).push_back(arguments[i]);
  }
  int passed_count = static_cast<int>(passed_on.size());
  benchmark::Initialize(&passed_count, passed_on.data());
  if (benchmark::ReportUnrecognizedArguments(passed_count, passed_on.data())) return EXIT_FAILURE;

  Notebook notebook(static_cast<int>(own.size()), own.data());
  const Extent extent = full ? full_extent() : quick_extent();
  Measurements measurements;
  const Contest contest(measurements, extent);
  std::ofstream log(notebook.file_in_folder("many_bodies_bench.log"));
  measurements.SetOutputStream(&log);
  benchmark::RunSpecifiedBenchmarks(&measurements);
  const Report report(measurements, contest, extent, notebook);
#ifndef TUMBLE_HAS_BULLET
  std::cout << "\nBullet was not measured, for libbullet-dev is not installed.\n";
#endif
#ifndef TUMBLE_HAS_ODE
  std::cout << "\nODE was not measured, for libode-dev is not installed.\n";
#endif
}
