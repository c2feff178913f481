#include <support/cheapest.hpp>
#include <support/checks.hpp>
#include <support/own_steps.hpp>

#include "with_peers.hpp"

using namespace tumble;
using namespace tumble::support;

namespace {

/// What each fixed-step peer says of itself: the power of the step with which its error falls.
int order_of(const std::string& name) {
  const auto says = [&](const char* words) { return name.find(words) != std::string::npos; };
  if (says("rk4") || says("Merson")) return 4;
  if (says("Dormand-Prince 5")) return 5;
  if (says("Fehlberg 7(8)")) return 8;
  return says("Verlet") ? 2 : 1;
}

template <class Forces, class Truth>
void check_peers(const Problem<Topd, Forces>& problem, peers::Torque torque,
                 double weight_times_arm, const Truth& truth) {
  std::vector<Contestant<Topd>> list;
  append_peers(list, problem, torque, weight_times_arm);
  CHECK(list.size() >= 6);
  for (const Contestant<Topd>& peer : list) {
    CAPTURE(problem.name);
    CAPTURE(peer.name);
    const auto error = [&](double knob) { return error_of(exactly(peer.run(knob)), truth); };
    if (peer.chooses_steps) {
      // A tolerance bounds what one step may err by, not the whole; but what it is made smaller by,
      // the whole must become smaller by too, or nearly.
      CHECK(error(1e-9) < error(1e-6) / 30);
      CHECK(error(1e-9) < 1e-5);
      continue;
    }
    const int order = order_of(peer.name);
    const int steps = order == 1   ? 8192
                      : order == 2 ? 1024
                      : order == 4 ? 160
                      : order == 5 ? 32
                                   : 8;
    const double coarse = error(steps), fine = error(2 * steps);
    CAPTURE(coarse);
    CAPTURE(fine);
    // An error that falls so, measured against the truth, falls to nothing. The next term of it is
    // smaller by a power of the step.
    CHECK(std::log2(coarse / fine) >= order - 0.25);
  }
}

constexpr double seconds = 2;

/// Whether the book compares such a method with Odeint like with like.
void check_alike(std::string_view name, bool wanted) {
  CAPTURE(std::string(name));
  Measurement run = {};
  run.method = name;
  run.kind = "rung";
  CHECK(is_alike(run) == wanted);
}

}  // namespace

TEST_CASE("Like with like Odeint meets all that step the numbers which it gets, and no others") {
  const auto heavy = heavy_top<double>("heavy top", 3);
  const auto orbit = eccentric_orbit<double>();
  using Torque = Weight<double>;
  for (const auto& rung : turning_ladder<double>) check_alike(rung.name, true);
  for (const auto& rung : torque_ladder<double, Torque>) check_alike(rung.name, true);
  for (const auto& rung : motion_ladder<double, Star<double>>) check_alike(rung.name, true);
  for (const auto& rung : adaptive_rungs<Topd, double, Torque>) check_alike(rung.name, true);
  check_alike(nystrom_by_own_steps(orbit).name, true);
  // A pair keeps L only where L in the world is not among the numbers that it steps.
  for (const auto& rung : free_top_rungs<double>)
    check_alike(rung.name, rung.given == Given::angle || !rung.claims.momentum);
  for (const auto& rung : even_momentum_ladder<double>) check_alike(rung.name, false);
  for (const auto& rung : axis_rungs<double, Torque>) check_alike(rung.name, false);
  for (const auto& contestant : axis_by_even_steps(heavy)) check_alike(contestant.name, false);
  for (const auto& contestant : in_transformed_time(orbit)) check_alike(contestant.name, false);
}

TEST_CASE("Every peer goes where the exact solution goes, with the order that it claims") {
  FreeProblem<double> free = free_problems<double>()[0];
  free.seconds = seconds;
  check_peers(free, peers::Torque::none, 0, truth_of(free));
  auto heavy = heavy_top<double>("heavy top", 3);
  heavy.seconds = seconds;
  check_peers(heavy, peers::Torque::weight, 1, truth_of(heavy));
}

TEST_CASE("Every peer swings the driven top as our ladder does") {
  auto problem = driven_top<double>();
  problem.seconds = seconds;
  const Problem<Top<long double>, Drive<long double>> wide{
      problem.name, exactly(problem.start), {}, problem.seconds};
  const auto truth =
      after_steps<HighestRung<torque_ladder<long double, Drive<long double>>>>(wide, 1000);
  check_peers(problem, peers::Torque::drive, 0, truth);
}
