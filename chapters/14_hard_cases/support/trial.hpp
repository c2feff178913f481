/// @file
/// The hard cases of a free top, each with what "right" means for it, and the verdict on a rung.
#pragma once

#include <support/rules.hpp>
#include <support/rungs.hpp>

namespace tumble::support {

/// What a rung made of a case. `fault` is what it got wrong most: '.' nothing, 'E' the energy, 'L'
/// the angular momentum, 'P' the phase, 'D' it diverged.
struct Verdict {
  char fault = '.';
  char worst = 'E';  ///< which of the three is worst against its limit
  double error = 0;  ///< that one
  int diverged = 0;  ///< the step of the end, or 0
};

/// The largest errors that are let pass: energy and L relative, the angle in rad.
struct Limits {
  double energy, momentum, angle;
};

/// The verdict on a motion that was watched.
inline Verdict judged(const Motion& motion, const Limits& limits) {
  if (motion.diverged > 0) return {.fault = 'D', .diverged = motion.diverged};
  const std::array<double, 3> found = {motion.energy_error, motion.momentum_error, motion.angle},
                              allowed = {limits.energy, limits.momentum, limits.angle};
  std::size_t worst = 0;
  for (std::size_t n = 1; n < 3; ++n)
    if (found[n] / allowed[n] > found[worst] / allowed[worst]) worst = n;
  const bool passed = found[worst] <= allowed[worst];
  const char letter = "ELP"[worst];
  return {.fault = passed ? '.' : letter, .worst = letter, .error = found[worst]};
}

/// A hard case: a name for the table's head, a top, how it is stepped and watched, and what is let
/// pass. A limit that is infinite lets pass whatever is finite.
template <class Real>
struct HardCase {
  std::string_view name;
  Top<Real> top;
  Real time_step;
  int steps, steps_to_angle;
  Limits limits;
};

/// The case in steps `factor` times as long, over the same time.
template <class Real>
HardCase<Real> stretched(HardCase<Real> hard, double factor) {
  hard.time_step = static_cast<Real>(factor * static_cast<double>(hard.time_step));
  hard.steps = static_cast<int>(std::ceil(hard.steps / factor));
  hard.steps_to_angle = static_cast<int>(std::ceil(hard.steps_to_angle / factor));
  return hard;
}

/// The case watched for so many steps at most. Of a shorter way the same part is let pass.
template <class Real>
HardCase<Real> shortened(HardCase<Real> hard, int most) {
  hard.steps = std::min(hard.steps, most);
  if (hard.steps_to_angle > most) {
    hard.limits.angle *= static_cast<double>(most) / hard.steps_to_angle;
    hard.steps_to_angle = most;
  }
  return hard;
}

template <class Real>
Verdict tried(const HardCase<Real>& hard, const TurningRung<Real>& rung) {
  return judged(watched<Real>(hard.top, rung.turn, hard.steps, hard.steps_to_angle, hard.time_step),
                hard.limits);
}

inline constexpr double any_error = std::numeric_limits<double>::infinity();

/// One of the problems A to D.
template <class Real>
HardCase<Real> problem_case(const TumblingProblem& problem, const Limits& limits) {
  return {.name = {&problem.letter, 1},
          .top = top_of<Real>(problem),
          .time_step = Real(1) / 60,
          .steps = 60 * problem.seconds,
          .steps_to_angle = 60 * problem.seconds_to_angle,
          .limits = limits};
}

/// A disc of which |L|/I is 20 rad a step. Symmetric, so there is no excuse: the motion is two
/// steady turns, however long the step. What is let pass is the turns of the longest row in each of
/// 30 steps, with three roundings of an angle of up to 40 rad each.
template <class Real>
HardCase<Real> long_step_case() {
  const double rounding =
      30 * double(most_turns) * 3 * 40 * std::numeric_limits<Real>::epsilon() / 2;
  return {.name = "20 rad a step",
          .top = {.angular_momentum_body = {Real(0.6), 0, Real(0.8)},
                  .inverse_moments = {1, 1, Real(0.5)}},
          .time_step = 20,
          .steps = 30,
          .steps_to_angle = 30,
          .limits = {rounding, rounding, rounding}};
}

/// Problem A at 100 rad a step, where nothing can be right any more: it shall stay finite.
template <class Real>
HardCase<Real> endless_step_case() {
  const Top<Real> top = top_of<Real>(tumbling_problems[0]);
  return {.name = "100 rad",
          .top = top,
          .time_step = 100 / angular_velocity_body(top).norm(),
          .steps = 1000,
          .steps_to_angle = 0,
          .limits = {any_error, any_error, any_error}};
}

/// A steady spin, so slow that a step turns by a ten-millionth of a radian: after 20 000 steps the
/// body shall have come as far as it should, to a thousandth.
template <class Real>
HardCase<Real> crawling_case() {
  Top<Real> top = top_of<Real>(tumbling_problems[0]);
  top.angular_momentum_body = {0, 0, 1};
  const double part = 1e-3;
  return {.name = "crawl",
          .top = top,
          .time_step = Real(1e-7) / angular_velocity_body(top).norm(),
          .steps = 20'000,
          .steps_to_angle = 20'000,
          .limits = {part, part, part * 2e-3}};
}

/// Problem A spun so fast that a step turns it by `angle` rad: no two moments are close, and no
/// piece of its motion is nearly the whole. For a minute, and the phase after a second.
template <class Real>
HardCase<Real> fast_case(Real angle = 1) {
  Top<Real> top = top_of<Real>(tumbling_problems[0]);
  const Real time_step = Real(1) / 60;
  top.angular_momentum_body *= angle / (time_step * angular_velocity_body(top).norm());
  return {.name = "A, 1 rad a step",
          .top = top,
          .time_step = time_step,
          .steps = 3600,
          .steps_to_angle = 60,
          .limits = {1e-4, 1e-4, 1e-3}};
}

/// All of them, with what the chapter asks for. In float the rod's phase is left out: its spin
/// magnifies the rounding of its start.
template <class Real>
std::array<HardCase<Real>, 8> hard_cases() {
  const bool single = std::is_same_v<Real, float>;
  return {problem_case<Real>(tumbling_problems[0], {1e-4, 1e-4, 1e-3}),
          problem_case<Real>(tumbling_problems[1], {1e-4, 1e-4, 1e-3}),
          problem_case<Real>(tumbling_problems[2],
                             single ? Limits{1e-4, 1e-4, any_error} : Limits{1e-4, 1e-10, 1e-3}),
          problem_case<Real>(tumbling_problems[3], {1e-4, any_error, any_error}),
          long_step_case<Real>(),
          endless_step_case<Real>(),
          crawling_case<Real>(),
          fast_case<Real>()};
}

}  // namespace tumble::support
