// Three clocks: one adds up a float, one a double, one counts steps.
#include <support/record.hpp>
#include <tumble/step_clock.hpp>

using namespace tumble;
using tumble::support::number;

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  support::Table table = notebook.table(
      "clocks", {"time (s)", "float is off by (s)", "double is off by (s)", "n h is off by (s)"});
  const std::int64_t steps = 100'000'000;
  const double time_step = 1.0 / 60;
  float added_float = 0;
  double added_double = 0;
  std::int64_t stopped_after = 0, off_by_a_second = 0;
  std::printf("     steps   time               float t += h      double t += h         n h\n");
  std::int64_t next_row = 60, next_line = 1000;
  double double_most = 0;  // of the rows that the figure draws
  for (std::int64_t n = 1; n <= steps; ++n) {
    const float before = added_float;
    added_float += static_cast<float>(time_step);
    added_double += time_step;
    if (added_float == before && stopped_after == 0) stopped_after = n - 1;
    if (off_by_a_second == 0 && std::abs(double(added_float) - double(n) / 60) >= 1)
      off_by_a_second = n;
    if (n != next_row && n != next_line) continue;
    const long double exact = static_cast<long double>(n) / 60;
    const double counted = static_cast<double>(n) * time_step;
    const auto off = [exact](double time) { return static_cast<double>(time - exact); };
    if (n == next_row) {
      double_most = std::max(double_most, std::abs(off(added_double)));
      table.row(double(exact), std::abs(off(double(added_float))) + 1e-18,
                std::abs(off(added_double)) + 1e-18, std::abs(off(counted)) + 1e-18);
      next_row = next_row * 5 / 4;
    }
    if (n == next_line) {
      std::printf("%10lld   %14.6f s %+14.6f s %+16.3e s %+12.1e s\n", static_cast<long long>(n),
                  double(exact), off(double(added_float)), off(added_double), off(counted));
      next_line *= 10;
    }
  }
  std::printf("\nthe float stopped at %.0f s, after %lld additions\n", double(added_float),
              static_cast<long long>(stopped_after));
  support::expect(added_float == 524288.0f && stopped_after == 24'986'955,
                  "a float that adds up 1/60 stops at 2^19");
  const double drift = added_double - 1e8 / 60;
  support::expect(drift > -7.0e-4 && drift < -6.8e-4,
                  "a double is off by -6.9e-4 s after 1e8 steps");
  notebook.value("minutes", number("%.0f", double(off_by_a_second) / 3600));
  notebook.value("stopped_days", number("%.1f", double(stopped_after) / 60 / 86400));
  notebook.value("double_most", number("%.1f milliseconds", 1000 * double_most));
}
