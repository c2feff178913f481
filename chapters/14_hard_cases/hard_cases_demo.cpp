// Every method of the book for a free top on every hard case: who passes, who fails, by how much.
#include <numbers>
#include <support/on_page.hpp>
#include <support/other_methods.hpp>
#include <support/record.hpp>
#include <support/trial.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

/// A letter for each case in double and in float: '.' passes, E, L or P is wrong in the energy, the
/// angular momentum or the phase, D diverges. The chapter talks about these, so they must be so.
struct Expected {
  const char *method, *in_double, *in_single;
};
constexpr std::array<Expected, 32> expected = {{
    {"steady", "LLL.P..L", "LLL.P..L"},
    {"explicit", "DDDDDD.D", "DDDDDD.D"},
    {"explicit, |L| restored", "LELEP..L", "LEEEP..L"},
    {"implicit, one Newton step", "ELLEP..E", "ELLEP..E"},
    {"linearly implicit", "EPLEP..P", "EPLEP..P"},
    {"momentum-carrying", "EEEEP..E", "EEEEP..E"},
    {"implicit midpoint", "PPP.P..P", "PP..P..P"},
    {"Lie midpoint", "..P.P..P", "EE..PD.P"},
    {"augmented second order", "EEEDP..E", "EEEDPD.E"},
    {"splitting by axes", "..P.P..P", "..EEP..P"},
    {"splitting", ".......P", ".......P"},
    {"Runge-Kutta", "..LDDD.E", "..LDDD.E"},
    {"Lie Runge-Kutta", "..EDPD.E", ".EEDDD.E"},
    {"splitting, Suzuki", ".......E", ".......E"},
    {"splitting, Blanes-Moan 4", "........", "........"},
    {"Dormand-Prince 5", "..LDDD.E", "..LDDD.E"},
    {"splitting, Yoshida", ".......P", ".......P"},
    {"splitting, Blanes-Moan 6", "........", "LL......"},
    {"Dormand-Prince 8", "..LEDD..", "..LEDD.E"},
    {"splitting, Kahan-Li 8", "........", "L......."},
    {"splitting, Sofroniou-Spaletta", "........", "LL....P."},
    {"splitting without a sine", "PPP.P..P", "PP..P..P"},
    {"L apart, Dormand-Prince 5", "..EEP..E", "EEEEPD.E"},
    {"L apart, Dormand-Prince 8", "...EPD..", "EEEEPD.E"},
    {"5(4), own steps", "..L.P...", "...E...."},
    {"8(5,3), own steps", "..L.P...", "..LE...E"},
    {"L apart, 5(4), own steps", "....P...", "EEE....E"},
    {"L apart, 8(5,3), own steps", "....P...", "EEE....E"},
    {"splitting, own steps", ".......P", ".......P"},
    {"splitting, Suzuki, own steps", "........", "L.LE...L"},
    {"splitting, Kahan-Li 8, own steps", "........", "L.LE...L"},
    {"exact solution", "........", "........"},
}};

/// A cell of the table: the worst of the three against its limit, or the step of the end.
std::string words_of(const Verdict& verdict, const Limits& limits) {
  if (verdict.fault == 'D') return "✗ step " + std::to_string(verdict.diverged);
  if (limits.energy == any_error) return "✓ finite";
  const std::string quantity = verdict.worst == 'P' ? "φ" : std::string(1, verdict.worst);
  return (verdict.fault == '.' ? "✓ " : "✗ ") + quantity + number(" %.0e", verdict.error);
}

/// The table of one precision: on the page with numbers, on the screen with letters.
template <class Real>
int tabulated(const Notebook& notebook, const char* name, const char* title,
              const char* Expected::*column) {
  const std::array<HardCase<Real>, 8> cases = hard_cases<Real>();
  Table table =
      notebook.table(name, {"method", cases[0].name, cases[1].name, cases[2].name, cases[3].name,
                            cases[4].name, cases[5].name, cases[6].name, cases[7].name});
  std::printf("\n%-33s A B C D 20 100 crawl fast\n", title);
  const std::vector<TurningRung<Real>> all = all_methods<Real>();
  expect(all.size() == expected.size(), "the chapter knows each method's letters");
  int surprises = 0;
  for (std::size_t m = 0; m < expected.size(); ++m) {
    std::string found;
    std::array<std::string, 8> cells;
    std::printf("%-33s", std::string(all[m].name).c_str());
    for (std::size_t n = 0; n < cells.size(); ++n) {
      const Verdict verdict = tried(cases[n], all[m]);
      found += verdict.fault;
      cells[n] = words_of(verdict, cases[n].limits);
      std::printf("%*c", n < 5 ? 2 : n < 7 ? 4 : 6, verdict.fault);
    }
    std::printf("\n");
    table.row(all[m].name, cells[0], cells[1], cells[2], cells[3], cells[4], cells[5], cells[6],
              cells[7]);
    const Expected& known = expected[m];
    if (all[m].name == known.method && found == known.*column) continue;
    std::fprintf(stderr, "expected of '%s': %s, not %s of '%s'\n", known.method, known.*column,
                 found.c_str(), std::string(all[m].name).c_str());
    ++surprises;
  }
  return surprises;
}

