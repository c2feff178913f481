#include "reference.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace tumble::advise {
namespace {

using Clock = std::chrono::steady_clock;

constexpr long most_steps_a_second = 1'000'000;

/// How long a step lasts, to a millionth of a nanosecond: for what an effect computes in advance.
StepLength step_of_length(double h) {
  return {std::llround(h * 1e15), 1'000'000};
}

/// The whole run with so many steps in each piece of a frame: a frame is one piece, unless effects
/// switch in it. By Suzuki's scheme forces are evaluated between the ends of a step, so within a
/// piece each is the same smooth function of the motion.
std::vector<Snapshot> run_in_pieces(const SceneWith& scene_with, const Frames& frames, long steps) {
  const Scene<double> scene = scene_with(steps_per_second(frames.rate * steps));
  std::vector<double> switches = scene.switches;
  std::sort(switches.begin(), switches.end());
  OneByOne<double> kept(scene.world.bodies());
  const auto carry = [&](const World<double>& world, double begin, double end) {
    const double h = (end - begin) / static_cast<double>(steps);
    for (long n = 0; n < steps; ++n) {
      const double time = begin + static_cast<double>(n) * h;
      if (const auto lost = kept.step(world.step_plan(), {time, h}))
        throw failure<double>(world.name_of(world.handle_at(*lost)), *lost, kept.bodies(),
                              world.step_plan(), std::lround(time / h), {time, h});
    }
  };
  std::vector<Snapshot> snapshots;
  double begin = 0;
  for (long frame = 1; frame <= frames.count; ++frame) {
    const double end = static_cast<double>(frame) / static_cast<double>(frames.rate);
    auto next = std::upper_bound(switches.begin(), switches.end(), begin);
    if (next == switches.end() || *next >= end) {
      carry(scene.world, begin, end);
    } else {
      for (; begin < end; next = std::upper_bound(next, switches.end(), begin)) {
        const double piece_end = next == switches.end() ? end : std::min(*next, end);
        const double h = (piece_end - begin) / static_cast<double>(steps);
        carry(scene_with(step_of_length(h)).world, begin, piece_end);
        begin = piece_end;
      }
    }
    begin = end;
    if (is_compared(frame, frames)) snapshots.push_back(snapshot_of(kept.bodies()));
  }
  return snapshots;
}

}  // namespace

Errors errors_between(const std::vector<Snapshot>& mine, const std::vector<Snapshot>& truth) {
  Errors errors;
  for (std::size_t n = 0; n < mine.size(); ++n) {
    for (std::size_t body = 0; body < mine[n].places.size(); ++body) {
      const double off = (mine[n].places[body] - truth[n].places[body]).norm();
      if (!std::isfinite(off)) return failed_run;
      errors.place = std::max(errors.place, off);
    }
    for (std::size_t top = 0; top < mine[n].orientations.size(); ++top) {
      const double off = angle_between(truth[n].orientations[top], mine[n].orientations[top]);
      if (!std::isfinite(off)) return failed_run;
      errors.angle = std::max(errors.angle, off);
    }
  }
  return errors;
}

int order_of_fall(double first_difference, double second_difference,
                  const std::array<long, 3>& steps) {
  if (!(first_difference > 0 && second_difference > 0)) return 1;
  const auto fall = [&](int order) {
    const auto error = [&](std::size_t n) {
      return std::pow(static_cast<double>(steps[n]), -order);
    };
    return (error(0) - error(1)) / (error(1) - error(2));
  };
  // The orders between which it falls meet where their falls have the same ratio to it.
  int order = 1;
  while (order < 10 &&
         std::pow(first_difference / second_difference, 2) > fall(order) * fall(order + 1))
    ++order;
  return order;
}

std::vector<Snapshot> extrapolated(const std::vector<Snapshot>& coarse,
                                   const std::vector<Snapshot>& fine, double ratio, int order) {
  const double rest = 1 / (std::pow(ratio, order) - 1);
  std::vector<Snapshot> result = fine;
  for (std::size_t n = 0; n < result.size(); ++n) {
    for (std::size_t body = 0; body < result[n].places.size(); ++body)
      result[n].places[body] += rest * (fine[n].places[body] - coarse[n].places[body]);
    for (std::size_t top = 0; top < result[n].orientations.size(); ++top) {
      const Vec3d turn =
          rotation_vector_of(conjugate(coarse[n].orientations[top]) * fine[n].orientations[top]);
      result[n].orientations[top] = normalized(fine[n].orientations[top] *
                                               quaternion_of_rotation_vector<double>(rest * turn));
    }
  }
  return result;
}

Reference reference_of(const SceneWith& scene_with, const Frames& frames,
                       const Tolerance& tolerance, double longest_run) {
  Reference best;
  std::vector<Snapshot> last;
  std::array<std::vector<Snapshot>, 2> last_estimates;  // the latest first
  double last_difference = 0;
  std::array<long, 3> counts = {1, 1, 1};  // of steps: the last two runs', and this one's
  for (; frames.rate * counts[2] <= most_steps_a_second;
       counts = {counts[1], counts[2], counts[1] + counts[2]}) {
    const auto begin = Clock::now();
    std::vector<Snapshot> now;
    try {
      now = run_in_pieces(scene_with, frames, counts[2]);
    } catch (const SimulationError&) {
      if (frames.rate * (counts[1] + counts[2]) > most_steps_a_second) throw;
      last.clear();
      last_estimates = {};
      last_difference = 0;
      continue;
    }
    const double took = std::chrono::duration<double>(Clock::now() - begin).count();
    const double ratio = static_cast<double>(counts[2]) / static_cast<double>(counts[1]);
    if (!last.empty()) {
      const double difference = errors_between(now, last).of({.angle = 1, .place = 1});
      std::vector<Snapshot> estimate =
          extrapolated(last, now, ratio, order_of_fall(last_difference, difference, counts));
      if (!last_estimates[1].empty()) {
        const Errors uncertainty = worse(errors_between(estimate, last_estimates[0]),
                                         errors_between(estimate, last_estimates[1]));
        if (uncertainty.of(tolerance) < best.uncertainty.of(tolerance))
          best = {estimate, uncertainty, {counts[1], counts[2]}};
        if (best.uncertainty.of(tolerance) <= 0.02) return best;  // enough for a tenth of it too
      }
      last_estimates = {std::move(estimate), std::move(last_estimates[0])};
      last_difference = difference;
    }
    last = std::move(now);
    if (took * (1 + 1 / ratio) > longest_run) break;
  }
  return best;
}

}  // namespace tumble::advise
