// The angle from the exact orientation after 10 s of problem A, against the time step.
#include <algorithm>
#include <support/record.hpp>
#include <support/rules.hpp>

using namespace tumble;
using support::number;

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  support::Table table =
      notebook.table("order", {"time step (s)", "steady", "explicit", "restored", "implicit",
                               "carrying", "by axes", "with a sphere"});
  const Topd start = support::top_of<double>(support::tumbling_problems[0]);
  const auto exact = exact::FreeTop<long double>(support::exactly(start)).at(10).orientation;
  std::printf("%-28s %9s %9s %9s  order\n", "angle error (rad), steps/s:", "60", "480", "3840");
  std::vector<std::array<double, 7>> errors;
  for (const int steps_per_second : {15, 30, 60, 120, 240, 480, 960, 1920, 3840}) {
    std::array<double, 7> error{};
    for (std::size_t rule = 0; rule < error.size(); ++rule) {
      Topd top = start;
      for (int n = 0; n < 10 * steps_per_second; ++n)
        support::rules<double>[rule].turn(top, 1.0 / steps_per_second);
      error[rule] = static_cast<double>(angle_between(exact, support::exactly(top).orientation));
    }
    table.row(1.0 / steps_per_second, error[0], error[1], error[2], error[3], error[4], error[5],
              error[6]);
    errors.push_back(error);
  }
  // How many times lower the worse of the splittings lies than the best of the others.
  const auto lower = [&errors](std::size_t row) {
    const std::array<double, 7>& error = errors[row];
    return *std::min_element(error.begin(), error.begin() + 5) / std::max(error[5], error[6]);
  };
  notebook.value("lower_at_first", number("%.0f", lower(0)));
  notebook.value("lower_in_the_end", number("%.0f", lower(8)));
  support::expect(lower(0) > 10 && lower(8) > 100 * lower(0),
                  "the splittings lie far below the others, the further the shorter the step");
  for (std::size_t rule = 0; rule < 7; ++rule) {
    const double order = std::log2(errors[7][rule] / errors[8][rule]);
    std::printf("%-28s %9.1e %9.1e %9.1e  %5.2f\n", support::rules<double>[rule].name,
                errors[2][rule], errors[5][rule], errors[8][rule], order);
    const double expected = rule == 0 ? 0 : rule < 5 ? 1 : 2;
    support::expect(std::abs(order - expected) < 0.05,
                    "each rule has the order that the page says");
  }
}
