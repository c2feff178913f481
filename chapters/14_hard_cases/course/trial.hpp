/// @file
/// The hard cases of a free top, each with what "right" means for it, and the verdict on a rung.
#pragma once

#include <course/record.hpp>
#include <course/rules.hpp>
#include <course/rungs.hpp>
#include <functional>

namespace tumble::course {

/// What a rung made of a case. `fault` is what it got wrong most: '.' nothing, 'E' the energy, 'L'
/// the angular momentum, 'P' the phase, 'D' it diverged.
struct Verdict {
  char fault = '.';
  std::string number;  ///< the worst of the three against its limit, or the step of the end
};

/// The largest errors that are let pass: energy and L relative, the angle in rad.
//! [limits]
struct Limits {
  double energy, momentum, angle;
};
//! [limits]

/// The verdict on a motion that was watched.
inline Verdict judged(const Motion& motion, const Limits& limits) {
  if (motion.diverged > 0) return {'D', "step " + std::to_string(motion.diverged)};
  const std::array<double, 3> found = {motion.energy_error, motion.momentum_error, motion.angle},
                              allowed = {limits.energy, limits.momentum, limits.angle};
  const std::array<const char*, 3> shown = {"E ", "L ", "φ "};
  std::size_t worst = 0;
  for (std::size_t n = 1; n < 3; ++n)
    if (found[n] / allowed[n] > found[worst] / allowed[worst]) worst = n;
  const bool passed = found[worst] <= allowed[worst];
  return {passed ? '.' : "ELP"[worst], shown[worst] + number("%.0e", found[worst])};
}

/// A hard case: a name for the table's head, and the trial of a rung.
template <class Real>
struct HardCase {
  std::string name;
  std::function<Verdict(const TurningRung<Real>&)> trial;
};

/// One of the problems A to D.
template <class Real>
HardCase<Real> problem_case(const TumblingProblem& problem, const Limits& limits) {
  return {std::string(1, problem.letter), [&problem, limits](const TurningRung<Real>& rung) {
            return judged(watched<Real>(problem, rung.turn), limits);
          }};
}

/// A disc of which |L|/I is 20 rad a step. Symmetric, so there is no excuse: the motion is two
/// steady turns, however long the step. What is let pass is the turns of the longest row in each of
/// 30 steps, with three roundings of an angle of up to 40 rad each.
template <class Real>
HardCase<Real> long_step_case() {
  return {
      "20 rad a step", [](const TurningRung<Real>& rung) {
        const Top<Real> disc{.angular_momentum_body = {Real(0.6), 0, Real(0.8)},
                             .inverse_moments = {1, 1, Real(0.5)}};
        const double rounding =
            30 * double(most_turns) * 3 * 40 * std::numeric_limits<Real>::epsilon() / 2;
        return judged(watched<Real>(disc, rung.turn, 30, 30, 20), {rounding, rounding, rounding});
      }};
}

/// Problem A at 100 rad a step, where nothing can be right any more: it shall stay finite.
template <class Real>
HardCase<Real> endless_step_case() {
  return {"100 rad", [](const TurningRung<Real>& rung) {
            const Top<Real> top = top_of<Real>(tumbling_problems[0]);
            const Real step = 100 / angular_velocity_body(top).norm();
            const Motion motion = watched<Real>(top, rung.turn, 1000, 0, step);
            if (motion.diverged > 0) return judged(motion, {});
            return Verdict{'.', "finite"};
          }};
}

/// A steady spin, so slow that a step turns by a ten-millionth of a radian: after 20 000 steps the
/// body shall have come as far as it should, to a thousandth.
template <class Real>
HardCase<Real> crawling_case() {
  return {"crawl", [](const TurningRung<Real>& rung) {
            Top<Real> top = top_of<Real>(tumbling_problems[0]);
            top.angular_momentum_body = {0, 0, 1};
            const Real step = Real(1e-7) / angular_velocity_body(top).norm();
            const double part = 1e-3;
            return judged(watched<Real>(top, rung.turn, 20'000, 20'000, step),
                          {part, part, part * 2e-3});
          }};
}

/// All of them, with what the chapter asks for. In float the rod's phase is left out: its spin
/// magnifies the rounding of its start.
template <class Real>
std::vector<HardCase<Real>> hard_cases() {
  const bool single = std::is_same_v<Real, float>;
  const double any = std::numeric_limits<double>::infinity();
  return {problem_case<Real>(tumbling_problems[0], {1e-4, 1e-4, 1e-3}),
          problem_case<Real>(tumbling_problems[1], {1e-4, 1e-4, 1e-3}),
          problem_case<Real>(tumbling_problems[2],
                             single ? Limits{1e-4, 1e-4, any} : Limits{1e-4, 1e-10, 1e-3}),
          problem_case<Real>(tumbling_problems[3], {1e-4, any, any}),
          long_step_case<Real>(),
          endless_step_case<Real>(),
          crawling_case<Real>()};
}

}  // namespace tumble::course
