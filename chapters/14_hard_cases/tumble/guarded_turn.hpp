/// @file
/// A rung of the ladder that stops where it would leave the numbers, as a world does.
#pragma once

#include <tumble/failure.hpp>
#include <tumble/ladder.hpp>

namespace tumble {

/// A rung could not be taken. The top is as it was before.
class TurnError : public std::runtime_error {
 public:
  TurnError(std::string_view of_rung, const std::string& what_it_does)
      : std::runtime_error("'" + std::string(of_rung) + "' " + what_it_does), rung(of_rung) {}
  std::string rung;  ///< its name
};

/// One step by a rung of turning_ladder, with the guard of chapter 11 after it.
/// @throws TurnError if the rung leads to a number that is infinite or NaN. The sentence names the
/// rung, the angle |ω| h, and how far any rung can turn.
//! [turn_or_stop]
template <class Real>
void turn_or_stop(const TurningRung<Real>& rung, Top<Real>& top, Same<Real> time_step) {
  Top<Real> turned = top;
  rung.turn(turned, time_step);
  if (!is_finite(turned))
    throw TurnError(rung.name, "would turn by " + turn_too_far(top, time_step));
  top = turned;
}
//! [turn_or_stop]

}  // namespace tumble
