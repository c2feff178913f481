#include "scene_file.hpp"

#include <chrono>
#include <memory>
#include <optional>
#include <support/scene_rules.hpp>
#include <tumble/scene/number_range.hpp>
#include <tumble/scene/read_scene_file.hpp>

#include "reference.hpp"

namespace tumble::advise {
namespace {

using Clock = std::chrono::steady_clock;

/// By what a scene is stepped.
struct Choice {
  std::optional<std::size_t> method = {};
  std::optional<Scheme> scheme = {};
};

template <class Real>
Scene<Real> scene_with(const std::filesystem::path& file, const StepLength& step,
                       const Choice& choice) {
  Scene<Real> scene = read_scene_file<Real, OneByOne<Real>, support::SceneRules>(
      file, {.step = step, .turning_method = choice.method, .scheme = choice.scheme});
  scene.world.on_warning([](const std::string&) {});  // nobody asked for the steps that are tried
  return scene;
}

/// The whole run, a snapshot for each frame that is compared. @throws SimulationError.
template <class Real>
std::vector<Snapshot> snapshots_of(World<Real> world, const Frames& frames, long steps) {
  std::vector<Snapshot> snapshots;
  for (long frame = 1; frame <= frames.count; ++frame) {
    for (long n = 0; n < steps; ++n) world.step();
    if (is_compared(frame, frames)) snapshots.push_back(snapshot_of(world.bodies()));
  }
  return snapshots;
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
          snapshots_of(scene_with<Real>(file, steps_per_second(frames.rate * steps), choice).world,
                       frames, steps),
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
    World<Real> start = scene_with<Real>(file, steps_per_second(frames.rate * steps), choice).world;
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
  World<Real> world = scene_with<Real>(file, steps_per_second(frames.rate), {}).world;
  const std::string chosen = world.turning_method();
  const bool tumbles = tumbling_of(world.step_plan()).members.size() > 0;
  const bool is_kicked = std::any_of(world.flags().begin(), world.flags().end(),
                                     [](const BodyFlags& flags) { return flags.is_pushed; }) ||
                         !world.step_plan().in_phase[std::size_t(Phase::kick)].empty();
  for (std::size_t method = 0; method < support::SceneRules::names.size(); ++method) {
    const std::string_view name = support::SceneRules::names[method];
    if (!tumbles && name != chosen) continue;  // without a tumbling body they are all the same
    int order = 0;
    support::SceneRules::choose(world, method);
    for (const Scheme scheme : {Scheme::semi_implicit_euler, Scheme::verlet, Scheme::suzuki}) {
      world.step_by(scheme);
      const int promised = world.plan().accuracy.order;
      if (order > 0 && !is_kicked) continue;
      // Verlet's may be nearer where it promises no more, being symmetric; Suzuki's has five kicks
      // a step.
      if (promised == 0 || (promised <= order && scheme != Scheme::verlet)) continue;
      order = promised;
      Candidate candidate =
          candidate_of<Real>(file, frames, reference, {.method = method, .scheme = scheme});
      candidate.method = turning_method_words<support::SceneRules>()[method];
      if (scheme != Scheme::semi_implicit_euler)
        candidate.scheme = scheme_words()[std::size_t(scheme)];
      candidate.precision = std::string(range_of<Real>().precision);
      candidate.order =
          is_kicked ? promised : tumbling_of(world.step_plan()).effect->traits().order.value_or(1);
      made.candidates.push_back(std::move(candidate));
    }
  }
}

}  // namespace

SceneCandidates scene_candidates(const std::filesystem::path& file, const Frames& frames,
                                 const Tolerance& tolerance, const Precisions& precisions,
                                 double longest_run) {
  SceneCandidates made;
  made.bodies = scene_with<double>(file, steps_per_second(frames.rate), {}).world.body_count();
  // The scheme of the highest order: what the scene's effects take from it is found by the way.
  const auto reference = std::make_shared<const Reference>(reference_of(
      [&](const StepLength& step) {
        return scene_with<double>(file, step, {.scheme = Scheme::suzuki});
      },
      frames, tolerance, longest_run));
  made.uncertainty = reference->uncertainty;
  made.reference_steps = reference->steps;
  if (precisions.twice) append<double>(made, file, frames, reference);
  try {
    if (precisions.single) append<float>(made, file, frames, reference);
  } catch (const SceneError&) {  // float can't hold this scene, so double is all there is
    if (!precisions.twice) throw;
  }
  return made;
}

}  // namespace tumble::advise
