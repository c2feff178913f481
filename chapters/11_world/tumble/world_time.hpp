/// @file
/// How far a world has come in time, though its step may change on the way.
#pragma once

#include <tumble/step_clock.hpp>
#include <tumble/terms.hpp>

namespace tumble {

/// How many steps a world has taken, and since when they have been as long as they are.
template <class Real>
struct WorldTime {
  std::int64_t ticks = 0;       ///< steps taken, of any length
  StepLength step = {0, 0};     ///< how long one is now; a denominator of 0: not known
  std::int64_t first_tick = 0;  ///< the first step of this length
  Real start = 0;               ///< when that began, s

  /// With the time step in s: when the next step begins, s. As long as the step is the first one,
  /// it is n h, with one rounding of the product, and one of n where it has more digits than Real.
  Real time(Real time_step) const {
    const Real since = static_cast<Real>(ticks - first_tick) * time_step;
    return start + since;  // in a statement of its own: clang would fuse product and sum
  }
};

/// The same moment in a world whose steps last `step` from then on.
template <class Real>
WorldTime<Real> continued(const WorldTime<Real>& then, const StepLength& step) {
  const bool is_known = then.step.denominator != 0;
  if (!is_known || then.step == step) return {then.ticks, step, then.first_tick, then.start};
  return {then.ticks, step, then.ticks, then.time(time_step_of<Real>(then.step))};
}

}  // namespace tumble
