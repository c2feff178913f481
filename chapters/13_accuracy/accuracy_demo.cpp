// What accuracy costs in time: every method on every problem.
#include <limits>
#include <support/cheapest.hpp>
#include <support/items.hpp>
#include <support/record.hpp>

#include "contests.hpp"

using namespace tumble::support;

namespace {

std::string time_of(double nanoseconds) {
  return nanoseconds < 1e2   ? number("%.2g ns", nanoseconds)
         : nanoseconds < 1e3 ? number("%.3g ns", nanoseconds)
         : nanoseconds < 1e5 ? number("%.2g µs", nanoseconds / 1e3)
                             : number("%.3g µs", nanoseconds / 1e3);
}

/// As the book sets it: 2e-05 as 2 × 10⁻⁵, and 1e-05 as 10⁻⁵.
std::string set(double value) {
  const std::string text = number("%.0e", value);
  const std::size_t e = text.find('e');
  const int exponent = std::atoi(text.c_str() + e + 1);
  std::string power = exponent < 0 ? "10⁻" : "10";
  const std::array<const char*, 10> raised = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  for (const char digit : std::to_string(std::abs(exponent)))
    power += raised[static_cast<std::size_t>(digit - '0')];
  return text.substr(0, e) == "1" ? power : text.substr(0, e) + " × " + power;
}

/// A problem's name as the book sets it.
std::string set(std::string problem) {
  if (const std::size_t power = problem.find("^6"); power != std::string::npos)
    problem.replace(power, 2, "⁶");
  return problem;
}

std::string power_of_ten(double value) {
  return number("1e%.0f", std::log10(value));
}

std::string times(double ratio) {
  return number(ratio < 10 ? "%.1f ×" : "%.0f ×", ratio);
}

/// The text with blanks before or behind it, as many letters wide as wanted: µ is one letter.
std::string padded(const std::string& text, std::size_t width, bool on_the_left = false) {
  const auto letters = static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char byte) { return (byte & 0xC0) != 0x80; }));
  const std::string blanks(letters < width ? width - letters : 0, ' ');
  return on_the_left ? blanks + text : text + blanks;
}

/// The step of a run, or what it was asked for where it chooses its steps.
std::string knob_of(const Measurement& run) {
  return run.steps == 0 ? "tolerance " + set(run.knob) : number("%.2g s", run.knob);
}

void write_csv(const std::filesystem::path& file, const std::vector<Measurement>& all) {
  std::ofstream csv(file);
  csv << "problem,precision,method,kind,\"step (s) or tolerance\",steps,\"error (rad or m)\","
         "energy error,momentum error,ns per run,ns per simulated s\n";
  for (const Measurement& m : all)
    csv << '"' << m.problem << "\"," << m.precision << ",\"" << m.method << "\"," << m.kind << ','
        << number(m.knob) << ',' << m.steps << ',' << number("%.4g", m.error) << ','
        << number("%.4g", m.energy_error) << ',' << number("%.4g", m.momentum_error) << ','
        << number("%.4g", m.nanoseconds) << ',' << number("%.4g", m.nanoseconds / m.seconds)
        << '\n';
}

/// What the figures draw: all runs of one problem.
void write_runs(const Notebook& notebook, const std::string& table,
                const std::vector<Measurement>& all, const std::string& problem) {
  Table runs = notebook.table(table, {"method", "precision", "error", "ns per simulated s"});
  for (const Measurement& m : all)
    if (m.problem == problem)
      runs.row(m.method, m.precision, std::max(m.error, 1e-17), m.nanoseconds / m.seconds);
}

