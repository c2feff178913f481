/// @file
/// How long the next step may be, from the errors of the last ones, and the integration that is
/// made of such steps.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <tumble/require.hpp>

namespace tumble {

/// The logarithm of a normal float to the base 2, and back, each within 0.045: its bits are the
/// exponent and then the fraction, so read as a whole number they count powers of two, with
/// straight lines in between. That is accurate enough for the length of a step.
inline float rough_log2(float value) {
  return static_cast<float>(std::bit_cast<std::int32_t>(value)) / 8388608.0F - 126.957F;
}
inline float rough_exp2(float exponent) {
  return std::bit_cast<float>(static_cast<std::int32_t>((exponent + 126.957F) * 8388608.0F));
}

/// Chooses steps so that the error of each is what is allowed. If errors fall as h^power, the
/// factor (1/error)^(1/power) leads there at once, but by itself it hunts where stability limits
/// the step. So the error before counts as well, by 0.3/power integral and 0.4/power proportional
/// (Gustafsson 1991); own_steps.md derives these and the reserve of 0.85. After a step that failed
/// the factor is that of its own error alone.
//! [step_control]
class StepControl {
 public:
  /// Of a method whose error, measured against what a step is allowed, falls as h to this power.
  explicit StepControl(int power) : power_(static_cast<float>(power)) {}

  /// The factor for a step whose error was the root of `square`, of which 1 is allowed.
  float factor(float square) {
    if (!(square < std::numeric_limits<float>::max())) return failed(0.1F);
    const float digits = rough_log2(std::max(square, 1e-18F)) / 2;
    if (square > 1) return failed(0.85F * rough_exp2(-digits / power_));
    const float wanted = 0.85F * rough_exp2((-0.7F * digits + 0.4F * last_digits_) / power_);
    last_digits_ = digits;
    const float longest = has_failed_ ? 1.0F : 6.0F;  // not at once where one has just failed
    has_failed_ = false;
    return std::clamp(wanted, 0.2F, longest);
  }

 private:
  float failed(float wanted) {
    has_failed_ = true;
    return std::clamp(wanted, 0.1F, 0.9F);
  }

  float power_, last_digits_ = 0;
  bool has_failed_ = false;
};
//! [step_control]

/// Checks on entry what an integration is asked for; the tolerance is in `unit`.
/// @throws std::invalid_argument unless the seconds are 0 or more and the tolerance more than 0,
/// both finite.
template <class Real>
void require_tolerance(Real seconds, Same<Real> tolerance, const char* name = "tolerance",
                       const char* unit = "a second") {
  require_not_negative("time", seconds, "s");
  require_finite(name, tolerance, unit);
  if (!(tolerance > 0)) reject(name, tolerance, unit, "it must be greater than 0");
}

/// What a particle may lose in a second. Positions and velocities have different units, so each
/// has a tolerance of its own.
//! [particle_tolerance]
template <class Real>
struct ParticleTolerance {
  Real position;  ///< m a second
  Real velocity;  ///< m/s a second
};
//! [particle_tolerance]

/// The same for both tolerances of a particle.
template <class Real>
void require_tolerance(Real seconds, const ParticleTolerance<Same<Real>>& tolerance) {
  require_tolerance(seconds, tolerance.position, "tolerance of the position", "m a second");
  require_tolerance(seconds, tolerance.velocity, "tolerance of the velocity", "m/s a second");
}

/// What an integration took.
struct StepCounts {
  long steps = 0, rejected = 0;
};

/// No step will do: each that meets the tolerance is too short to move the clock, or its length
/// would not be positive and finite.
class StepError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// @throws StepError: a step of h seconds, so long after the start, is one that no clock shows.
template <class Real>
[[noreturn]] void fail_at(Real h, Same<Real> gone, const char* reason) {
  throw StepError("the time step fell to " + text_of(h) + " s, " + text_of(gone) +
                  " s after the start; " + reason);
}

/// The length of the first step (s), no more than `seconds`. `rate` is the error in a second, in
/// tolerances, if the rates were left out, and `changes` (1/s) the same for how fast they change.
/// With r = changes/rate a step errs by about rate (h r)^power.
template <class Real>
Real first_step_of(Real rate, Same<Real> changes, int power, Same<Real> seconds) {
  const Real wanted = 2 * rate / changes * std::pow(rate, -1 / static_cast<Real>(power));
  return wanted < seconds ? wanted : seconds;
}

/// Takes a stepper through `seconds`, beginning with a step of `first` seconds. attempt(h) makes a
/// step of h seconds and returns the square of its error, with 1 allowed; accept() makes it count.
/// A step that is not accepted is repeated, shorter. `when_stepped(gone, h)` is called for each
/// accepted step before it counts.
///
/// The last step is what is left of the integration, to a rounding, and shares the remaining time
/// with the one before it, lest a tiny step be left. No step is longer than `longest` (s).
/// @throws StepError if steps fall below what the clock can show.
//! [integrate_adaptively]
template <class Real, class Stepper, class WhenStepped>
StepCounts integrate_adaptively(Stepper& stepper, Real seconds, Same<Real> first,
                                const WhenStepped& when_stepped,
                                Same<Real> longest = std::numeric_limits<Real>::infinity()) {
  StepControl control(Stepper::power);
  StepCounts counts;
  Real gone = 0, h = first;
  while (gone < seconds) {
    const Real left = seconds - gone;
    h = std::min(h, longest);
    const bool is_last = h >= left;
    if (is_last)
      h = left;
    else if (2 * h > left)
      h = left / 2;
    const auto square = static_cast<float>(stepper.attempt(h));
    if (square <= 1) {
      when_stepped(gone, h);
      stepper.accept();
      gone = is_last ? seconds : gone + h;
      ++counts.steps;
    } else {
      ++counts.rejected;
    }
    h *= static_cast<Real>(control.factor(square));
    // Near the start any step moves the clock, but the shortest of all is not made shorter by
    // rounding.
    const bool is_shown = gone + h > gone && h >= std::numeric_limits<Real>::min();
    if (gone < seconds && !is_shown)
      fail_at(h, gone, "no step meets the tolerance there; if a force jumps, name an event");
  }
  return counts;
}
//! [integrate_adaptively]

}  // namespace tumble
