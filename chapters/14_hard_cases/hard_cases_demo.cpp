// Every rung of the ladder on every hard case: who passes, who fails, and by how much.
#include <course/trial.hpp>

using namespace tumble;
using namespace tumble::course;

namespace {

/// A letter for each case in double and in float: '.' passes, E, L or P is wrong in the energy, the
/// angular momentum or the phase, D diverges. The chapter talks about these, so they must be so.
//! [expected]
struct Expected {
  const char *rung, *in_double, *in_single;
};
constexpr std::array<Expected, 21> expected = {{
    {"steady", "LLL.P..L", "LLL.P..L"},
    {"explicit", "DDDDDD..", "DDDDDD.L"},
    {"explicit, |L| restored", "LELEP...", "LEEEP..E"},
    {"implicit, one Newton step", "ELLEP...", "ELLEP..L"},
    {"linearly implicit", "EPLEP...", "EPLEP..L"},
    {"momentum-carrying", "EEEEP...", "EEEEP..L"},
    {"implicit midpoint", "PPP.P...", "PP..P..L"},
    {"Lie midpoint", "..P.P...", "EE..PD.L"},
    {"augmented second order", "EEEDP...", "EEEDPD.L"},
    {"splitting by axes", "..P.P...", "..E.P..L"},
    {"splitting", "........", "........"},
    {"Runge-Kutta", "..LDDD..", "..LDDD.L"},
    {"Lie Runge-Kutta", "..EDPD..", ".EEDDD.L"},
    {"splitting, Suzuki", "........", "......PL"},
    {"splitting, Blanes-Moan 4", "........", "......PL"},
    {"Dormand-Prince 5", "..LDDD..", "..LDDD.L"},
    {"splitting, Yoshida", "........", "......PP"},
    {"splitting, Blanes-Moan 6", "........", "LL....PP"},
    {"Dormand-Prince 8", "..LEDD..", "..LEDD.L"},
    {"splitting, Kahan-Li 8", "........", "L.....PL"},
    {"splitting, Sofroniou-Spaletta", "........", "LL....PL"},
}};
//! [expected]

/// The table of one precision: on paper with the numbers, on the screen with the letters.
template <class Real>
int tabulated(const Notebook& notebook, const char* name, const char* Expected::*column) {
  const std::vector<HardCase<Real>> cases = hard_cases<Real>();
  Table table =
      notebook.table(name, {"rung", cases[0].name, cases[1].name, cases[2].name, cases[3].name,
                            cases[4].name, cases[5].name, cases[6].name, cases[7].name});
  std::printf("\n%-30s A B C D 20 100 crawl crawl, tumbling\n", name);
  int surprises = 0;
  for (const TurningRung<Real>& rung : rungs<Real>()) {
    std::string letters;
    std::array<std::string, 8> cells;
    for (std::size_t n = 0; n < cells.size(); ++n) {
      const Verdict verdict = cases[n].trial(rung);
      letters += verdict.fault;
      cells[n] = (verdict.fault == '.' ? "✓ " : "✗ ") + verdict.number;
    }
    std::printf("%-30s %c %c %c %c %c  %c   %c     %c\n", std::string(rung.name).c_str(),
                letters[0], letters[1], letters[2], letters[3], letters[4], letters[5], letters[6],
                letters[7]);
    table.row(rung.name, cells[0], cells[1], cells[2], cells[3], cells[4], cells[5], cells[6],
              cells[7]);
    for (const Expected& each : expected)
      if (each.rung == rung.name && letters != each.*column) {
        std::fprintf(stderr, "expected of '%s': %s, not %s\n", each.rung, each.*column,
                     letters.c_str());
        ++surprises;
      }
  }
  return surprises;
}

}  // namespace

int main(int argument_count, char** arguments) {
  const Notebook notebook(argument_count, arguments);
  std::printf(". right   E, L, P: wrong in energy, angular momentum, phase   D: it diverged\n");
  const int surprises = tabulated<double>(notebook, "in double", &Expected::in_double) +
                        tabulated<float>(notebook, "in float", &Expected::in_single);
  expect(surprises == 0, "each rung passes and fails as the chapter says");
}
