// What becomes of the energy where steps are chosen: at their start, symmetrically, or by a clock.
#include <support/exact_motion.hpp>
#include <support/problems.hpp>
#include <support/record.hpp>
#include <tumble/embedded_steps.hpp>
#include <tumble/paced_steps.hpp>
#include <tumble/transformed_time.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

using Orbit = Problem<Particled, Star<double>>;

double energy_of(const Particled& particle) {
  return particle.velocity.squaredNorm() / 2 - 1 / particle.position.norm();
}

/// Energy along a hundred rounds: with steps of one length, with steps that are chosen at their
/// start, with a pair, and in transformed time.
void write_energies(Notebook& notebook, const Orbit& orbit) {
  const double round = 2 * std::numbers::pi, energy = energy_of(orbit.start);
  Table table =
      notebook.table("symmetric_steps_energy",
                     {"round", "one length", "chosen at the start", "pair", "transformed time"});
  Particled even = orbit.start, chosen = orbit.start, pair = orbit.start;
  orbit.evaluate_forces(even, 0);
  orbit.evaluate_forces(chosen, 0);
  TransformedTime<Star<double>, double> transformed(orbit.start, orbit.evaluate_forces);
  std::array<double, 4> worst{}, last{}, first{};
  long chosen_steps = 0;
  for (int n = 1; n <= 100; ++n) {
    for (int step = 0; step < 1000; ++step)
      step_by_row<Verlet>(even, orbit.evaluate_forces, 0.0, round / 1000);
    for (double gone = 0; gone < round;) {
      const double distance = chosen.position.norm(), h = 0.05 * distance * std::sqrt(distance);
      step_by_row<Verlet>(chosen, orbit.evaluate_forces, 0.0, h);
      gone += h;
      ++chosen_steps;
    }
    integrate<DormandPrince54>(pair, orbit.evaluate_forces, 0.0, round, {1e-5, 1e-5});
    while (transformed.time() < n * round) transformed.step<Verlet>(2 * round / 150);
    const std::array now = {even, chosen, pair, transformed.particle()};
    for (std::size_t m = 0; m < now.size(); ++m) {
      last[m] = std::abs(energy_of(now[m]) / energy - 1);
      worst[m] = std::max(worst[m], last[m]);
      if (n <= 50) first[m] = worst[m];
    }
    table.row(double(n), last[0], last[1], last[2], last[3]);
  }
  std::printf(
      "Energy after 100 rounds, relative: %.0e with steps of one length, %.0e with steps chosen\n"
      "at their start, %.0e by the pair, %.0e in transformed time.\n",
      last[0], last[1], last[2], last[3]);
  notebook.value("chosen_steps", std::to_string(chosen_steps / 100));
  // As many steps of one length as were chosen.
  Particled as_many = orbit.start;
  orbit.evaluate_forces(as_many, 0);
  double worst_as_many = 0, in_first_half = 0;
  for (long n = 0; n < chosen_steps; ++n) {
    step_by_row<Verlet>(as_many, orbit.evaluate_forces, 0.0,
                        100 * round / static_cast<double>(chosen_steps));
    worst_as_many = std::max(worst_as_many, std::abs(energy_of(as_many) / energy - 1));
    if (2 * n < chosen_steps) in_first_half = worst_as_many;
  }
  expect(worst_as_many < 1.05 * in_first_half,
         "a few equal steps err by much, but not by more and more");
  notebook.value("as_many", number("%.2f", worst_as_many));
  expect(worst[0] < 1.5 * first[0], "with steps of one length the energy is bounded");
  expect(worst[1] > 1.8 * first[1] && worst[2] > 1.8 * first[2],
         "with steps that are chosen at their start it drifts, twice as far in twice the time");
  expect(worst[3] < 1e-11, "in transformed time the energy stays at rounding");
}