/// A row a problem: what meets the tolerance at what price. A library that never does has no
/// column.
void write_prices(const Notebook& notebook, const std::string& name,
                  const std::vector<Measurement>& all, const std::vector<std::string>& problems,
                  double wanted) {
  using Row = std::vector<std::string>;
  std::vector<Row> columns = {{"problem"},
                              {"cheapest"},
                              {"price of 1 s"},
                              {"cheapest that steps, its step or tolerance"},
                              {"its price"}};
  const std::array<const char*, 4> libraries = {"Odeint", "Simbody", "Bullet", "ODE"};
  for (const char* library : libraries) columns.push_back({library + std::string("'s")});
  for (const std::string& problem : problems) {
    const auto list = cheapest(all, problem, wanted);
    const auto first = first_of(list, is_ours), step = first_of(list, is_rung);
    if (!first) continue;
    const auto price = [&](const auto& run) {
      return run ? times(run->nanoseconds / first->nanoseconds) : std::string("–");
    };
    Row row = {set(problem), first->method, time_of(first->nanoseconds / first->seconds),
               step ? step->method + ", " + knob_of(*step) : "none does", price(step)};
    for (const char* library : libraries) row.push_back(price(first_of(list, is_of(library))));
    for (std::size_t n = 0; n < row.size(); ++n) columns[n].push_back(row[n]);
  }
  const auto is_empty = [](const Row& column) {
    return std::all_of(column.begin() + 1, column.end(), [](auto& cell) { return cell == "–"; });
  };
  columns.erase(std::remove_if(columns.begin() + 5, columns.end(), is_empty), columns.end());
  std::ofstream file(notebook.file_in_folder(name + ".tsv"));
  for (std::size_t n = 0; n < columns[0].size(); ++n)
    for (const Row& column : columns)
      file << column[n] << (&column == &columns.back() ? '\n' : '\t');
}

/// What a step of one length takes, ns, at best and in double.
double step_of(const std::vector<Measurement>& all, const std::string& problem,
               const char* method) {
  double best = std::numeric_limits<double>::infinity();
  for (const Measurement& m : all)
    if (m.problem == problem && m.precision == "double" && m.method == method && m.steps >= 100)
      best = std::min(best, m.nanoseconds / static_cast<double>(m.steps));
  return best;
}

/// What part of the time a step of Odeint's takes that ours of the same rule does, where what
/// differs is how the two are compiled: the symplectic Euler rule on springs, else the classical
/// one.
double fused_step(const std::vector<Measurement>& all, const std::string& problem) {
  const double by_euler =
      step_of(all, problem, "Odeint symplectic Euler") / step_of(all, problem, "kick and drift");
  return std::isfinite(by_euler)
             ? by_euler
             : step_of(all, problem, "Odeint rk4") / step_of(all, problem, "Runge-Kutta");
}

/// Why Odeint's is cheaper: because its step is fused, if ours would win with steps as much
/// shorter; if not, what the ratio would be then.
std::string reason_of(double ratio, double fused) {
  if (fused >= 1) return "none that a step shows";
  const std::string step = "a fused step takes " + number("%.2f", fused) + " of ours";
  return ratio >= fused ? step : step + "; " + number("%.2f", ratio / fused) + " is left";
}

