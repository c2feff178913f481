// A mistake, run on purpose: the first-order rule without its normalising.
#include <support/record.hpp>
#include <tumble/orientation.hpp>

using namespace tumble;

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  const Vec3d omega(0, 0, 6);
  const double h = 1.0 / 60;
  std::printf("  time    norm      predicted   rim of a wheel of 1 m   normalised\n");
  Quaterniond never, always;
  for (int n = 1; n <= 600; ++n) {
    //! [never]
    never = never + h * orientation_rate(never, omega);
    //! [never]
    always = turn_first_order(always, omega, h);
    const double predicted = std::pow(1 + 0.1 * 0.1 / 4, n / 2.0);
    support::expect(std::abs(norm(never) / predicted - 1) < 1e-12, "root of 1 + (omega h/2)^2");
    if (n == 1 || n == 60 || n == 300 || n == 600) {
      const double rim = (never * pure<double>({1, 0, 0}) * conjugate(never)).imaginary.norm();
      std::printf("%6.3f s   %7.5f   %7.5f   %16.4f m   %10.4f m\n", n * h, norm(never), predicted,
                  rim, rotate(always, {1, 0, 0}).norm());
      if (n == 600) {
        notebook.value("rim", support::number("%.1f", rim));
        support::expect(angle_between(never, always) < 1e-12, "and yet the angle is the same");
      }
    }
  }
}
