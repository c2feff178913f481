/// @file
/// The exact motion of a particle around a fixed centre that attracts it by the square of the
/// distance.
#pragma once

#include <limits>
#include <string>
#include <tumble/exact/pi.hpp>
#include <tumble/particle.hpp>

namespace tumble::exact {

/// r'' = −μ r/|r|³ on an ellipse. With the semi-axis a, 1/a = 2/r₀ − v₀²/μ, the mean motion
/// n = √(μ/a³), and E the change of the eccentric anomaly since the start, Kepler's equation is
///
///     n t = E − k sin E + s (1 − cos E),   k = 1 − r₀/a,   s = (r₀ · v₀)/√(μ a),
///
/// where k and s are e cos E₀ and e sin E₀; so it needs no perihelion and holds for circles too.
/// The state is a combination of the first one (Battin, An Introduction to the Mathematics and
/// Methods of Astrodynamics, on Lagrange's coefficients):
///
///     r = f r₀ + g v₀,  f = 1 − (a/r₀)(1 − cos E),  g = (r₀ sin E + √(a/μ) (r₀ · v₀)(1 − cos
///     E))/(n a), v = f' r₀ + g' v₀,  f' = −√(μ a) sin E/(r r₀),  g' = 1 − (a/r)(1 − cos E).
///
/// A rounding of n t moves the eccentric anomaly by 1/(1 − e) times as much at the perihelion,
/// where the planet is fastest. Seen from the centre it moves by √((1 + e)/(1 − e)³) times as much:
/// for e = 0.8 by 15 times where the anomaly has 5. Parabolas and hyperbolas are refused.
template <class Real>
class KeplerOrbit {
 public:
  /// `attraction` is μ, in m³/s²: the gravitational constant times the mass in the centre, which is
  /// the origin.
  /// @throws std::invalid_argument if μ is not greater than 0 and finite, if the particle is in the
  /// centre or falls straight into it, or if it is too fast to come back.
  KeplerOrbit(const Particle<Real>& start, Same<Real> attraction)
      : start_(start), attraction_(attraction) {
    require_finite("attraction", attraction, "m^3/s^2");
    if (!(attraction > 0)) reject("attraction", attraction, "m^3/s^2", "it must be greater than 0");
    const Vec3<Real>& r = start.position;
    const Vec3<Real>& v = start.velocity;
    require_finite("position", r, "m");
    require_finite("velocity", v, "m/s");
    first_distance_ = r.norm();
    if ((r.cross(v).array() == 0).all())
      reject("position", r, "m",
             "the velocity " + text_of(v) + " m/s must not point to the centre or away from it");
    const Real speed_squared = v.squaredNorm(), bound = 2 * attraction / first_distance_;
    if (!(speed_squared < bound))
      reject("velocity", v, "m/s",
             "its size must be less than the escape velocity " + text_of(std::sqrt(bound)) +
                 " m/s; open orbits have no solution here");
    semi_axis_ = attraction / (bound - speed_squared);
    mean_motion_ = std::sqrt(attraction / semi_axis_) / semi_axis_;
    e_cosine_ = 1 - first_distance_ / semi_axis_;
    e_sine_ = dot(r, v) / std::sqrt(attraction * semi_axis_);
  }

  /// Of one revolution, s.
  Real period() const { return 2 * pi<Real> / mean_motion_; }
  Real eccentricity() const { return std::hypot(e_cosine_, e_sine_); }

  /// The particle `time` seconds after the start; before it, if that is negative.
  Particle<Real> at(Real time) const {
    const Real E = anomaly(std::remainder(mean_motion_ * time, 2 * pi<Real>));
    const Real sine = std::sin(E), half = std::sin(E / 2), versine = 2 * half * half;
    const Real ratio = semi_axis_ / first_distance_;
    const Real distance = semi_axis_ * (1 - e_cosine_ * std::cos(E) + e_sine_ * sine);
    const Real g =
        (first_distance_ * sine + e_sine_ * semi_axis_ * versine) / (mean_motion_ * semi_axis_);
    const Real f_rate = -mean_motion_ * semi_axis_ * ratio * sine / distance;
    Particle<Real> particle = start_;
    particle.position = (1 - ratio * versine) * start_.position + g * start_.velocity;
    particle.velocity =
        f_rate * start_.position + (1 - semi_axis_ / distance * versine) * start_.velocity;
    return particle;
  }

 private:
  /// Solves Kepler's equation by Newton's method, kept inside an interval that holds the root: the
  /// mean anomaly never differs from E by more than 2 e.
  Real anomaly(Real mean) const {
    const Real reach = 2 * eccentricity();
    Real low = mean - reach, high = mean + reach, E = mean;
    for (int n = 0; n < 200; ++n) {
      const Real sine = std::sin(E), half = std::sin(E / 2);
      const Real off = E - e_cosine_ * sine + e_sine_ * (2 * half * half) - mean;
      if (off == 0) break;
      (off > 0 ? high : low) = E;
      const Real slope = 1 - e_cosine_ * std::cos(E) + e_sine_ * sine;
      Real next = E - off / slope;
      if (!(next > low && next < high)) next = (low + high) / 2;
      if (std::abs(next - E) <= std::numeric_limits<Real>::epsilon() * std::abs(E) / 2) break;
      E = next;
    }
    return E;
  }

  Particle<Real> start_;
  Real attraction_, first_distance_ = 0, semi_axis_ = 0, mean_motion_ = 0;
  Real e_cosine_ = 0, e_sine_ = 0;
};

}  // namespace tumble::exact
