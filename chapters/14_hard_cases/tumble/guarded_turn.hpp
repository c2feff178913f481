/// @file
/// A rung of the ladder that stops where it would leave the numbers, as a world does.
#pragma once

#include <tumble/guard.hpp>
#include <tumble/ladder.hpp>

namespace tumble {

/// A rung could not be taken. The top is as it was before.
class TurnError : public std::runtime_error {
 public:
  TurnError(std::string_view of_rung, const std::string& what_it_does)
      : std::runtime_error("'" + std::string(of_rung) + "' " + what_it_does), rung(of_rung) {}
  std::string rung;  ///< its name
};

/// Throws if the top is one that no step of this length can turn.
template <class Real>
void require_turnable(const TurningRung<Real>& rung, const Top<Real>& top, Same<Real> time_step) {
  if (can_drift(top, time_step)) return;
  throw TurnError(rung.name, "would turn by up to " + text_of(largest_turn(top, time_step)) +
                                 " rad in a step; at most " +
                                 text_of(2 * SineCosineConstants<Real>::limit) +
                                 " rad can be turned");
}

/// One step by a rung of turning_ladder, with the guard of chapter 11 before it and after it.
/// @throws TurnError if the top turns, or would turn in the next step, by more than twice
/// SineCosineConstants::limit, or if the rung leads to a number that is infinite or NaN. The
/// sentence names the rung and the angle.
//! [turn_or_stop]
template <class Real>
void turn_or_stop(const TurningRung<Real>& rung, Top<Real>& top, Same<Real> time_step) {
  require_turnable(rung, top, time_step);
  Top<Real> turned = top;
  rung.turn(turned, time_step);
  if (is_finite(turned.angular_momentum_body)) require_turnable(rung, turned, time_step);
  if (!is_finite(turned.angular_momentum_body) || !std::isfinite(norm(turned.orientation)))
    throw TurnError(rung.name, "finds no finite turn for a top that turns by up to " +
                                   text_of(largest_turn(top, time_step)) + " rad in a step");
  top = turned;
}
//! [turn_or_stop]

}  // namespace tumble
