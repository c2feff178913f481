// The energy and the angular momentum of the T-handle over a minute, by every rule.
#include <numbers>
#include <support/record.hpp>
#include <support/rules.hpp>

using namespace tumble;
using support::number;

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  support::Table energies = notebook.table("energy", {"time (s)", "steady", "explicit", "restored",
                                                      "implicit", "carrying", "splitting"});
  support::Table tilts = notebook.table("momentum", {"time (s)", "steady", "explicit", "restored",
                                                     "implicit", "carrying", "splitting"});
  const Topd start = support::thrown_t_handle().body.top;
  std::vector<Topd> tops(support::rules<double>.size(), start);
  const Vec3d L0 = angular_momentum_world(start);
  const double time_step = 1.0 / 60;
  std::array<double, 7> E{}, tilt{}, widest{};
  for (int n = 0; n <= 3600; ++n) {
    for (std::size_t rule = 0; rule < tops.size(); ++rule) {
      E[rule] = kinetic_energy(tops[rule]) / kinetic_energy(start);
      const Vec3d L = angular_momentum_world(tops[rule]);
      tilt[rule] = std::atan2(L.cross(L0).norm(), L.dot(L0)) * 180 / std::numbers::pi;
      widest[rule] = std::max(widest[rule], tilt[rule]);
      if (E[rule] < 1000) support::rules<double>[rule].turn(tops[rule], time_step);
    }
    if (n % 4 != 0) continue;
    energies.row(n * time_step, E[0], E[1], E[2], E[3], E[4], E[6]);
    tilts.row(n * time_step, tilt[0], tilt[1], tilt[2], tilt[3], tilt[4], tilt[6]);
  }
  std::printf("after a minute               E/E0      L points off by\n");
  for (std::size_t rule = 0; rule < tops.size(); ++rule)
    std::printf("%-28s %-8s %8.2g deg\n", support::rules<double>[rule].name,
                E[rule] < 1000 ? number("%.4f", E[rule]).c_str() : "over 1000", tilt[rule]);
  notebook.value("widest_restored", number("%.1f°", widest[2]));
  notebook.value("widest_implicit", number("%.1f°", widest[3]));
  notebook.value("widest_steady", number("%.1f°", widest[0]));
  support::expect(!(E[1] < 1000), "the explicit rule blows up");
  support::expect(E[3] < 0.95, "the implicit rule brakes");
  support::expect(std::abs(E[2] - 1) < 1e-3 && tilt[2] > 1,
                  "restoring |L| holds the energy of this spin, but not where L points");
  support::expect(E[4] > 1.05, "carrying the momentum to first order gains energy");
  support::expect(std::abs(E[0] - 1) < 1e-9 && tilt[0] > 0.1,
                  "without the term the energy holds and the momentum wanders");
  support::expect(std::abs(E[6] - 1) < 1e-3 && tilt[6] < 1e-9, "splitting holds both");
}
