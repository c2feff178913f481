/// @file
/// How many steps a simulation takes.
#pragma once

#include <cmath>

#include "options.hpp"

namespace tumble::simulate {

/// The steps whose end comes nearest to the end of the simulation.
/// @throws UsageError if that is none.
template <class Real, class Keeping>
std::int64_t steps_until(const Scene<Real, Keeping>& scene, const Options& options) {
  const double h = time_step_of<double>(scene.world.step_length());
  const double duration = options.until.value_or(scene.duration);
  const std::int64_t steps = std::llround(duration / h);
  if (steps == 0)
    throw UsageError((options.until ? "--until is " : "the scene lasts ") + text_of(duration) +
                     " s; that is less than half a step of " + text_of(h) +
                     " s, and only whole steps are taken");
  return steps;
}

}  // namespace tumble::simulate
