// A fourth-order rule that evaluates the torque once a step is of first order.
#include <support/record.hpp>
#include <support/rules.hpp>
#include <tumble/ladder.hpp>

using namespace tumble;

namespace {

/// A torque that swings; or one that stands still where it was at the start of the step.
struct Swinging {
  void operator()(Topd& top, double time) const {
    if (std::isnan(frozen_at))
      top.torque = {0.6 * std::cos(2 * time), 0.4 * std::sin(3 * time), 0.3};
  }
  double frozen_at = std::numeric_limits<double>::quiet_NaN();
};

Topd after_ten_seconds(int steps_per_second, bool evaluated_once) {
  const double h = 1.0 / steps_per_second;
  const Swinging swinging;
  Topd top = support::top_of<double>(support::tumbling_problems[0]);
  for (int n = 0; n < 10 * steps_per_second; ++n) {
    swinging(top, n * h);
    const Swinging seen = evaluated_once ? Swinging{n * h} : swinging;
    step_by_runge_kutta<Kutta>(top, seen, n * h, h);
  }
  return top;
}

}  // namespace

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  const Topd truth = after_ten_seconds(20000, false);
  std::printf("%-34s %9s %9s  order\n", "angle error (rad), steps/s:", "60", "120");
  for (const bool once : {false, true}) {
    const auto error = [&](int steps_per_second) {
      return angle_between(after_ten_seconds(steps_per_second, once).orientation,
                           truth.orientation);
    };
    const double order = std::log2(error(60) / error(120));
    std::printf("%-34s %9.1e %9.1e  %5.2f\n",
                once ? "torque evaluated once a step" : "torque evaluated at each stage", error(60),
                error(120), order);
    support::expect(std::abs(order - (once ? 1 : 4)) < 0.1, "the order that the page says");
  }
}
