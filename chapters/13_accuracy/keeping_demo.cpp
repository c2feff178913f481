// What methods keep: energy and angular momentum of problem A over ten minutes, 20 steps a second,
// and how much longer it takes until splitting's error of the energy is no longer the larger one.
#include <support/record.hpp>
#include <support/rules.hpp>
#include <tumble/ladder.hpp>

using namespace tumble;

namespace {

constexpr long steps_per_second = 20;

double energy_error(const Topd& top, double of) {
  return std::abs(kinetic_energy(top) / of - 1);
}

}  // namespace

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  support::Table energy = notebook.table(
      "energy", {"time (s)", "augmented", "Runge-Kutta", "Lie Runge-Kutta", "splitting"});
  support::Table momentum = notebook.table(
      "momentum",
      {"time (s)", "augmented", "Runge-Kutta", "Lie Runge-Kutta", "splitting", "midpoint"});
  const Topd start = support::top_of<double>(support::tumbling_problems[0]);
  const double E = kinetic_energy(start);
  const Vec3d L = angular_momentum_world(start);
  const std::array methods = {turn_by_augmented_rule<double>, turn_by_runge_kutta<Kutta, double>,
                              turn_by_lie_runge_kutta<double>, turn_by_splitting<double>,
                              turn_by_implicit_midpoint<double>};
  std::array<Topd, 5> tops;
  tops.fill(start);
  std::array<double, 5> worst_energy{}, worst_momentum{}, shown_momentum{};
  long steps = 0;
  double drawn = 1;  // s, up to which the energy is drawn: its axis is logarithmic
  const auto step_all = [&](std::size_t count) {
    ++steps;
    for (std::size_t m = 0; m < count; ++m) {
      methods[m](tops[m], 1.0 / steps_per_second);
      worst_energy[m] = std::max(worst_energy[m], energy_error(tops[m], E));
    }
    const double time = static_cast<double>(steps) / steps_per_second;
    if (time < drawn) return;
    energy.row(time, worst_energy[0], worst_energy[1], worst_energy[2], worst_energy[3]);
    drawn = std::max(time + 1, 1.05 * time);
  };
  constexpr long seconds = 600;
  while (steps < seconds * steps_per_second) {
    step_all(methods.size());
    for (std::size_t m = 0; m < methods.size(); ++m) {
      const double off = (angular_momentum_world(tops[m]) - L).norm() / L.norm();
      shown_momentum[m] = std::max(shown_momentum[m], off);
      worst_momentum[m] = std::max(worst_momentum[m], off);
    }
    if (steps % (5 * steps_per_second) != 0) continue;  // the largest of each five seconds is drawn
    momentum.row(static_cast<double>(steps) / steps_per_second, shown_momentum[0],
                 shown_momentum[1], shown_momentum[2], shown_momentum[3], shown_momentum[4]);
    shown_momentum.fill(0);
  }
  std::printf("%-24s %12s %12s\n", "largest error in 600 s", "energy", "momentum");
  const char* names[] = {"augmented second order", "Runge-Kutta", "Lie Runge-Kutta", "splitting",
                         "implicit midpoint"};
  for (std::size_t m = 0; m < methods.size(); ++m)
    std::printf("%-24s %12.1e %12.1e\n", names[m], worst_energy[m], worst_momentum[m]);

  // All but the midpoint rule, which stays at rounding, go on from where they are, until the
  // classical rule's error is larger than splitting's.
  const double ahead = worst_energy[3] / worst_energy[1], of_splitting = worst_energy[3];
  const long too_long = 100L * 3600 * steps_per_second;
  while (worst_energy[1] < worst_energy[3] && steps < too_long) step_all(4);
  const double hours = static_cast<double>(steps) / (3600.0 * steps_per_second);
  const long drawn_steps = 2 * steps;  // as far again, for the drawing
  while (steps < drawn_steps) step_all(4);
  std::printf("\nAfter %.1f hours the error of Runge-Kutta is the larger one.\n", hours);
  notebook.value("overtaken_hours", support::number("%.1f", hours));
  notebook.value("ahead", support::number("%.0f", ahead));
  support::expect(steps < 2 * too_long, "splitting overtakes the classical rule");
  support::expect(worst_energy[3] < 1.01 * of_splitting, "the error of splitting does not climb");
  const double rounding = 1e-11;  // 12,000 steps of a few roundings each
  support::expect(worst_momentum[0] < rounding && worst_momentum[2] < rounding &&
                      worst_momentum[3] < rounding && worst_momentum[4] < rounding,
                  "every method but the classical one keeps L in the world");
  support::expect(worst_energy[4] < rounding, "the midpoint rule keeps the energy");
}
