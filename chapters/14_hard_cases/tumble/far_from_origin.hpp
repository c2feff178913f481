/// @file
/// What a kind of number can still tell apart, far from the origin.
#pragma once

#include <cmath>
#include <limits>
#include <tumble/require.hpp>

namespace tumble {

/// The distance (m) from a coordinate (m) to the next one that can be stored, away from the origin.
/// Every place out there is a multiple of it.
template <class Real>
Real spacing_at(Real coordinate) {
  const Real far = std::abs(coordinate);
  return std::nextafter(far, std::numeric_limits<Real>::infinity()) - far;
}

/// The speed (m/s) above which a body moves there, away from the origin, in steps of `time_step`
/// (s, not 0): x + h v is rounded back to x while h v is less than half the spacing. At half of it
/// the even one of the two places wins, so a body takes one step at most. Towards the origin it is
/// the same, but where x is a power of two: on the inner side places lie twice as close.
//! [slowest_drift]
template <class Real>
Real slowest_drift_at(Real coordinate, Same<Real> time_step) {
  return spacing_at(coordinate) / 2 / std::abs(time_step);
}
//! [slowest_drift]

/// How many binary digits a number needs, so that places up to `distance` from the origin, and the
/// next one beyond it, are no further apart than `resolution` (both in m). A float has 24 and a
/// double 53.
/// @throws std::invalid_argument unless both are finite and greater than 0.
//! [digits_needed]
inline int digits_needed(double distance, double resolution) {
  require_finite("distance from the origin", distance, "m");
  require_finite("resolution", resolution, "m");
  if (!(distance > 0)) reject("distance from the origin", distance, "m", "it must be above 0");
  if (!(resolution > 0)) reject("resolution", resolution, "m", "it must be above 0");
  return std::ilogb(distance) + 1 - std::ilogb(resolution);
}
//! [digits_needed]

}  // namespace tumble
