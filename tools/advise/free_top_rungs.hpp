/// @file
/// Each rung of the ladder for free tops as a candidate, in one precision: a file for each compiles
/// this.
#pragma once

#include <memory>
#include <support/contest.hpp>
#include <tumble/adaptive_ladder.hpp>

#include "free_top_trials.hpp"

namespace tumble::advise {

/// What a top errs at one moment.
template <class Real>
Errors errors_at(const Top<Real>& top, const Top<long double>& truth) {
  const Top<long double> mine = support::exactly(top);
  const auto relative = [](long double difference, long double to) {
    return to == 0 ? 0.0 : static_cast<double>(std::abs(difference / to));
  };
  const Vec3<long double> L = angular_momentum_world(truth);
  return {.angle = static_cast<double>(angle_between(truth.orientation, mine.orientation)),
          .energy = relative(kinetic_energy(mine) - kinetic_energy(truth), kinetic_energy(truth)),
          .momentum = relative((angular_momentum_world(mine) - L).norm(), L.norm())};
}

/// Looks at a run frame by frame; `advance` takes the top to the next one.
template <class Real, class Advance>
Errors watched(const Trial<Real>& trial, const Frames& frames, const Advance& advance) {
  Top<Real> top = trial.start;
  Errors errors;
  const long between = frames_between_samples(frames);
  for (long frame = 1; frame <= frames.count; ++frame) {
    advance(top, frame);
    if (frame % between != 0) continue;
    const Errors now = errors_at(top, trial.truth[static_cast<std::size_t>(frame / between)]);
    if (!std::isfinite(now.angle)) return failed_run;
    errors = worse(errors, now);
  }
  errors.angle += trial.uncertainty;
  return errors;
}

template <class Real>
double time_of_run(const Top<Real>& start, int repetitions,
                   const std::function<void(Top<Real>&)>& run) {
  return support::fastest(
      [&] {
        Top<Real> top = start;
        run(top);
        asm volatile("" : : "r"(&top) : "memory");  // or the compiler drops the run
      },
      repetitions);
}

/// What methods that choose their steps are given first: more would hardly be a tolerance, and in a
/// step of a radian a splitting still knows where it is.
inline constexpr double coarsest_tolerance = 0.1;  // rad/s
inline constexpr double coarsest_angle = 1;        // rad a step

/// A rung that chooses its own steps, from each state to the next. It lands on every one of them.
template <class Real>
Candidate own_steps(const FreeTopRung<Real>& rung, const std::string& precision,
                    const Frames& frames, double longest_run,
                    const std::shared_ptr<std::vector<Trial<Real>>>& list) {
  Candidate made;
  made.method = std::string(rung.name);
  made.precision = precision;
  made.order = rung.claims.order;
  made.trials = trials;
  made.power = rung.power;
  made.is_given_angle = rung.given == Given::angle;
  made.coarsest = made.is_given_angle ? coarsest_angle : coarsest_tolerance;
  // The steps allow themselves some roundings on top of the tolerance, so that one of less than a
  // rounding for each state changes nothing.
  const double least = std::numeric_limits<Real>::epsilon() * static_cast<double>(frames.rate);
  if (!made.is_given_angle)
    made.finest =
        std::max(1L, static_cast<long>(std::pow(coarsest_tolerance / least, 1.0 / rung.power)));
  const auto given_at = [made_of = made](long fineness) {
    return static_cast<Real>(made_of.given(fineness));
  };
  const Real frame_time = static_cast<Real>(1.0L / static_cast<long double>(frames.rate));
  const auto integrate = rung.integrate;
  made.errors = [=](long fineness, int trial) {
    const Real given = given_at(fineness);
    StepCounts all;
    try {
      Errors errors =
          watched((*list)[static_cast<std::size_t>(trial)], frames, [&](Top<Real>& top, long) {
            const StepCounts counts = integrate(top, frame_time, given);
            all.steps += counts.steps;
            all.rejected += counts.rejected;
          });
      errors.steps = all.steps;
      errors.rejected = all.rejected;
      return errors;
    } catch (const StepError&) {
      return failed_run;
    }
  };
  made.nanoseconds = [=](long fineness, int repetitions) {
    const Real given = given_at(fineness);
    const auto time_of = [&](long count, int times) {
      return time_of_run<Real>((*list)[0].start, times, [&](Top<Real>& top) {
        for (long frame = 0; frame < count; ++frame) integrate(top, frame_time, given);
      });
    };
    try {
      if (time_of(1, 3) * static_cast<double>(frames.count) > 1e9 * longest_run)
        return std::numeric_limits<double>::infinity();
      return time_of(frames.count, repetitions);
    } catch (const StepError&) {
      return std::numeric_limits<double>::infinity();
    }
  };
  return made;
}

template <class Real>
void append_free_top(std::vector<Candidate>& candidates, const FreeTopQuestion& question,
                     const Frames& frames, const StepKinds& kinds, double longest_run) {
  const std::string precision = sizeof(Real) == sizeof(float) ? "float" : "double";
  const auto list = std::make_shared<std::vector<Trial<Real>>>(trials_of<Real>(question, frames));
  const Top<Real>& start = (*list)[0].start;
  const auto in_range = [](Real x) { return x == 0 || std::isnormal(x); };
  for (int axis = 0; axis < 3; ++axis)  // what this precision can't even store, it can't turn
    if (!std::isnormal(start.inverse_moments[axis]) || !in_range(start.angular_momentum_body[axis]))
      return;
  const bool tumbles = is_gyroscopic(start);
  for (const TurningRung<Real>& rung : turning_ladder<Real>) {
    const bool steady = rung.claims.order == 0;
    if (!kinds.even || steady == tumbles) continue;  // which does not converge, or has no need to
    const auto time_step = [frames](long steps) {
      return static_cast<Real>(
          1.0L / (static_cast<long double>(frames.rate) * static_cast<long double>(steps)));
    };
    candidates.push_back({.method = std::string(rung.name),
                          .precision = precision,
                          .order = rung.claims.order,
                          .errors =
                              [=](long steps, int trial) {
                                const Real h = time_step(steps);
                                return watched((*list)[static_cast<std::size_t>(trial)], frames,
                                               [&](Top<Real>& top, long) {
                                                 for (long n = 0; n < steps; ++n) rung.turn(top, h);
                                               });
                              },
                          .trials = trials,
                          .nanoseconds =
                              [=](long steps, int repetitions) {
                                const Real h = time_step(steps);
                                return time_of_run<Real>(
                                    (*list)[0].start, repetitions, [&](Top<Real>& top) {
                                      for (long n = 0; n < steps * frames.count; ++n)
                                        rung.turn(top, h);
                                    });
                              }});
  }
  if (kinds.own && tumbles)
    for (const FreeTopRung<Real>& rung : free_top_rungs<Real>)
      candidates.push_back(own_steps(rung, precision, frames, longest_run, list));
  if (!kinds.any()) return;
  const auto time_of_frame = [frames](long frame) {
    return static_cast<Real>(static_cast<long double>(frame) /
                             static_cast<long double>(frames.rate));
  };
  candidates.push_back({.method = "exact solution",
                        .precision = precision,
                        .takes_steps = false,
                        .errors =
                            [=](long, int trial) {
                              const Trial<Real>& given = (*list)[static_cast<std::size_t>(trial)];
                              const exact::FreeTop<Real> exact(given.start);
                              return watched(given, frames, [&](Top<Real>& top, long frame) {
                                top = exact.at(time_of_frame(frame));
                              });
                            },
                        .trials = trials,
                        .nanoseconds =
                            [=](long, int repetitions) {
                              return time_of_run<Real>(
                                  (*list)[0].start, repetitions, [&](Top<Real>& top) {
                                    const exact::FreeTop<Real> exact(top);
                                    for (long frame = 1; frame <= frames.count; ++frame) {
                                      top = exact.at(time_of_frame(frame));
                                      asm volatile("" : : "r"(&top) : "memory");
                                    }
                                  });
                            }});
}

}  // namespace tumble::advise
