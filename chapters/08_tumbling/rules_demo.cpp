// Seven rules on four problems: energy, angular momentum and phase together.
#include <numbers>
#include <support/record.hpp>
#include <support/rules.hpp>

using namespace tumble;
using support::Motion;
using support::number;

namespace {

/// As the page shows it: two digits, "rounding" where nothing but rounding is left.
std::string shown(double error, double rounding) {
  return error < rounding ? "rounding" : number("%.1e", error);
}

void write_problems(support::Notebook& notebook) {
  support::Table table = notebook.table(
      "problems", {"body", "moments (kg m²)", "start (rad/s)", "turn in one step (rad)"});
  const auto three = [](const std::array<double, 3>& values) {
    return number("%.8g, ", values[0]) + number("%.8g, ", values[1]) + number("%.8g", values[2]);
  };
  for (const support::TumblingProblem& problem : support::tumbling_problems) {
    const auto& [x, y, z] = problem.angular_velocity;
    table.row(std::string(1, problem.letter) + ", " + std::string(problem.name),
              three(problem.moments), three(problem.angular_velocity),
              number("%#.2g", std::hypot(x, y, z) / 60));
  }
}

template <class Real>
void compare(support::Notebook& notebook, const std::string& precision, double rounding) {
  for (const support::TumblingProblem& problem : support::tumbling_problems) {
    support::Table table = notebook.table(
        std::string("problem_") + problem.letter + "_" + precision,
        {"rule", "energy error", "E/E₀ at the end", "angular momentum error", "angle error (rad)"});
    std::printf("%c %-14s %s\n", problem.letter, problem.name.data(), precision.c_str());
    for (const support::Rule<Real>& rule : support::rules<Real>) {
      const Motion m = support::watched<Real>(problem, rule.turn);
      const std::string name = std::string(1, problem.letter) + "_" + precision + "_" +
                               number("%.0f", double(&rule - support::rules<Real>.data()));
      if (m.diverged != 0) {
        const std::string gone = "grew 1000-fold by step " + std::to_string(m.diverged);
        std::printf("  %-28s %s\n", rule.name, gone.c_str());
        table.row(rule.name, gone, "", "", "");
        notebook.value(name + "_diverged", std::to_string(m.diverged));
        continue;
      }
      std::printf("  %-28s energy %8s  E/E0 %7.4f  momentum %8s  angle %7.1e rad\n", rule.name,
                  shown(m.energy_error, rounding).c_str(), m.energy_ratio,
                  shown(m.momentum_error, rounding).c_str(), m.angle);
      table.row(rule.name, shown(m.energy_error, rounding), number("%.4f", m.energy_ratio),
                shown(m.momentum_error, rounding), number("%.1e", m.angle));
      notebook.value(name + "_energy", number("%.0e", m.energy_error));
      notebook.value(name + "_ratio", number("%.3f", m.energy_ratio));
      notebook.value(name + "_momentum", number("%.0e", m.momentum_error));
      notebook.value(name + "_angle", number("%.0e", m.angle));
    }
  }
}

}  // namespace

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  write_problems(notebook);
  compare<double>(notebook, "double", 1e-11);
  compare<float>(notebook, "float", 1e-11);
  const Motion implicit =
      support::watched<double>(support::tumbling_problems[0], turn_implicitly<double>);
  notebook.value("implicit_lost", number("%.0f %%", 100 * (1 - implicit.energy_ratio)));

  // What the length of L keeps, shown by problem A at 3.3 rad a step: the energy between L²/2I₃ and
  // L²/2I₁ and no better.
  Topd top = support::top_of<double>(support::tumbling_problems[0]);
  const double energy = kinetic_energy(top), square = top.angular_momentum_body.squaredNorm();
  const double step = 3.3 / angular_velocity_body(top).norm();
  double least = 1, most = 1;
  for (int n = 0; n < 100'000; ++n) {
    turn_by_splitting(top, step);
    least = std::min(least, kinetic_energy(top) / energy);
    most = std::max(most, kinetic_energy(top) / energy);
  }
  support::expect(least < 0.8 && most > 1.5, "at 3.3 rad a step the energy is not kept");
  support::expect(least >= square / 6 / energy && most <= square / 2 / energy,
                  "but it stays where the length of L holds it");
  notebook.value("long_step_least", number("%.2f", least));
  notebook.value("long_step_most", number("%.2f", most));

  // The steady rule leads L round the cone about ω that it starts on: by twice the angle between
  // the two, at the far side.
  const Topd start = support::top_of<double>(support::tumbling_problems[0]);
  const double sine = gyroscopic_torque(start).norm() /
                      (angular_velocity_body(start).norm() * start.angular_momentum_body.norm());
  notebook.value("steady_swing", number("%.0f°", 2 * std::asin(sine) * 180 / std::numbers::pi));
}
