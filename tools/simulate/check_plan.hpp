/// @file
/// Steps a scene by its plan and beside it exhaustively, and says where they part.
#pragma once

#include "plan_comparison.hpp"
#include "simulated_scene.hpp"
#include "steps_until.hpp"

namespace tumble::simulate {

/// @return all_simulated if they never part, else step_failed.
/// @throws UsageError, SceneError.
template <class Real>
ExitCode check_plan(const Options& options) {
  SceneInPacks<Real> scene = scene_of<Real>(options);
  const std::int64_t steps = steps_until(scene, options.until);
  ManyBodies<Real>& planned = scene.world;
  planned.on_warning([](const std::string&) {});
  support::settle(planned);
  ManyBodies<Real> exhaustive = planned;
  planned.use_threads(options.threads);
  std::printf("%s", table_of(planned.plan()).c_str());
  const Comparison comparison = compared(planned, exhaustive, steps);
  std::printf("%s", comparison.said.c_str());
  return comparison.code;
}

}  // namespace tumble::simulate