/// Every pair of problem and tolerance by stepping alone: Odeint's cheapest by the cheapest of ours
/// that `may_compete`, and where that is under 1, what either did. `name` begins the names of what
/// is written.
void compare_step_by_step(Notebook& notebook, const std::vector<Measurement>& all,
                          const std::vector<std::string>& problems, const std::string& name,
                          bool (*may_compete)(const Measurement&), const char* what) {
  Table ratios = notebook.table(name, {"problem", "10⁻¹", "10⁻²", "10⁻³", "10⁻⁴", "10⁻⁵", "10⁻⁶",
                                       "10⁻⁷", "10⁻⁸", "10⁻⁹", "10⁻¹⁰"});
  struct Loss {
    double ratio;
    Measurement ours, theirs;
    int digits;
  };
  std::vector<Loss> losses;
  int pairs = 0;
  double least = 1e300, widest = 1;
  for (const std::string& problem : problems) {
    std::array<std::string, 10> cells;
    for (int digits = 1; digits <= 10; ++digits) {
      const auto list = cheapest(all, problem, std::pow(10, -digits));
      const auto ours = first_of(list, may_compete), theirs = first_of(list, is_of("Odeint"));
      cells[static_cast<std::size_t>(digits - 1)] = "–";
      if (!ours || !theirs) continue;
      const double ratio = theirs->nanoseconds / ours->nanoseconds;
      cells[static_cast<std::size_t>(digits - 1)] = number("%.2f", ratio);
      ++pairs;
      least = std::min(least, ratio);
      widest = std::max(
          {widest, ours->median / ours->nanoseconds, theirs->median / theirs->nanoseconds});
      if (ratio < 1) losses.push_back({ratio, *ours, *theirs, digits});
    }
    ratios.row(set(problem), cells[0], cells[1], cells[2], cells[3], cells[4], cells[5], cells[6],
               cells[7], cells[8], cells[9]);
  }
  std::sort(losses.begin(), losses.end(),
            [](const Loss& a, const Loss& b) { return a.ratio < b.ratio; });
  Table table = notebook.table(
      name + "_lost", {"ratio", "spread", "problem", "wanted", "ours", "Odeint's", "reason"});
  const auto told = [](const Measurement& run) {
    return run.method + ", " + knob_of(run) + ": " + time_of(run.nanoseconds);
  };
  for (const auto& [ratio, ours, theirs, digits] : losses) {
    const double fused = fused_step(all, ours.problem);
    table.row(number("%.2f", ratio),
              number("%.2f", theirs.nanoseconds / ours.median) + " to " +
                  number("%.2f", theirs.median / ours.nanoseconds),
              set(ours.problem), set(std::pow(10, -digits)), told(ours), told(theirs),
              reason_of(ratio, fused));
  }
  const int won = pairs - static_cast<int>(losses.size());
  notebook.value(name + "_least", number("%.2f", least));
  notebook.value(name + "_pairs", std::to_string(pairs));
  notebook.value(name + "_won", std::to_string(won));
  notebook.value(name + "_spread", number("%.0f", 100 * (widest - 1)));
  std::printf("%s: in %d of %d pairs, and the smallest ratio is %.2f\n", what, won, pairs, least);
}

/// What a step of each rung takes on chapter 8's problems, and an answer of the exact solution, ns:
/// what the live figure multiplies its numbers of steps by.
void write_step_prices(const Notebook& notebook, const std::vector<Measurement>& all) {
  Table table = notebook.table("step_prices", {"rung", "A", "B", "C", "D"});
  const auto row = [&](const std::string& name, const auto& price) {
    std::array<std::string, 4> cells;
    for (std::size_t n = 0; n < cells.size(); ++n) {
      const TumblingProblem& problem = tumbling_problems[n];
      const double ns = price(std::string(1, problem.letter) + " " + std::string(problem.name));
      cells[n] = std::isfinite(ns) ? number("%.3g", ns) : std::string("–");
    }
    table.row(name, cells[0], cells[1], cells[2], cells[3]);
  };
  for (const auto& rung : tumble::turning_ladder<double>)
    row(std::string(rung.name), [&](const std::string& problem) {
      return step_of(all, problem, std::string(rung.name).c_str());
    });
  row("exact solution", [&](const std::string& problem) {
    const auto answer = std::find_if(all.begin(), all.end(), [&](const Measurement& m) {
      return m.problem == problem && m.precision == "double" && m.kind == "exact";
    });
    return answer == all.end() ? std::numeric_limits<double>::infinity() : answer->nanoseconds;
  });
}

