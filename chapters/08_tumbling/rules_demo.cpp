// Seven rules on four problems: energy, angular momentum and phase together.
#include <course/record.hpp>
#include <course/rules.hpp>

using namespace tumble;
using course::Motion;
using course::number;

namespace {

/// As the page shows it: two digits, "rounding" where nothing but rounding is left.
std::string shown(double error, double rounding) {
  return error < rounding ? "rounding" : number("%.1e", error);
}

template <class Real>
void compare(course::Notebook& notebook, const std::string& precision, double rounding) {
  for (const course::TumblingProblem& problem : course::tumbling_problems) {
    course::Table table = notebook.table(
        std::string("problem_") + problem.letter + "_" + precision,
        {"rule", "energy error", "E/E₀ at the end", "angular momentum error", "angle error (rad)"});
    std::printf("%c %-14s %s\n", problem.letter, problem.name.data(), precision.c_str());
    for (const course::Rule<Real>& rule : course::rules<Real>) {
      const Motion m = course::watched<Real>(problem, rule.turn);
      const std::string name = std::string(1, problem.letter) + "_" + precision + "_" +
                               number("%.0f", double(&rule - course::rules<Real>.data()));
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
  course::Notebook notebook(argument_count, arguments);
  compare<double>(notebook, "double", 1e-11);
  compare<float>(notebook, "float", 1e-11);
  const Motion implicit =
      course::watched<double>(course::tumbling_problems[0], turn_implicitly<double>);
  notebook.value("implicit_lost", number("%.0f %%", 100 * (1 - implicit.energy_ratio)));
}
