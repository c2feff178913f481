// How long a step a spring allows, and how its clock runs before that.
#include <support/record.hpp>
#include <tumble/semi_implicit_euler.hpp>

using namespace tumble;
using tumble::support::number;

namespace {

/// The largest |x| of a weight of 1 kg on a spring of 1 N/m, started 1 m off, in `steps` steps.
double amplitude(double time_step, int steps) {
  Particled weight = make_particle(1.0, Vec3d(1, 0, 0));
  double largest = 1;
  for (int n = 0; n < steps; ++n) {
    clear_force(weight);
    add_force(weight, -weight.position);
    step(weight, time_step);
    largest = std::max(largest, std::abs(weight.position.x()));
  }
  return largest;
}

}  // namespace

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  std::printf("    ωh   largest |x| of 1000 steps       1/√(1 − ω²h²/4)   period too short by\n");
  for (const double wh : {0.1, 0.5, 1.0, 1.5, 1.9, 1.99, 1.999, 2.001, 2.01}) {
    const double largest = amplitude(wh, 1000);
    if (wh < 2)
      std::printf("%6g %24.4g m %21.4g m %18.2f %%\n", wh, largest, 1 / std::sqrt(1 - wh * wh / 4),
                  100 * (1 - wh / 2 / std::asin(wh / 2)));
    else
      std::printf("%6g %24.2g m                 no bound\n", wh, largest);
    if (wh == 1.999) notebook.value("bounded", number("%.1f m", largest));
    if (wh == 2.001) notebook.value("unbounded", number("%.0e m", largest));
  }
  const double growth = amplitude(2.001, 1060) / amplitude(2.001, 1000);
  support::expect(std::abs(growth / std::exp(60 * 2 * std::acosh(2.001 / 2)) - 1) < 1e-9,
                  "beyond 2 a step grows by exp(2 acosh(ωh/2))");
  notebook.value("growth", number("%.0f", growth));
  support::expect(amplitude(1.999, 100'000) < 31.63, "ωh = 1.999 stays bounded");
  support::expect(amplitude(2.001, 1000) > 1e20, "ωh = 2.001 does not");

  support::Table measured = notebook.table("amplitude", {"ωh", "largest |x| (m)"});
  for (int n = 2; n <= 39; ++n) measured.row(n * 0.05, amplitude(n * 0.05, 2000));
  for (const double wh : {1.97, 1.98, 1.99, 1.995}) measured.row(wh, amplitude(wh, 2000));

  std::printf("\n");
  const double stiffness = 20'000, damping = 50, mass = 1.5;
  const double limit = largest_stable_time_step(stiffness, damping, 1 / mass);
  std::printf("%g kg on %g N/m with %g N s/m: stable up to h = %.2f ms, %.0f steps a second\n",
              mass, stiffness, damping, 1000 * limit, 1 / limit);
  notebook.value("stiff_rate", number("%.0f", 1 / limit));
}
