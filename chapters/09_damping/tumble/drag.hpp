/// @file
/// What damping stands in for: the drag of air, which grows with the square of the speed.
#pragma once

#include <tumble/require.hpp>

namespace tumble {

/// ½ ρ C A in kg/m: what quadratic_drag() multiplies the square of the speed by. The air's density
/// is ρ in kg/m³, 1.2 near the ground; C is a number of the shape, 0.47 for a ball; A is the area
/// that the air meets, in m².
/// @throws std::invalid_argument if one of them is negative, NaN or infinite.
template <class Real>
Real drag_coefficient(Real density, Same<Real> shape_number, Same<Real> area) {
  require_not_negative("density of air", density, "kg/m^3");
  require_not_negative("shape number", shape_number, "");
  require_not_negative("area", area, "m^2");
  return density * shape_number * area / 2;
}

/// The drag (N, world axes) on a body that moves with `velocity` (m/s) through air that moves with
/// `wind` (m/s): F = −c |u| u with u = v − wind, and c from drag_coefficient() in kg/m.
///
/// As a force in a step of h seconds it turns u into (1 − h c |u| / m) u: it overshoots where
/// |u| > m/(h c) and grows where |u| > 2 m/(h c).
//! [quadratic_drag]
template <class Real>
Vec3<Real> quadratic_drag(Real coefficient, const Vec3<Same<Real>>& velocity,
                          const Vec3<Same<Real>>& wind) {
  const Vec3<Real> through_air = velocity - wind;
  return -coefficient * through_air.norm() * through_air;
}
//! [quadratic_drag]

}  // namespace tumble
