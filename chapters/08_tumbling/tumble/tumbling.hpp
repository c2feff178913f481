/// @file
/// The step of a top: the kick that its torques give, and the drift by the rule that chapter 8
/// chose.
#pragma once

#include <tumble/rigid_body.hpp>
#include <tumble/splitting_without_sine.hpp>
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
/// Steps with |L| h/I up to twice SineCosineConstants::limit, I being the smallest moment, are
/// turned as asked. Beyond, the orientation is NaN if a turn of the step exceeds that limit: for a
/// needle it need not, as long as L is perpendicular to the needle.
//! [drift]
template <class Real>
void drift(Top<Real>& top, Same<Real> time_step) {
  if (is_gyroscopic(top))
    turn_by_splitting(top, time_step);
  else
    turn_steadily(top, time_step);
}
//! [drift]

/// The kick of a whole body: its particle's and its top's.
template <class Real>
void kick(RigidBody<Real>& body, Same<Real> time_step) {
  kick(body.centre, time_step);
  kick(body.top, time_step);
}

/// The drift of a whole body, in free flight.
template <class Real>
void drift(RigidBody<Real>& body, Same<Real> time_step) {
  drift(body.centre, time_step);
  drift(body.top, time_step);
}

}  // namespace tumble
