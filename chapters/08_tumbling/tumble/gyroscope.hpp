/// @file
/// A symmetric top that stands on its tip: what turns it, and what holds it up.
#pragma once

#include <tumble/mass_properties.hpp>
#include <tumble/torque.hpp>
#include <tumble/tumbling.hpp>
#include <utility>

namespace tumble {

/// A top that is symmetric about its third axis and whose tip, on that axis, is held at the origin.
/// Up is the world's z axis.
//! [gyroscope]
template <class Real>
struct Gyroscope {
  Real across;    ///< I₁, the moment about a line through the *tip*, across the axis, kg m²
  Real along;     ///< I₃, the moment about the axis, kg m²
  Real distance;  ///< l, from the tip to the centre of mass, m
  Real weight;    ///< M g, N
};
//! [gyroscope]

/// M g l, N m: the torque of the weight where the axis is level.
template <class Real>
Real pull_of(const Gyroscope<Real>& gyroscope) {
  return gyroscope.weight * gyroscope.distance;
}

/// A body on its tip, `distance` metres below its centre of mass along the body's z axis, about
/// which it must be symmetric. Its moments are taken about the tip by the parallel axis theorem.
/// @throws std::invalid_argument if the distance is not positive, the gravity (m/s²) is negative,
/// the moments about the x and y axes differ or have products, or there is none about the axis.
//! [on_its_tip]
template <class Real>
Gyroscope<Real> on_its_tip(const MassProperties<Real>& body, Real distance, Same<Real> gravity) {
  if (!(distance > 0)) reject("distance of the tip", distance, "m", "it must be greater than 0");
  require_finite("distance of the tip", distance, "m");
  require_not_negative("gravity", gravity, "m/s^2");
  const Vec3<Real> tip = body.centre_of_mass - Vec3<Real>(0, 0, distance);
  const Mat3<Real> I = inertia_about(body, tip);
  const bool straight = I(0, 1) == 0 && I(1, 2) == 0 && I(0, 2) == 0;
  if (I(0, 0) != I(1, 1) || !straight)
    reject("inertia about the tip", Vec3<Real>(I.diagonal()), "kg m^2",
           "the body must be symmetric about its z axis");
  if (!(I(2, 2) > 0))
    reject("moment about the axis", I(2, 2), "kg m^2", "it must be greater than 0");
  return {I(0, 0), I(2, 2), distance, body.mass * gravity};
}
//! [on_its_tip]

/// The top with its axis `tilt` rad from upright, spinning about it at `spin` rad/s (ω₃, in all: a
/// precession turns about the axis too), while the axis goes round the vertical at `precession`
/// rad/s. With 0 a hand lets it go.
template <class Real>
Top<Real> set_spinning(const Gyroscope<Real>& gyroscope, Same<Real> tilt, Same<Real> spin,
                       Same<Real> precession = 0) {
  Top<Real> top{.orientation = quaternion_about<Real>(Vec3<Real>::UnitX(), tilt),
                .inverse_moments =
                    Vec3<Real>(gyroscope.across, gyroscope.across, gyroscope.along).cwiseInverse()};
  set_angular_velocity_body(top, Vec3<Real>(0, precession * sine_cosine(tilt).sine, spin));
  return top;
}

/// The unit vector along the top's axis, from the tip to the centre of mass, world axes.
template <class Real>
Vec3<Real> axis_of(const Top<Real>& top) {
  return rotate<Real>(top.orientation, Vec3<Real>::UnitZ());
}

/// Adds the torque of the weight about the tip: τ = r × M g, with r from the tip to the centre.
//! [add_weight]
template <class Real>
void add_weight(Top<Real>& top, const Gyroscope<Real>& gyroscope) {
  const Vec3<Real> tip = Vec3<Real>::Zero(), centre = gyroscope.distance * axis_of(top);
  add_torque(top, torque_about(tip, centre, Vec3<Real>(0, 0, -gyroscope.weight)));
}
//! [add_weight]

/// The two rates (rad/s) at which the axis goes round steadily, at a tilt of which this is the
/// cosine, while the top spins at `spin` rad/s about its axis: the roots of
/// I₁ cos θ Ω² − I₃ ω₃ Ω + M g l = 0, first the one nearer to 0. Where the axis is level there is
/// one, and the other is infinite.
/// @throws std::invalid_argument if the spin is too slow for any.
//! [steady_precessions]
template <class Real>
std::pair<Real, Real> steady_precessions(const Gyroscope<Real>& gyroscope, Same<Real> cosine,
                                         Same<Real> spin) {
  const Real a = gyroscope.across * cosine, b = gyroscope.along * spin;
  const Real c = pull_of(gyroscope);
  const Real square = b * b - 4 * a * c;
  const Real sum = (b + std::copysign(std::sqrt(square), b)) / 2;  // nothing cancels
  if (!(square >= 0) || (sum == 0 && c > 0))
    reject("spin", spin, "rad/s", "it is too slow for the axis to go round steadily");
  if (sum == 0) return {0, 0};  // neither weight nor spin
  return {c / sum, sum / a};
}
//! [steady_precessions]

/// The spin (rad/s) above which the upright top stands by itself: there the two rates are real.
/// ω₃ = 2 √(M g l I₁)/I₃.
//! [least_sleeping_spin]
template <class Real>
Real least_sleeping_spin(const Gyroscope<Real>& gyroscope) {
  return 2 * std::sqrt(pull_of(gyroscope) * gyroscope.across) / gyroscope.along;
}
//! [least_sleeping_spin]

/// The cosine of the largest tilt of a top let go where the tilt's cosine is `cosine`:
/// a − √(a² − 2 a cos θ + 1) with a = I₃² ω₃²/(4 M g l I₁).
template <class Real>
Real lowest_cosine(const Gyroscope<Real>& gyroscope, Same<Real> cosine, Same<Real> spin) {
  if (pull_of(gyroscope) == 0) return cosine;  // nothing pulls
  const Real ratio = spin / least_sleeping_spin(gyroscope), a = ratio * ratio;
  // The same without a difference of large numbers: √ is (a − cos θ)² + sin² θ.
  const Real root = std::hypot(a - cosine, std::sqrt((1 - cosine) * (1 + cosine)));
  return (2 * a * cosine - 1) / (a + root);
}

}  // namespace tumble
