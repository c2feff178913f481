/// @file
/// How many steps a simulation takes.
#pragma once

#include <cmath>
#include <optional>
#include <support/usage_error.hpp>
#include <tumble/scene/scene.hpp>

namespace tumble::simulate {

/// The steps whose end comes nearest to the end of the simulation: `until` (s), or what the scene
/// says.
/// @throws UsageError if that is none.
template <class Real, class Backend>
std::int64_t steps_until(const Scene<Real, Backend>& scene, std::optional<double> until = {}) {
  const double h = time_step_of<double>(scene.world.step_length());
  const double duration = until.value_or(scene.duration);
  const std::int64_t steps = std::llround(duration / h);
  if (steps == 0)
    throw support::UsageError((until ? "--until is " : "the scene lasts ") + text_of(duration) +
                              " s; that is less than half a step of " + text_of(h) +
                              " s, and only whole steps are taken");
  return steps;
}

}  // namespace tumble::simulate
