// A ball falls under gravity and damping until its speed no longer changes.
#include <functional>
#include <support/damping_forms.hpp>
#include <support/record.hpp>
#include <tumble/damping.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

const double gravity = 9.81;

double terminal_speed(const std::function<double(double)>& next) {
  double speed = 0;
  for (int n = 0; n < 100'000; ++n) speed = next(speed);
  return speed;
}

}  // namespace

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  const double rate = 2;  // k, 1/s
  support::Table ratios = notebook.table(
      "terminal", {"k h", "exponential", "fractional after", "linear after", "fractional before"});
  std::printf("terminal speed for g/k = %.3f m/s\n", gravity / rate);
  std::printf(
      "steps per second   kick, e^(-k h)   kick, 1/(1 + k h)   kick, 1 - k h   1/(1 + k h), "
      "kick\n");
  for (int n = 1; n <= 40; ++n) {
    const double h = 0.025 * n / rate, gain = h * gravity;
    const double kept = fraction_kept(rate, h), fractional = fractional_form(rate, h),
                 linear = linear_form(rate, h);
    const auto ratio = [&](auto next) { return terminal_speed(next) * rate / gravity; };
    ratios.row(rate * h, ratio([=](double v) { return (v + gain) * kept; }),
               ratio([=](double v) { return (v + gain) * fractional; }),
               ratio([=](double v) { return (v + gain) * linear; }),
               ratio([=](double v) { return v * fractional + gain; }));
  }
  for (const int steps : {10, 30, 60, 240}) {
    const double h = 1.0 / steps, gain = h * gravity;
    const double kept = fraction_kept(rate, h), fractional = fractional_form(rate, h),
                 linear = linear_form(rate, h);
    const double exponential = terminal_speed([=](double v) { return (v + gain) * kept; });
    std::printf("%16d %12.3f m/s %15.3f m/s %11.3f m/s %12.3f m/s\n", steps, exponential,
                terminal_speed([=](double v) { return (v + gain) * fractional; }),
                terminal_speed([=](double v) { return (v + gain) * linear; }),
                terminal_speed([=](double v) { return v * fractional + gain; }));
    support::expect(std::abs(exponential - gain / std::expm1(rate * h)) < 1e-12,
                    "kick and exponential damping end at h g / (e^(k h) - 1)");
    if (steps == 60)
      notebook.value("slow_at_60", number("%.1f %%", 100 * (1 - exponential * rate / gravity)));
  }
}