/// Energy of a heavy top that swings like a pendulum: with steps that follow its pace, chosen at
/// their start or symmetrically.
void write_paces(Notebook& notebook) {
  const auto problem = heavy_top<double>("", 0.5);
  const auto error = [&](const Topd& top) {
    const auto energy = [&](const Topd& of) {
      return problem.evaluate_forces.kept(exactly(of)).energy;
    };
    return std::abs(double(energy(top) / energy(problem.start) - 1));
  };
  constexpr double angle = 0.1, least = 1;
  PacedSteps<Verlet, Weight<double>, double> paced(problem.start, problem.evaluate_forces, 0, angle,
                                                   least);
  Topd chosen = problem.start;
  problem.evaluate_forces(chosen, 0);
  Table table =
      notebook.table("symmetric_steps_pace", {"step", "chosen at the start", "symmetric"});
  double shortest = 1, longest = 0, of_chosen = 0, of_paced = 0, at_first = 0;
  for (int n = 1; n <= 100'000; ++n) {
    shortest = std::min(shortest, paced.next());
    longest = std::max(longest, paced.next());
    paced.step();
    const double pace = std::sqrt(angular_velocity_body(chosen).squaredNorm() + least * least);
    step_by_row<Verlet>(chosen, problem.evaluate_forces, 0.0, angle / pace);
    of_chosen = std::max(of_chosen, error(chosen));
    of_paced = std::max(of_paced, error(paced.top()));
    if (n == 1000) at_first = of_paced;
    if (n % 1000 == 0) table.row(double(n), of_chosen, of_paced);
  }
  std::printf(
      "A heavy top in 100000 steps from %.3f s to %.3f s: its energy is off by up to %.0e\n"
      "with steps chosen at their start, by up to %.0e with symmetric ones.\n",
      shortest, longest, of_chosen, of_paced);
  notebook.value("pace_shortest", number("%.3f", shortest));
  notebook.value("pace_longest", number("%.3f", longest));
  notebook.value("pace_chosen", number("%.0e", of_chosen));
  notebook.value("pace_symmetric", number("%.0e", of_paced));
  expect(of_paced < 1.1 * at_first,
         "with steps that are chosen symmetrically the energy is bounded");
  expect(of_chosen > 10 * of_paced, "with steps that are chosen at their start it drifts");
}

/// Energy of a heavy top without a mirror plane: with steps that follow its pace, as it is let go
/// and turned around, and with as many of one length.
void write_wandering(Notebook& notebook) {
  const auto problem = asymmetric_heavy_top<double>(0.15, 2);
  using Paced = PacedSteps<Verlet, OffAxisWeight<double>, double>;
  constexpr double angle = 0.05, least = 4, h = 0.01;  // s, about the mean of the paced ones
  Topd backwards = problem.start, even = problem.start;
  backwards.angular_momentum_body *= -1;
  std::array paced = {Paced(problem.start, problem.evaluate_forces, 0, angle, least),
                      Paced(backwards, problem.evaluate_forces, 0, angle, least)};
  problem.evaluate_forces(even, 0);
  const auto energy = [&](const Topd& of) {
    return double(problem.evaluate_forces.kept(exactly(of)).energy);
  };
  Table table = notebook.table("symmetric_steps_wander",
                               {"step", "following the pace", "turned around", "of one length"});
  constexpr int rows = 200, looks_a_row = 100, steps_between = 50;
  const double at_first = energy(problem.start);
  std::array<double, 3> mean{};
  double of_even = 0;
  for (int row = 1; row <= rows; ++row) {
    mean = {};
    for (int look = 0; look < looks_a_row; ++look) {
      for (int n = 0; n < steps_between; ++n) {
        step_by_row<Verlet>(even, problem.evaluate_forces, 0.0, h);
        for (Paced& one : paced) one.step();
      }
      const std::array now = {energy(paced[0].top()), energy(paced[1].top()), energy(even)};
      for (std::size_t which = 0; which < 3; ++which)
        mean[which] += (now[which] / at_first - 1) / looks_a_row;
    }
    table.row(double(row) * looks_a_row * steps_between, mean[0], mean[1], mean[2]);
    of_even = std::max(of_even, std::abs(mean[2]));
  }
  std::printf(
      "A heavy top without a mirror plane, in a million steps of about %.3f s: in the end its\n"
      "energy is off by %.0e with steps that follow its pace, by %.0e turned around, and never by\n"
      "more than %.0e with steps of one length.\n",
      paced[0].time() / 1e6, mean[0], mean[1], of_even);
  notebook.value("wander_forwards", number("%.0e", mean[0]));
  notebook.value("wander_backwards", number("%.0e", mean[1]));
  notebook.value("wander_even", number("%.0e", of_even));
  expect(mean[0] > 10 * of_even && -mean[1] > 10 * of_even,
         "without a mirror plane the energy drifts with steps that follow the pace");
}

}  // namespace

int main(int argument_count, char** arguments) {
  Notebook notebook(argument_count, arguments);
  write_energies(notebook, eccentric_orbit<double>());
  write_paces(notebook);
  write_wandering(notebook);
}
