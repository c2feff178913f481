/// @file
/// The step of a top: the kick that its torques give, and the drift by the rule that chapter 8
/// chose.
#pragma once

#include <tumble/splitting.hpp>
#include <tumble/turning_rules.hpp>

namespace tumble {

/// What the accumulated torque does in `time_step` seconds (h): L ← L + h τ.
//! [kick]
template <class Real>
void kick(Top<Real>& top, Same<Real> time_step) {
  add_angular_momentum(top, time_step * top.torque);
}
//! [kick]

/// Turns freely for `time_step` seconds: steadily where that is exact, by splitting elsewhere.
///
/// Angles |L| h/I up to twice SineCosineConstants::limit are turned as asked; beyond, the
/// orientation is NaN.
//! [drift]
template <class Real>
void drift(Top<Real>& top, Same<Real> time_step) {
  if (is_gyroscopic(top))
    turn_by_splitting(top, time_step);
  else
    turn_steadily(top, time_step);
}
//! [drift]

}  // namespace tumble