const TurningRung<double>& method_called(const std::vector<TurningRung<double>>& all,
                                         std::string_view name) {
  return *std::find_if(all.begin(), all.end(), [&](const auto& each) { return each.name == name; });
}

/// How many turns a row makes in one step, with the sphere's.
template <class Row>
std::string turns_of() {
  return std::to_string(Row::row.kicks.size() + Row::row.drifts.size() + 1);
}

/// The largest error of the energy so far, over ten minutes of problem A at a radian a step: which
/// errors only waver, and which add up.
void follow_errors(const Notebook& notebook, const std::vector<TurningRung<double>>& all) {
  const HardCase<double> fast = fast_case<double>();
  const double start = kinetic_energy(fast.top);
  const std::array<std::string_view, 4> names = {"splitting", "splitting, Blanes-Moan 4",
                                                 "Dormand-Prince 8", "L apart, Dormand-Prince 8"};
  Table table = notebook.table("adding_up", {"time (s)", names[0], names[1], names[2], names[3]});
  std::array<Topd, 4> tops;
  tops.fill(fast.top);
  std::array<double, 4> largest{};
  for (int n = 1, next = 1; n <= 10 * fast.steps; ++n) {
    for (std::size_t m = 0; m < tops.size(); ++m) {
      method_called(all, names[m]).turn(tops[m], fast.time_step);
      largest[m] = std::max(largest[m], std::abs(kinetic_energy(tops[m]) / start - 1));
    }
    if (n < next && n < 10 * fast.steps) continue;
    table.row(n * fast.time_step, largest[0], largest[1], largest[2], largest[3]);
    next = std::max(n + 1, n * 11 / 10);
  }
}

/// The default on what it does worst, beside three rivals: for longer, and on a faster body.
void try_default(Notebook& notebook) {
  const std::vector<TurningRung<double>> all = all_methods<double>();
  const auto on = [&all](std::string_view name, double angle, int minutes) {
    const HardCase<double> fast = fast_case<double>(angle);
    return watched<double>(fast.top, method_called(all, name).turn, minutes * fast.steps,
                           fast.steps_to_angle, fast.time_step);
  };
  follow_errors(notebook, all);
  const auto words = [](const Motion& motion) {
    return motion.diverged == 0 ? number("%.0e", motion.energy_error)
                                : "gone in step " + std::to_string(motion.diverged);
  };
  Table rivals =
      notebook.table("fast", {"method", "phase after a second", "energy, a minute",
                              "energy, ten minutes", "energy, a minute at 4 rad a step"});
  for (const std::string_view name :
       {"splitting", "splitting, Blanes-Moan 4", "Dormand-Prince 8", "L apart, Dormand-Prince 8"}) {
    const Motion minute = on(name, 1, 1);
    rivals.row(name, number("%.0e", minute.angle), words(minute), words(on(name, 1, 10)),
               words(on(name, 4, 1)));
  }
  const Motion minute = on("splitting", 1, 1), longer = on("splitting", 1, 10),
               faster = on("splitting", 4, 1), eighth = on("Dormand-Prince 8", 1, 1),
               eighth_longer = on("Dormand-Prince 8", 1, 10),
               eighth_faster = on("Dormand-Prince 8", 4, 1);
  expect(minute.angle > 0.1 && minute.energy_error > 5e-3,
         "the default is off by more than 0.1 rad and half a hundredth of the energy");
  expect(longer.energy_error < 1.1 * minute.energy_error && faster.diverged == 0,
         "but its error of the energy does not add up, and it stays finite");
  expect(eighth.energy_error < 1e-4 && eighth_longer.energy_error > 5 * eighth.energy_error &&
             eighth_longer.energy_error > 1e-4 && eighth_faster.diverged > 0,
         "that of the eighth order adds up, and the rule does not stay finite");
  int divided = 1;
  while (
      tried(stretched(fast_case<double>(), 1.0 / divided), method_called(all, "splitting")).fault !=
      '.')
    ++divided;
  notebook.value("fast_divided", std::to_string(divided));
  notebook.value("default_energy", number("%.1g", 100 * longer.energy_error) + " %");
  notebook.value("eighth_gone", std::to_string(eighth_faster.diverged));
  notebook.value("default_turns", turns_of<Verlet>());
  notebook.value("fast_divided_turns", std::to_string(divided * std::stoi(turns_of<Verlet>())));
  notebook.value("fourth_turns", turns_of<BlanesMoanFourth>());
}

