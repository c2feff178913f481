/// @file
/// The exact motion of a body that is thrown through air with a drag in proportion to its speed.
#pragma once

#include <limits>
#include <tumble/particle.hpp>

namespace tumble::exact {

/// (eˣ − 1)/x, which is 1 at 0. Of eˣ − 1 nothing may cancel where x is small.
template <class Real>
Real relative_growth(Real x) {
  return x == 0 ? Real(1) : std::expm1(x) / x;
}

/// (eˣ − 1 − x)/x², which is ½ at 0: by its series where the numerator would cancel.
template <class Real>
Real second_growth(Real x) {
  if (std::abs(x) > 1) return (relative_growth(x) - 1) / x;
  Real sum = 0, term = Real(0.5);
  for (int n = 3; std::abs(term) > std::numeric_limits<Real>::epsilon() / 8; ++n) {
    sum += term;
    term *= x / Real(n);
  }
  return sum;
}

/// v' = g − c v. With φ₁(x) = (eˣ − 1)/x and φ₂(x) = (eˣ − 1 − x)/x²,
///
///     v = v₀ e^(−ct) + g t φ₁(−ct),   x = x₀ + v₀ t φ₁(−ct) + g t² φ₂(−ct):
///
/// the usual x₀ + v_t t + (v₀ − v_t)(1 − e^(−ct))/c with the terminal velocity v_t = g/c multiplied
/// out, so that nothing is divided by c, and c = 0 is free fall. Each term is right to some
/// roundings.
template <class Real>
class Projectile {
 public:
  /// `gravity` in m/s², world axes, `drag` c in 1/s: the force is −c m v.
  /// @throws std::invalid_argument if the gravity is not finite, or if the drag is negative or not
  /// finite.
  Projectile(const Particle<Real>& start, const Vec3<Same<Real>>& gravity, Same<Real> drag)
      : start_(start), gravity_(gravity), drag_(drag) {
    require_finite("gravity", gravity, "m/s^2");
    require_not_negative("drag", drag, "1/s");
  }

  /// The particle `time` seconds after the start.
  Particle<Real> at(Real time) const {
    const Real x = -drag_ * time;
    const Real first = time * relative_growth(x), second = time * time * second_growth(x);
    Particle<Real> particle = start_;
    particle.velocity = std::exp(x) * start_.velocity + first * gravity_;
    particle.position = start_.position + (first * start_.velocity + second * gravity_);
    return particle;
  }

 private:
  Particle<Real> start_;
  Vec3<Real> gravity_;
  Real drag_;
};

}  // namespace tumble::exact