/// Over all problems and wanted errors: how often ours is no dearer than Odeint's cheapest.
void compare_with_odeint(Notebook& notebook, const std::vector<Measurement>& all,
                         const std::vector<std::string>& problems) {
  int pairs = 0, won = 0;
  double worst_free = 1e300, worst_fast = 1e300;
  for (const std::string& problem : problems)
    for (int digits = 1; digits <= 10; ++digits) {
      const double wanted = std::pow(10, -digits);
      const auto list = cheapest(all, problem, wanted);
      const auto ours = first_of(list, is_ours), odeint = first_of(list, is_of("Odeint"));
      if (!ours || !odeint) continue;
      const double ratio = odeint->nanoseconds / ours->nanoseconds;
      ++pairs;
      won += ratio >= 1;
      const bool is_free = problem[1] == ' ' || problem == "T-handle";
      if (is_free && digits >= 5) worst_free = std::min(worst_free, ratio);
      if (problem == "heavy top, fast" || problem[0] == 'C' || problem[0] == 'D')
        worst_fast = std::min(worst_fast, ratio);
    }
  notebook.value("pairs", std::to_string(pairs));
  notebook.value("won", std::to_string(won));
  notebook.value("worst_free", number("%.1f", worst_free));
  notebook.value("worst_fast", number("%.1f", worst_fast));
  std::printf("with the exact solutions: in %d of %d pairs\n", won, pairs);
}

/// The other libraries that were measured on tops: how often ours is no dearer than the cheapest of
/// them, and which were not there.
void compare_with_the_others(Notebook& notebook, const std::vector<Measurement>& all,
                             const std::vector<std::string>& problems) {
  Table table = notebook.table("others", {"library", "its errors reach", "pairs", "ours cheaper in",
                                          "by the factor, at least", "at most"});
  for (const char* name : {"Odeint", "Simbody", "Bullet", "ODE"}) {
    int pairs = 0, won = 0;
    double least = 1e300, most = 0, best_error = 1e300;
    for (const Measurement& run : all)
      if (run.kind == name && run.problem == problems[0])
        best_error = std::min(best_error, run.error);
    for (const std::string& problem : problems)
      for (int digits = 1; digits <= 10; ++digits) {
        const auto list = cheapest(all, problem, std::pow(10, -digits));
        const auto ours = first_of(list, is_ours), theirs = first_of(list, is_of(name));
        if (!ours || !theirs) continue;
        const double ratio = theirs->nanoseconds / ours->nanoseconds;
        ++pairs;
        won += ratio >= 1;
        least = std::min(least, ratio);
        most = std::max(most, ratio);
      }
    if (pairs == 0) {
      std::printf("%s was not measured, for it is not installed.\n", name);
      continue;
    }
    table.row(name, set(best_error), std::to_string(pairs), std::to_string(won), times(least),
              times(most));
  }
}

/// The smallest error that any method reached on a problem.
double floor_of(const std::vector<Measurement>& all, const std::string& problem,
                const char* precision) {
  double floor = 1e300;
  for (const Measurement& m : all)
    if (m.problem == problem && m.precision == precision && is_rung(m))
      floor = std::min(floor, m.error);
  return floor;
}

/// The smallest error that a method which steps has on a problem, in double, for no more than the
/// time of one exact answer.
double error_for_the_exact_price(const std::vector<Measurement>& all, const std::string& problem) {
  double price = 0, error = 1e300;
  for (const Measurement& m : all)
    if (m.problem == problem && m.precision == "double" && m.kind == "exact") price = m.nanoseconds;
  for (const Measurement& m : all)
    if (m.problem == problem && m.precision == "double" && is_rung(m) && m.nanoseconds <= price)
      error = std::min(error, m.error);
  return error;
}

/// How many times as long a method takes as another for an error of a tenth, in double.
double times_as_long(const std::vector<Measurement>& all, const std::string& problem,
                     const char* method, const char* other) {
  const auto list = cheapest(all, problem, 0.1);
  const auto price = [&](const char* name) {
    const auto run = first_of(list, [&](const Measurement& m) { return m.method == name; });
    return run ? run->nanoseconds : std::numeric_limits<double>::quiet_NaN();
  };
  return price(method) / price(other);
}

/// The contest in which one problem is measured, or none.
Contest contest_on(const std::string& problem) {
  Contest contest{wanted_effort(), problem};
  for (const auto hold : {free_tops, heavy_tops, driven_tops, moving_points}) hold(contest);
  return contest;
}

