#include "scene_file.hpp"

#include <chrono>
#include <cmath>
#include <memory>
#include <optional>
#include <support/scene_rules.hpp>
#include <tumble/scene/number_range.hpp>
#include <tumble/scene/read_scene_file.hpp>

namespace tumble::advise {
namespace {

using Clock = std::chrono::steady_clock;

/// Where all bodies are at one moment.
struct Snapshot {
  std::vector<Vec3d> places;
  std::vector<Quaterniond> orientations;
};

/// More frames than this are not compared; they are then spread evenly, with the last among them.
constexpr long most_snapshots = 100;

/// By what a scene is stepped.
struct Choice {
  std::optional<std::size_t> method = {};
  std::optional<Scheme> scheme = {};
};

template <class Real>
Scene<Real> scene_with(const std::filesystem::path& file, const Frames& frames, long steps,
                       const Choice& choice) {
  return read_scene_file<Real, OneByOne<Real>, support::SceneRules>(
      file, {.step = steps_per_second(frames.rate * steps),
             .turning_method = choice.method,
             .scheme = choice.scheme});
}

template <class Real>
Snapshot snapshot_of(const Bodies<Real>& bodies) {
  Snapshot snapshot;
  for (const Particle<Real>& centre : bodies.centres)
    snapshot.places.push_back(centre.position.template cast<double>());
  for (const Top<Real>& top : bodies.tops)
    snapshot.orientations.push_back({static_cast<double>(top.orientation.real),
                                     top.orientation.imaginary.template cast<double>()});
  return snapshot;
}

/// The whole run, a snapshot for each frame that is compared. @throws SimulationError.
template <class Real>
std::vector<Snapshot> snapshots_of(World<Real> world, const Frames& frames, long steps) {
  const long between = (frames.count + most_snapshots - 1) / most_snapshots;
  std::vector<Snapshot> snapshots;
  for (long frame = 1; frame <= frames.count; ++frame) {
    for (long n = 0; n < steps; ++n) world.step();
    if ((frames.count - frame) % between == 0) snapshots.push_back(snapshot_of(world.bodies()));
  }
  return snapshots;
}

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

/// Richardson: what two runs, one with steps half as long, say about steps of length zero. With
/// errors that fall as the step to the power `order`, the finer run has 1/(2^order − 1) of their
/// difference still to go.
std::vector<Snapshot> extrapolated(const std::vector<Snapshot>& coarse,
                                   const std::vector<Snapshot>& fine, int order) {
  const double rest = 1 / (std::exp2(order) - 1);
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

struct Reference {
  std::vector<Snapshot> snapshots;
  Errors uncertainty = failed_run;
  long steps = 0;
};

/// Steps half as long each time. Two extrapolated runs that agree tell how far the better one may
/// be off: no less than rounding lets two runs agree.
Reference reference_of(const std::filesystem::path& file, const Frames& frames,
                       const Tolerance& tolerance, double longest_run) {
  Reference best;
  // The scheme of the highest order: what the scene's effects take from it is found by the way.
  const Choice choice = {.scheme = Scheme::suzuki};
  std::vector<Snapshot> last;
  std::optional<std::vector<Snapshot>> last_extrapolated;
  double last_difference = 0;
  for (long steps = 1; frames.rate * steps <= 1'000'000; steps *= 2) {
    const auto begin = Clock::now();
    std::vector<Snapshot> now;
    try {
      now = snapshots_of(scene_with<double>(file, frames, steps, choice).world, frames, steps);
    } catch (const SimulationError&) {
      if (2 * frames.rate * steps > 1'000'000) throw;
      last.clear();
      last_extrapolated.reset();
      continue;
    }
    const double took = std::chrono::duration<double>(Clock::now() - begin).count();
    if (!last.empty()) {
      const Errors difference = errors_between(now, last);
      const double size = difference.of({.angle = 1, .place = 1});
      // The world's orders go from 1 to 10; what falls more slowly is no order at all.
      const double fall = last_difference > 0 && size > 0 ? last_difference / size : 2;
      const auto better = extrapolated(
          last, now, std::clamp(static_cast<int>(std::lround(std::log2(fall))), 1, 10));
      if (last_extrapolated) {
        const Errors uncertainty = errors_between(better, *last_extrapolated);
        if (uncertainty.of(tolerance) < best.uncertainty.of(tolerance))
          best = {better, uncertainty, steps};
        if (best.uncertainty.of(tolerance) <= 0.02) return best;  // enough for a tenth of it too
      }
      last_extrapolated = better;
      last_difference = size;
    }
    last = std::move(now);
    if (2 * took > longest_run) break;
  }
  return best;
}

/// A world stepped by one choice: its errors and its time.
template <class Real>
Candidate candidate_of(const std::filesystem::path& file, const Frames& frames,
                       const std::shared_ptr<const Reference>& reference, const Choice& choice) {
  Candidate made;
  made.errors = [=](long steps, int) {
    if (frames.rate * steps > 1'000'000) return failed_run;
    try {
      Errors errors = errors_between(
          snapshots_of(scene_with<Real>(file, frames, steps, choice).world, frames, steps),
          reference->snapshots);
      errors.angle += reference->uncertainty.angle;
      errors.place += reference->uncertainty.place;
      return errors;
    } catch (const SimulationError&) {
      return failed_run;
    }
  };
  made.nanoseconds = [=](long steps, int repetitions) {
    double best = std::numeric_limits<double>::infinity();
    if (frames.rate * steps > 1'000'000) return best;
    World<Real> start = scene_with<Real>(file, frames, steps, choice).world;
    start.plan();
    for (int run = 0; run < repetitions; ++run) {
      World<Real> world = start;
      const auto begin = Clock::now();
      try {
        for (long step = 0; step < steps * frames.count; ++step) world.step();
      } catch (const SimulationError&) {
        return std::numeric_limits<double>::infinity();
      }
      best = std::min(best, std::chrono::duration<double, std::nano>(Clock::now() - begin).count());
    }
    return best;
  };
  return made;
}

template <class Real>
void append(SceneCandidates& made, const std::filesystem::path& file, const Frames& frames,
            const std::shared_ptr<const Reference>& reference) {
  World<Real> world = scene_with<Real>(file, frames, 1, {}).world;
  const std::string chosen = world.turning_method();
  const bool tumbles = !world.work().tumbling.empty();
  const bool is_kicked = !world.work().pushed.empty() || !world.work().torqued.empty() ||
                         !world.work().in_phase[std::size_t(Phase::kick)].empty();
  for (std::size_t method = 0; method < support::SceneRules::names.size(); ++method) {
    const std::string_view name = support::SceneRules::names[method];
    if (!tumbles && name != chosen) continue;  // without a tumbling body they are all the same
    int order = 0;
    support::SceneRules::choose(world, method);
    for (const Scheme scheme : {Scheme::semi_implicit_euler, Scheme::verlet, Scheme::suzuki}) {
      world.step_by(scheme);
      const int promised = world.plan().accuracy.order;
      if (promised <= order || (order > 0 && !is_kicked)) continue;  // more kicks for nothing
      order = promised;
      Candidate candidate =
          candidate_of<Real>(file, frames, reference, {.method = method, .scheme = scheme});
      candidate.method = turning_method_words<support::SceneRules>()[method];
      if (scheme != Scheme::semi_implicit_euler)
        candidate.scheme = scheme_words()[std::size_t(scheme)];
      candidate.precision = std::string(range_of<Real>().precision);
      candidate.order = is_kicked ? promised : world.work().rule->order().value_or(1);
      made.candidates.push_back(std::move(candidate));
    }
  }
}

}  // namespace

SceneCandidates scene_candidates(const std::filesystem::path& file, const Frames& frames,
                                 const Tolerance& tolerance, const Precisions& precisions,
                                 double longest_run) {
  SceneCandidates made;
  made.bodies = scene_with<double>(file, frames, 1, {}).world.body_count();
  const auto reference =
      std::make_shared<const Reference>(reference_of(file, frames, tolerance, longest_run));
  made.uncertainty = reference->uncertainty;
  made.reference_steps = reference->steps;
  if (reference->snapshots.empty()) return made;
  if (precisions.twice) append<double>(made, file, frames, reference);
  try {
    if (precisions.single) append<float>(made, file, frames, reference);
  } catch (const SceneError&) {  // float can't hold this scene, so double is all there is
    if (!precisions.twice) throw;
  }
  return made;
}

}  // namespace tumble::advise
