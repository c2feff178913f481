// Every rung of the ladder on every hard case: who passes, who fails, and by how much.
#include <support/record.hpp>
#include <support/trial.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

/// A letter for each case in double and in float: '.' passes, E, L or P is wrong in the energy, the
/// angular momentum or the phase, D diverges. The chapter talks about these, so they must be so.
//! [expected]
struct Expected {
  const char *rung, *in_double, *in_single;
};
constexpr std::array<Expected, 21> expected = {{
    {"steady", "LLL.P..", "LLL.P.."},
    {"explicit", "DDDDDD.", "DDDDDD."},
    {"explicit, |L| restored", "LELEP..", "LEEEP.."},
    {"implicit, one Newton step", "ELLEP..", "ELLEP.."},
    {"linearly implicit", "EPLEP..", "EPLEP.."},
    {"momentum-carrying", "EEEEP..", "EEEEP.."},
    {"implicit midpoint", "PPP.P..", "PP..P.."},
    {"Lie midpoint", "..P.P..", "EE..PD."},
    {"augmented second order", "EEEDP..", "EEEDPD."},
    {"splitting by axes", "..P.P..", "..EEP.."},
    {"splitting", ".......", "......."},
    {"Runge-Kutta", "..LDDD.", "..LDDD."},
    {"Lie Runge-Kutta", "..EDPD.", ".EEDDD."},
    {"splitting, Suzuki", ".......", "......."},
    {"splitting, Blanes-Moan 4", ".......", "......."},
    {"Dormand-Prince 5", "..LDDD.", "..LDDD."},
    {"splitting, Yoshida", ".......", "......."},
    {"splitting, Blanes-Moan 6", ".......", "LL....."},
    {"Dormand-Prince 8", "..LEDD.", "..LEDD."},
    {"splitting, Kahan-Li 8", ".......", "L......"},
    {"splitting, Sofroniou-Spaletta", ".......", "LL....P"},
}};
//! [expected]

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
  const std::array<HardCase<Real>, 7> cases = hard_cases<Real>();
  Table table = notebook.table(name, {"rung", cases[0].name, cases[1].name, cases[2].name,
                                      cases[3].name, cases[4].name, cases[5].name, cases[6].name});
  std::printf("\n%-30s A B C D 20 100 crawl\n", title);
  int surprises = 0;
  for (const TurningRung<Real>& rung : rungs<Real>()) {
    std::string found;
    std::array<std::string, 7> cells;
    std::printf("%-30s", std::string(rung.name).c_str());
    for (std::size_t n = 0; n < cells.size(); ++n) {
      const Verdict verdict = tried(cases[n], rung);
      found += verdict.fault;
      cells[n] = words_of(verdict, cases[n].limits);
      std::printf("%*c", n < 5 ? 2 : 4, verdict.fault);
    }
    std::printf("\n");
    table.row(rung.name, cells[0], cells[1], cells[2], cells[3], cells[4], cells[5], cells[6]);
    for (const Expected& each : expected)
      if (each.rung == rung.name && found != each.*column) {
        std::fprintf(stderr, "expected of '%s': %s, not %s\n", each.rung, each.*column,
                     found.c_str());
        ++surprises;
      }
  }
  return surprises;
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
  for (const Expected& each : expected) {
    const std::string_view found = each.in_double;
    on_a += found[0] == '.';
    on_a_exploding_on_d += found[0] == '.' && found[3] == 'D';
    on_all += found == ".......";
    finite_and_wrong += found[5] == '.' && found.substr(0, 4).find('.') == std::string_view::npos;
  }
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
  notebook.value("rungs", std::to_string(expected.size()));
  notebook.value("on_a", std::to_string(on_a));
  notebook.value("on_a_exploding_on_d", std::to_string(on_a_exploding_on_d));
  notebook.value("on_all", std::to_string(on_all));
  notebook.value("finite_and_wrong", std::to_string(finite_and_wrong));
  expect(surprises == 0, "each rung passes and fails as the chapter says");
}
