/// @file
/// The exact motion of a mass on a spring with damping, in all three regimes.
#pragma once

#include <limits>
#include <tumble/require.hpp>

namespace tumble::exact {

/// Where an oscillator is (m from its rest) and how fast it moves (m/s).
template <class Real>
struct OscillatorState {
  Real position = 0, velocity = 0;
};

/// x'' + 2 γ x' + w² x = 0, with the roots −γ ± √(γ² − w²) of its polynomial.
///
/// Swinging, γ < w, with Ω = √(w² − γ²):
///
///     x = e^(−γt) (x₀ cos Ωt + (v₀ + γ x₀) sin Ωt/Ω),
///     v = e^(−γt) (v₀ cos Ωt − (w² x₀ + γ v₀) sin Ωt/Ω).
///
/// Creeping, γ ≥ w, with μ = √(γ² − w²), the slow rate s = γ − μ = w²/(γ + μ), the quick one γ + μ,
/// and G = (1 − e^(−2μt))/2μ, which is t where μ is 0:
///
///     x = e^(−st) (x₀ + (v₀ + s x₀) G),   v = −s x + (v₀ + s x₀) e^(−(γ+μ)t).
///
/// γ² − w² is (γ − w)(γ + w), and nothing is divided by what vanishes at the critical damping γ =
/// w.
template <class Real>
class Oscillator {
 public:
  /// `rate` is w, in rad/s: √(k/m) for a spring of k N/m. `damping` is γ, in 1/s: half of c/m for a
  /// damper of c N s/m.
  /// @throws std::invalid_argument if one of them is negative or not finite.
  Oscillator(const OscillatorState<Real>& start, Same<Real> rate, Same<Real> damping)
      : start_(start), rate_(rate), damping_(damping) {
    require_not_negative("rate", rate, "rad/s");
    require_not_negative("damping", damping, "1/s");
    root_ = std::sqrt(std::abs(damping - rate) * (damping + rate));
  }

  /// The state `time` seconds after the start.
  OscillatorState<Real> at(Real time) const {
    const auto [x, v] = start_;
    if (damping_ < rate_) {
      const Real angle = root_ * time, decay = std::exp(-damping_ * time);
      const Real cosine = std::cos(angle), sine = std::sin(angle) / root_;
      return {decay * (x * cosine + (v + damping_ * x) * sine),
              decay * (v * cosine - (rate_ * rate_ * x + damping_ * v) * sine)};
    }
    const Real quick = damping_ + root_, slow = quick > 0 ? rate_ * rate_ / quick : Real(0);
    const Real growth = root_ > 0 ? -std::expm1(-2 * root_ * time) / (2 * root_) : time;
    const Real both = v + slow * x;
    const Real position = std::exp(-slow * time) * (x + both * growth);
    return {position, both * std::exp(-quick * time) - slow * position};
  }

 private:
  OscillatorState<Real> start_;
  Real rate_, damping_, root_;
};

}  // namespace tumble::exact
