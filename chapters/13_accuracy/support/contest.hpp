/// @file
/// Error and time of any method on any problem: what the figures and the tables are made of.
#pragma once

#include <chrono>
#include <cstdlib>
#include <functional>
#include <limits>
#include <support/exact_motion.hpp>

namespace tumble::support {

/// One run of one method.
struct Measurement {
  std::string problem, precision, method;
  std::string kind;  ///< "rung", "exact" or the name of the library it comes from
  double knob;       ///< the time step (s), or the tolerance of a method that chooses its steps
  long steps;        ///< 0 where the method chooses them
  double error;      ///< of place (m) or orientation (rad) at the end
  double energy_error, momentum_error;  ///< relative, at the end
  double nanoseconds;                   ///< of the whole run, the best of several
  double median;                        ///< the middle one of them, ns
  double seconds;                       ///< that it simulated
};

/// Something that can be run with a number of steps or a tolerance, and then says where the body
/// is.
template <class Body>
struct Contestant {
  std::string name, kind;
  bool chooses_steps;
  std::function<Body(double knob)> run;  ///< knob: number of steps, or tolerance
};

/// float or double, from Top<float> or Particle<double>.
template <class Body>
struct ScalarOf;
template <template <class> class Body, class Real>
struct ScalarOf<Body<Real>> {
  using Type = Real;
};

/// How thorough to be.
struct Effort {
  double
      longest_run;  ///< ns; a method is not tried with smaller steps after a run that took longer
  double longest_run_of_engines;  ///< the same for what is not ours or Odeint's, which takes longer
  int repetitions;                ///< of which the fastest counts
};
inline constexpr Effort quick = {.longest_run = 1e6,
                                 .longest_run_of_engines = 3e6,
                                 .repetitions = 3},
                        full = {
                            .longest_run = 3e7, .longest_run_of_engines = 3e7, .repetitions = 5};

/// The quick one, unless `./course book --full` asks for more: it sets TUMBLE_FULL.
inline Effort wanted_effort() {
  return std::getenv("TUMBLE_FULL") != nullptr ? full : quick;
}

/// The times of the fastest and of the middle one of some runs, ns. Short ones are made in batches
/// that a clock can time.
struct Times {
  double fastest, median;
};
template <class Run>
Times times_of(const Run& run, int repetitions) {
  using Clock = std::chrono::steady_clock;
  const auto time_of = [&](long count) {
    const auto begin = Clock::now();
    for (long n = 0; n < count; ++n) run();
    return std::chrono::duration<double, std::nano>(Clock::now() - begin).count() /
           static_cast<double>(count);
  };
  const long count = 1 + static_cast<long>(20'000 / (time_of(1) + 1));
  std::vector<double> times;
  for (int n = 0; n < repetitions; ++n) times.push_back(time_of(count));
  std::sort(times.begin(), times.end());
  return {times.front(), times[times.size() / 2]};
}

template <class Run>
double fastest(const Run& run, int repetitions) {
  return times_of(run, repetitions).fastest;
}

inline double error_of(const Top<long double>& top, const Top<long double>& truth) {
  return static_cast<double>(angle_between(truth.orientation, top.orientation));
}
inline double error_of(const Particle<long double>& particle, const Particle<long double>& truth) {
  return static_cast<double>((particle.position - truth.position).norm());
}

/// Where the body of a problem really is in the end, and the exact solution as a contestant.
template <class Body, class Forces>
auto truth_of(const Problem<Body, Forces>& problem) {
  return exactly_after(exactly(problem.evaluate_forces), exactly(problem.start), problem.seconds);
}
template <class Body, class Forces>
Contestant<Body> exact_contestant(const Problem<Body, Forces>& problem) {
  using Real = typename ScalarOf<Body>::Type;
  return {"exact solution", "exact", false, [problem](double) {
            return exactly_after(problem.evaluate_forces, problem.start,
                                 static_cast<Real>(problem.seconds));
          }};
}

/// Tries a contestant with ever smaller steps, until a run takes too long or nothing is gained.
template <class Body, class Forces, class Truth>
std::vector<Measurement> measured(const Problem<Body, Forces>& problem, const char* precision,
                                  const Contestant<Body>& contestant, const Truth& truth,
                                  const Effort& effort) {
  std::vector<Measurement> measurements;
  const auto start = problem.evaluate_forces.kept(exactly(problem.start));
  const auto relative = [](long double difference, long double to) {
    return to == 0 ? 0 : static_cast<double>(std::abs(difference / to));
  };
  const bool is_engine = contestant.kind != "rung" && contestant.kind != "Odeint";
  const double longest_run = is_engine ? effort.longest_run_of_engines : effort.longest_run;
  double best_error = std::numeric_limits<double>::infinity();
  int since_best = 0;
  for (int n = 0; n < 60 && since_best < 9; ++n) {
    const double knob = contestant.chooses_steps ? std::pow(10, -(n + 1) / 3.0)  // less than 1
                                                 : std::round(std::pow(2, n / 2.0));
    if (contestant.chooses_steps && knob < 2e-15) break;
    const auto end = exactly(contestant.run(knob));
    const auto kept = problem.evaluate_forces.kept(end);
    const double error = error_of(end, truth);
    if (!std::isfinite(error)) {
      if (contestant.chooses_steps) break;
      continue;
    }
    const Times times = times_of(
        [&] {
          const Body body = contestant.run(knob);
          asm volatile("" : : "r"(&body) : "memory");  // or the compiler drops the run
        },
        effort.repetitions);
    measurements.push_back(
        {problem.name, precision, contestant.name, contestant.kind,
         contestant.chooses_steps ? knob : problem.seconds / knob,
         contestant.chooses_steps ? 0 : static_cast<long>(knob), error,
         relative(kept.energy - start.energy, start.energy),
         relative((kept.momentum - start.momentum).norm(), start.momentum.norm()), times.fastest,
         times.median, problem.seconds});
    since_best = error < 0.9 * best_error || error > 0.1 ? 0 : since_best + 1;
    best_error = std::min(best_error, error);
    if (times.fastest > longest_run || contestant.kind == "exact") break;
  }
  return measurements;
}

/// A rung of a ladder, which the compiler knows.
template <const auto& ladder, std::size_t n>
struct RungOf {
  static constexpr auto rung = ladder[n];
};
template <const auto& ladder>
using HighestRung = RungOf<ladder, ladder.size() - 1>;

/// The body of a problem after so many steps of such a rung. Because it knows the step, the
/// compiler puts it into the loop, as it does with Odeint's.
//! [after_steps]
template <class Chosen, class Body, class Forces>
[[gnu::flatten]] Body after_steps(const Problem<Body, Forces>& problem, double knob) {
  using Real = typename ScalarOf<Body>::Type;
  const auto steps = static_cast<long>(knob);
  const Real h = static_cast<Real>(problem.seconds / knob);
  Body body = problem.start;
  problem.evaluate_forces(body, Real(0));
  for (long n = 0; n < steps; ++n)
    if constexpr (requires { Chosen::rung.turn; })
      Chosen::rung.turn(body, h);
    else
      Chosen::rung.step(body, problem.evaluate_forces, static_cast<Real>(n) * h, h);
  return body;
}
//! [after_steps]

/// A rung as a contestant.
template <class Chosen, class Body, class Forces>
Contestant<Body> contestant(const Problem<Body, Forces>& problem, Chosen) {
  return {std::string(Chosen::rung.name), "rung", false,
          [problem](double knob) { return after_steps<Chosen>(problem, knob); }};
}

/// Every rung of a ladder.
template <const auto& ladder, class Body, class Forces>
std::vector<Contestant<Body>> contestants(const Problem<Body, Forces>& problem) {
  return [&]<std::size_t... n>(std::index_sequence<n...>) {
    return std::vector{contestant(problem, RungOf<ladder, n>())...};
  }
  (std::make_index_sequence<ladder.size()>());
}

}  // namespace tumble::support
