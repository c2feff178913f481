// Steps that choose themselves: what they gain, what they take away, and how to spoil them.
#include <support/exact_motion.hpp>
#include <support/problems.hpp>
#include <support/record.hpp>
#include <tumble/exact/kepler.hpp>
#include <tumble/nystrom_steps.hpp>
#include <tumble/paced_steps.hpp>
#include <tumble/reduced_steps.hpp>
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
  Table table = notebook.table("own_steps_energy", {"round", "one length", "chosen at the start",
                                                    "pair", "transformed time"});
  Particled even = orbit.start, chosen = orbit.start, pair = orbit.start;
  orbit.evaluate_forces(even, 0);
  orbit.evaluate_forces(chosen, 0);
  TransformedTime<Star<double>, double> transformed(orbit.start, orbit.evaluate_forces);
  std::array<double, 4> worst{}, last{}, first{};
  for (int n = 1; n <= 100; ++n) {
    for (int step = 0; step < 1000; ++step)
      step_by_row<Verlet>(even, orbit.evaluate_forces, 0.0, round / 1000);
    for (double gone = 0; gone < round;) {
      const double distance = chosen.position.norm(), h = 0.05 * distance * std::sqrt(distance);
      step_by_row<Verlet>(chosen, orbit.evaluate_forces, 0.0, h);
      gone += h;
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
  Table table = notebook.table("own_steps_pace", {"step", "chosen at the start", "symmetric"});
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
  Table table = notebook.table("own_steps_wander",
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

/// A pair that asks what seven numbers err by, all alike, instead of an angle and a part of |L|.
//! [seven]
struct SevenNumbers {
  static constexpr int power = 4;
  double attempt(double h) {
    step = h;
    evaluate_stages<DormandPrinceFifth>(start, h, rates, [&](const auto& numbers, double, auto) {
      return rates_of(numbers, inverse);
    });
    end = combine<RowOfStep<DormandPrinceFifth>>(start, h, rates);
    rates[6] = rates_of(end, inverse);
    double square = 0;
    for (const double off : weighed<RowOf<DormandPrince54::errors, 0>>(rates)) square += off * off;
    return square / (tolerance * tolerance);
  }
  //! [seven]
  void accept() {
    start = end;
    rates[0] = rates[6];
  }
  Vec3d inverse;
  double tolerance, step = 0;
  StateVector<double, 7> start, end = {};
  std::array<StateVector<double, 7>, 7> rates = {rates_of(start, inverse)};
};

/// How many steps a top takes whose moments are `scale` times those of problem A, by the right and
/// by the wrong measure.
std::array<long, 2> steps_of_scaled(double scale) {
  Topd top = free_problems<double>()[0].start;
  top.inverse_moments /= scale;
  top.angular_momentum_body *= scale;
  SevenNumbers steps{top.inverse_moments, 1e-6, 0, state_of(top)};
  const StepCounts wrong = integrate_adaptively(steps, 1.0, 1e-3, [](double, double) {});
  return {integrate_free_top<DormandPrince54>(top, 1, 1e-6).steps, wrong.steps};
}

/// Steps of a pair with a tolerance in rad a step, where it should be rad a second.
//! [per_step]
template <class Steps>
struct PerStep {
  static constexpr int power = Steps::power + 1;  // the error of a step falls by one order more
  double attempt(double h) { return steps.attempt(h) * h * h; }  // (error/(τ h))² h²
  void accept() { steps.accept(); }
  Steps steps;
};
//! [per_step]

/// What a free top errs by in a second, rad, if it spins as in problem A and `faster` times as
/// fast, and a millionth is allowed in each step or in each second.
template <bool per_step>
std::array<double, 2> errors_of_spins(double faster) {
  const auto problem = free_problems<double>()[0];
  using Motion = FreeTurn<double>;
  using Steps = ReducedSteps<DormandPrince54, Motion, double>;
  std::array<double, 2> errors{};
  for (std::size_t n = 0; n < 2; ++n) {
    Topd top = problem.start;
    if (n == 1) top.angular_momentum_body *= faster;
    Steps steps(Motion(top), 0, 1e-6);
    const auto truth = exactly_after(exactly(problem.evaluate_forces), exactly(top), 1.0L);
    const auto pass = [](double, double) {};
    if constexpr (per_step) {
      PerStep<Steps> all{steps};
      integrate_adaptively(all, 1.0, 1e-4, pass);
      top = all.steps.body();
    } else {
      integrate_adaptively(steps, 1.0, 1e-4, pass);
      top = steps.body();
    }
    errors[n] = static_cast<double>(angle_between(truth.orientation, exactly(top).orientation));
  }
  return errors;
}

/// A step that was tried: how long it was (s), and whether it counted.
struct Attempt {
  double length;
  bool is_accepted;
};

/// What is tried on a particle that a strong damper stops at once: what is left moves slowly, but a
/// step may be no longer than the damper allows. The controller sees two errors, or one.
std::vector<Attempt> with_damper(bool remembers) {
  const auto damper = [](Particled& particle, double time) {
    particle.force = -1000 * (particle.velocity - Vec3d(std::cos(time), 0, 0));
  };
  using Steps = EmbeddedSteps<DormandPrince54, Particled, decltype(damper), double>;
  Steps steps(make_particle(1.0, {0, 0, 0}, {1, 0, 0}), damper, 0, {1e-2, 1e-2});
  StepControl control(Steps::power);
  std::vector<Attempt> attempts;
  for (double gone = 0, h = 1e-3; gone < 2;) {
    const auto square = static_cast<float>(steps.attempt(h));
    attempts.push_back({h, square <= 1});
    if (square <= 1) {
      steps.accept();
      gone += h;
    }
    const double forgetful = std::clamp(0.85 * std::pow(square, -0.5 / Steps::power), 0.1, 6.0);
    h *= remembers ? static_cast<double>(control.factor(square)) : forgetful;
  }
  return attempts;
}

/// The attempts of both controllers, of which the figure shows a stretch; how many of the one's
/// and of the other's were rejected.
void write_hunting(Notebook& notebook) {
  const std::vector<Attempt> two = with_damper(true), one = with_damper(false);
  Table table = notebook.table("own_steps_hunting",
                               {"attempt", "one error (s)", "is it accepted", "two errors (s)"});
  for (std::size_t n = 100; n < 150; ++n)
    table.row(static_cast<double>(n), one[n].length, one[n].is_accepted ? 1.0 : 0.0, two[n].length);
  const auto rejected = [](const std::vector<Attempt>& all) {
    return std::count_if(all.begin(), all.end(), [](const Attempt& a) { return !a.is_accepted; });
  };
  const auto calm = rejected(two), hunting = rejected(one);
  const auto calm_steps = std::ssize(two) - calm, hunting_steps = std::ssize(one) - hunting;
  std::printf(
      "A strong damper: %td steps and %td rejected by the controller that remembers,\n%td and "
      "%td by one that does not.\n",
      calm_steps, calm, hunting_steps, hunting);
  notebook.value("hunting_rejected", std::to_string(hunting));
  notebook.value("hunting_steps", std::to_string(hunting_steps));
  expect(hunting > 3 * calm && hunting > 20, "a controller without a memory hunts");
}

/// A resting top that is struck after 5.3 s, for a twentieth of a second.
//! [blow]
struct Blow {
  void operator()(Topd& top, double time) const {
    top.torque = {0, 0, time >= 5.3 && time < 5.35 ? 20.0 : 0.0};
  }
};
constexpr double moment = 3, turned = 20 * 0.05 / moment * (10 - 5.325);  // rad, after 10 s
//! [blow]

/// What the top is off by in the end, rad, and in how many steps.
std::pair<double, long> off_after_blow(double tolerance, const Stops<double>& stops) {
  Topd top{.inverse_moments = {1, 0.5, 1 / moment}};
  const long steps = integrate<DormandPrince54>(top, Blow(), 0.0, 10, tolerance, stops).steps;
  return {angle_between(top.orientation, quaternion_about<double>(Vec3d::UnitZ(), turned)), steps};
}

void write_blow(Notebook& notebook) {
  std::pair<double, long> without, with;
  for (const double tolerance : {1e-4, 1e-6, 1e-9}) {
    without = off_after_blow(tolerance, {});
    with = off_after_blow(tolerance, {.events = {5.3, 5.35}});
    expect(without.second == 1 && without.first > 1.5, "a blow between two stages is missed");
    expect(with.first < 10 * tolerance, "with its events it is not");
  }
  std::printf(
      "A top that is struck: off by %.1f rad in %ld step, with events by %.0e rad in %ld.\n",
      without.first, without.second, with.first, with.second);
  notebook.value("blow_blind", number("%.1f", without.first));
  notebook.value("blow_seeing", number("%.0e", with.first));
  notebook.value("blow_steps", std::to_string(with.second));
  try {
    off_after_blow(1e-6, {.longest = 0.01});
    expect(false, "a jump inside a step asks for an event");
  } catch (const StepError& error) {
    notebook.value("blow_refused", error.what());
  }
}

}  // namespace

int main(int argument_count, char** arguments) {
  Notebook notebook(argument_count, arguments);
  const Orbit orbit = eccentric_orbit<double>();
  std::printf("%-10s %21s %21s %21s\n%-10s", "orbit", "5(4)", "8(5,3)", "Nystrom 8(6)",
              "tolerance");
  for (int n = 0; n < 3; ++n) std::printf("%6s %6s %7s", "steps", "again", "error");
  std::puts("");
  Table counted = notebook.table("own_steps_tolerance",
                                 {"tolerance", "pair 5(4)", "pair 8(5,3)", "Nyström 8(6)"});
  const Particled there = exactly_after(orbit.evaluate_forces, orbit.start, orbit.seconds);
  for (const double tolerance : {1e-2, 1e-4, 1e-6, 1e-8, 1e-10}) {
    std::printf("%-10.0e", tolerance);
    const auto go = [&](auto by) {
      Particled particle = orbit.start;
      const StepCounts counts = by(particle);
      std::printf("%6ld %6ld %7.0e", counts.steps, counts.rejected,
                  (particle.position - there.position).norm());
      return static_cast<double>(counts.steps);
    };
    const double fifth = go([&](Particled& p) {
      return integrate<DormandPrince54>(p, orbit.evaluate_forces, 0.0, orbit.seconds,
                                        {tolerance, tolerance});
    });
    const double eighth = go([&](Particled& p) {
      return integrate<DormandPrince853>(p, orbit.evaluate_forces, 0.0, orbit.seconds,
                                         {tolerance, tolerance});
    });
    const double nystrom = go([&](Particled& p) {
      return integrate_by_nystrom<DormandPrinceNystrom86>(p, orbit.evaluate_forces, 0.0,
                                                          orbit.seconds, {tolerance, tolerance});
    });
    std::puts("");
    counted.row(tolerance, fifth, eighth, nystrom);
  }
  write_energies(notebook, orbit);
  write_paces(notebook);
  write_wandering(notebook);

  const auto small = steps_of_scaled(1), large = steps_of_scaled(1e6);
  std::printf(
      "\nA top and one with a million times its inertia, steps in a second: %ld and %ld by an "
      "angle,\n%ld and %ld by seven numbers alike.\n",
      small[0], large[0], small[1], large[1]);
  notebook.value("angle_small", std::to_string(small[0]));
  notebook.value("seven_small", std::to_string(small[1]));
  notebook.value("seven_large", std::to_string(large[1]));
  expect(small[0] == large[0] && large[1] > 5 * small[1],
         "an angle knows no units, and seven numbers do");

  const auto each_second = errors_of_spins<false>(1000), each_step = errors_of_spins<true>(1000);
  std::printf(
      "A top, and one that spins a thousand times as fast, off after a second:\n%.0e and %.0e rad "
      "with a tolerance for each second, %.0e and %.0e rad with one for each step.\n",
      each_second[0], each_second[1], each_step[0], each_step[1]);
  notebook.value("second_slow", number("%.0e", each_second[0]));
  notebook.value("second_fast", number("%.0e", each_second[1]));
  notebook.value("step_slow", number("%.0e", each_step[0]));
  notebook.value("step_fast", number("%.0e", each_step[1]));
  expect(each_second[1] < 1e-6, "a tolerance for each second bounds what is added in a second");
  expect(each_step[1] > 1e-5 && each_step[1] > 100 * each_step[0],
         "with a tolerance for each step a faster top errs by more, since it takes more of them");

  write_hunting(notebook);
  write_blow(notebook);

  // Beyond the end: the loop stops after the step that has passed it.
  using Steps = EmbeddedSteps<DormandPrince54, Particled, Star<double>, double>;
  Steps beyond(orbit.start, orbit.evaluate_forces, 0, {1e-6, 1e-6});
  double gone = 0, h = 1e-3;
  StepControl control(Steps::power);
  while (gone < orbit.seconds) {
    const auto square = static_cast<float>(beyond.attempt(h));
    if (square <= 1) {
      beyond.accept();
      gone += h;
    }
    h *= static_cast<double>(control.factor(square));
  }
  const double off = (beyond.body().position - there.position).norm();
  std::printf("A run that stops after the step that passes the end: %.3f s too late, %.1e m off.\n",
              gone - orbit.seconds, off);
  notebook.value("beyond_late", number("%.3f", gone - orbit.seconds));
  notebook.value("beyond_off", number("%.0e", off));
  expect(off > 1e-3, "a step that lands beyond the end");
}