/// The sides of a cylinder about z that the reader sees: its cap, and the band below it.
template <class Turned, class Draw>
void for_each_seen_side_of_disc(double radius, double half_height, const Turned& turned,
                                const Draw& draw) {
  const int parts = 96;
  const auto outwards = [](int n) {
    const double angle = 2 * std::numbers::pi * n / parts;
    return Vec3d(std::cos(angle), std::sin(angle), 0);
  };
  const auto is_seen = [&](int n) { return faces_reader(turned(outwards(n))); };
  const double above = faces_reader(turned(Vec3d(0, 0, 1))) ? half_height : -half_height;
  const auto rim = [&](int n, double height) {
    return on_page(turned(Vec3d(radius * outwards(n) + height * Vec3d::Unit(2))));
  };
  int first = 0;
  while (is_seen(first) || !is_seen(first + 1)) ++first;
  std::vector<std::array<double, 2>> cap, band;
  for (int n = 0; n <= parts; ++n) cap.push_back(rim(n, above));
  int last = first;
  do band.push_back(rim(last, above));
  while (is_seen(++last));
  band.push_back(rim(last, above));
  for (int n = last; n >= first; --n) band.push_back(rim(n, -above));
  draw(0, band);
  draw(2, cap);
}

/// The five bodies as boxes of their moments, one of them a disc, with the axis of their spin, and
/// for each of the eight cases the angle of the spin in a step.
void draw_cases(const Notebook& notebook) {
  Table table = notebook.table("cases", {"kind", "x", "y", "dx", "dy"});
  const std::array<HardCase<double>, 8> cases = hard_cases<double>();
  for (std::size_t n = 0; n < 5; ++n) {
    const Topd& top = cases[n].top;
    const double right = n == 0 ? 0 : 3.2 * double(n - 1), up = n == 0 ? 0 : -3.9;
    const auto turned = [&top](const Vec3d& v) { return rotate(top.orientation, v); };
    // A side's square is proportional to the sum of the two other moments less its own.
    const Vec3d moments = moments_of(top);
    Vec3d half;
    for (int axis = 0; axis < 3; ++axis)
      half[axis] = std::sqrt(std::max(0.0, moments.sum() - 2 * moments[axis]));
    half /= half.maxCoeff();
    const auto draw = [&](int side, const auto& corners) {
      for (const auto& [x, y] : corners)
        table.row("face " + std::to_string(3 * n + std::size_t(side)), x + right, y + up, 0.0, 0.0);
    };
    if (n == 4)
      for_each_seen_side_of_disc(half.x(), half.z(), turned, draw);
    else
      for_each_seen_side(half, turned,
                         [&](int axis, int, const auto& corners) { draw(axis, corners); });
    const Vec3d spin = angular_velocity_body(top);
    const auto [dx, dy] = on_page(turned(Vec3d(1.4 * spin.normalized())));
    table.row("spin", right, up, dx, dy);
    table.row("name", right, up - 1.5, double(n), 0.0);
  }
  const std::array<double, 8> right = {4.7, 0, 3.2, 6.4, 9.6, 9.7, 2.2, 7.2};
  for (std::size_t n = 0; n < 8; ++n)
    table.row("dial", right[n], n == 0 || n > 4 ? 0.0 : -6.2, double(n),
              angular_velocity_body(cases[n].top).norm() * cases[n].time_step);
  // The axis of a body with two equal moments goes round L at |L| over one of the two.
  const Topd& disc = cases[4].top;
  table.row("axis", right[4], -6.2, angular_velocity_body(disc).norm() * cases[4].time_step,
            disc.angular_momentum_body.norm() * disc.inverse_moments.x() * cases[4].time_step);
}

