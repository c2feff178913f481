// Four formulas that are all called damping: what one step leaves, and what a second leaves.
#include <support/damping_forms.hpp>
#include <support/record.hpp>
#include <tumble/damping.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

/// What a second at `steps_per_second` leaves of a speed, if each step leaves `fraction`.
double after_a_second(double fraction, int steps_per_second) {
  Particled ball = make_particle(1.0, Vec3d(0, 0, 0), Vec3d(1, 0, 0));
  for (int n = 0; n < steps_per_second; ++n) damp(ball, fraction);
  return ball.velocity.x();
}

}  // namespace

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);

  std::printf("\"0.99 in every step\", and a rate of 0.603 per second, after one second\n");
  std::printf("steps per second   0.99 a step   e^(-k h)\n");
  //! [rate]
  const double rate = damping_rate_that_leaves(0.99, 1.0 / 60);
  //! [rate]
  for (const int steps : {30, 60, 144, 240}) {
    const double by_rate = after_a_second(fraction_kept(rate, 1.0 / steps), steps);
    std::printf("%16d %13.4f %10.4f\n", steps, after_a_second(0.99, steps), by_rate);
    support::expect(std::abs(by_rate - std::pow(0.99, 60)) < 1e-13, "the rate means a second");
  }
  notebook.value("left_at_30", number("%.0f %%", 100 * after_a_second(0.99, 30)));
  notebook.value("left_at_144", number("%.0f %%", 100 * after_a_second(0.99, 144)));

  std::printf("\nwhat one step leaves of a speed\n   k h    e^(-k h)   1 - k h   1/(1 + k h)\n");
  for (const double kh : {0.01, 0.1, 0.5, 1.0, 1.5, 2.5})
    std::printf("%6g %11.5f %9.3f %13.5f\n", kh, fraction_kept(kh, 1.0), linear_form(kh, 1.0),
                fractional_form(kh, 1.0));

  std::printf("\nten steps of k h = 2.5 with the linear form:\n");
  double speed = 1;
  for (int n = 0; n < 10; ++n) {
    speed *= linear_form(2.5, 1.0);
    std::printf(" %.3g", speed);
  }
  std::printf("\n");
  notebook.value("linear_blow_up", number("%.0f", std::abs(speed)));
  support::expect(std::abs(speed) > 50, "the linear form speeds up what it should stop");
}