std::string text_of(const std::vector<Measurement>& all) {
  std::string text;
  for (const Measurement& m : all) {
    for (const std::string& word : {m.problem, m.precision, m.method, m.kind}) text += word + '\t';
    text += std::to_string(m.steps);
    for (const double value :
         {m.knob, m.error, m.energy_error, m.momentum_error, m.nanoseconds, m.median, m.seconds})
      text += '\t' + number(value);
    text += '\n';
  }
  return text;
}

std::vector<Measurement> measurements_in(const std::string& text) {
  std::vector<Measurement> all;
  for (const std::vector<std::string>& row : cells_of(text)) {
    const auto value = [&](std::size_t n) { return std::strtod(row.at(n).c_str(), nullptr); };
    all.push_back({row.at(0), row.at(1), row.at(2), row.at(3), value(5), std::stol(row.at(4)),
                   value(6), value(7), value(8), value(9), value(10), value(11)});
  }
  return all;
}

}  // namespace

int main(int argument_count, char** arguments) {
  const std::vector<std::string> problems = contest_on("").problems;
  Items items;  // prices are compared on one problem
  for (const std::string& problem : problems)
    items.add(problem, [problem] { return text_of(contest_on(problem).measured); });
  if (!items.are_wanted()) return 0;

  Notebook notebook(argument_count, arguments);
  std::vector<Measurement> all;
  for (const std::string& problem : problems) append(all, measurements_in(items.result(problem)));
  write_csv(notebook.file_in_folder("accuracy.csv"), all);
  write_runs(notebook, "runs_ordinary", all, problems[0]);
  write_runs(notebook, "runs_rod", all, problems[2]);
  write_runs(notebook, "runs_driven", all, "driven top");
  write_runs(notebook, "runs_orbit", all, "eccentric orbit");
  const std::vector<std::string> few = {problems[0], problems[2], "driven top", "eccentric orbit"};
  write_prices(notebook, "prices_few", all, few, 1e-6);
  for (const double wanted : {1e-2, 1e-6, 1e-10})
    write_prices(notebook, "prices_" + power_of_ten(wanted), all, problems, wanted);

  std::printf("The cheapest for an error of 1e-6 rad or m (double):\n\n%-17s %-30s %9s  %s\n",
              "problem", "cheapest", "per s", "cheapest that steps");
  for (const std::string& problem : problems) {
    const auto list = cheapest(all, problem, 1e-6);
    const auto first = first_of(list, is_ours), step = first_of(list, is_rung);
    if (!first || !step) continue;
    std::printf("%-17s %s %s  %s, %s\n", problem.c_str(), padded(first->method, 30).c_str(),
                padded(time_of(first->nanoseconds / first->seconds), 9, true).c_str(),
                step->method.c_str(), times(step->nanoseconds / first->nanoseconds).c_str());
  }
  std::printf("\nOurs costs no more than Odeint's cheapest, for errors from 1e-1 to 1e-10:\n");
  compare_step_by_step(notebook, all, problems, "alike", is_alike, "stepping the same numbers");
  compare_step_by_step(notebook, all, problems, "stepping", is_rung, "stepping fewer numbers too");
  compare_with_odeint(notebook, all, problems);
  compare_with_the_others(notebook, all, problems);
  write_step_prices(notebook, all);
  notebook.value("runs", std::to_string(all.size()));
  notebook.value("problems", std::to_string(problems.size()));
  notebook.value("float_floor", number("%.0e", floor_of(all, problems[0], "float")));
  notebook.value("error_for_the_exact_price",
                 number("%.0e", error_for_the_exact_price(all, problems[0])));
  notebook.value("rod_times",
                 number("%.0f", times_as_long(all, problems[2], "Runge-Kutta", "splitting")));
  notebook.value("fused_step", number("%.2f", fused_step(all, "soft spring")));
  notebook.value("double_floor", number("%.0e", floor_of(all, problems[0], "double")));
}