/// The plate of problem B after its ten minutes, by the rules that engines have and by ours.
void spin_plate(Notebook& notebook) {
  const std::vector<TurningRung<double>> all = all_methods<double>();
  const HardCase<double> plate = hard_cases<double>()[1];
  const double rounding = 1e-11;  // 36,000 steps of a few roundings each
  Table table = notebook.table("plate", {"rule", "energy, of that at the start", "error of L",
                                         "error of the orientation (rad)"});
  for (const std::string_view name : {"steady", "explicit, |L| restored", "linearly implicit",
                                      "implicit, one Newton step", "splitting"}) {
    const Motion motion = watched<double>(plate.top, method_called(all, name).turn, plate.steps,
                                          plate.steps_to_angle, plate.time_step);
    table.row(name, number("%.4f", motion.energy_ratio),
              motion.momentum_error < rounding ? "rounding" : number("%.0e", motion.momentum_error),
              number("%.0e", motion.angle));
    if (name == "explicit, |L| restored") {
      expect(motion.energy_ratio > 1.49, "restoring |L| has taken half as much energy again");
      notebook.value("plate_gained", number("%.0f %%", 100 * (motion.energy_ratio - 1)));
    }
    if (name == "steady") {
      expect(motion.energy_error < rounding && motion.momentum_error > 0.05,
             "without the term the energy is right and the direction of L is not");
      notebook.value("plate_cone", number("%.0f°", 2 * std::asin(motion.momentum_error / 2) * 180 /
                                                       std::numbers::pi));
    }
  }
}

}  // namespace

int main(int argument_count, char** arguments) {
  Notebook notebook(argument_count, arguments);
  std::printf(". right   E, L, P: wrong in energy, angular momentum, phase   D: it diverged\n");
  const int surprises =
      tabulated<double>(notebook, "in_double", "in double", &Expected::in_double) +
      tabulated<float>(notebook, "in_float", "in float", &Expected::in_single);
  // What the page counts, in double: columns A, D and the disc at 100 rad a step.
  int on_a = 0, on_a_exploding_on_d = 0, on_all = 0, finite_and_wrong = 0;
  std::vector<std::string_view> on_all_in_both;
  for (const Expected& each : expected) {
    const std::string_view found = each.in_double;
    if (found == "........" && found == each.in_single) on_all_in_both.push_back(each.method);
    on_a += found[0] == '.';
    on_a_exploding_on_d += found[0] == '.' && found[3] == 'D';
    on_all += found == "........";
    finite_and_wrong += found[5] == '.' && found.substr(0, 4).find('.') == std::string_view::npos;
  }
  expect(
      on_all_in_both == std::vector<std::string_view>{"splitting, Blanes-Moan 4", "exact solution"},
      "one composition passes everything in both precisions, and the exact solution");
  draw_cases(notebook);
  try_default(notebook);
  spin_plate(notebook);
  // What the page lets its readers find.
  const HardCase<double> needle = hard_cases<double>()[3];
  const auto eighth_order = [&needle](double factor) {
    return tried(stretched(needle, factor), rung_called<double>("Dormand-Prince 8"));
  };
  const Verdict quarter = eighth_order(0.25), eighth = eighth_order(0.125);
  expect(quarter.fault == 'E' && eighth.fault == '.',
         "the eighth order passes the needle with an eighth of the step, not with a quarter");
  notebook.value("needle_whole", number("%.2f", eighth_order(1).error));
  notebook.value("needle_quarter", number("%.1e", quarter.error));
  notebook.value("needle_eighth", number("%.1e", eighth.error));
  const auto tenth_order = [](double factor) {
    const HardCase<float> minute = shortened(hard_cases<float>()[0], 3600);
    return tried(stretched(minute, factor), rung_called<float>("splitting, Sofroniou-Spaletta"));
  };
  expect(tenth_order(4).error < tenth_order(1).error / 2,
         "in float four times the step leaves the tenth order less than half of its error of L");
  notebook.value("most_turns", std::to_string(support::most_turns));
  notebook.value("methods", std::to_string(expected.size()));
  notebook.value("on_a", std::to_string(on_a));
  notebook.value("on_a_exploding_on_d", std::to_string(on_a_exploding_on_d));
  notebook.value("on_all", std::to_string(on_all));
  notebook.value("rows_on_all", std::to_string(on_all - 1));  // all but the exact solution
  notebook.value("given_tolerance", number("%.0e", given_tolerance));
  notebook.value("given_angle", number("%g", given_angle));
  notebook.value("finite_and_wrong", std::to_string(finite_and_wrong));
  expect(surprises == 0, "each rung passes and fails as the chapter says");
}
