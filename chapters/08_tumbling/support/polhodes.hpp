/// @file
/// The curves that the tip of L runs along, seen from the body: where a sphere of constant |L| and
/// an ellipsoid of constant energy meet. Poinsot named those of ω so; L and ω go together.
#pragma once

#include <cmath>
#include <numbers>
#include <tumble/sine_cosine.hpp>
#include <utility>
#include <vector>

namespace tumble::support {

/// Points on the sphere of radius 1 where 2 E/|L|² is `level`: one closed loop around the body axis
/// `around` (0 or 2), on its positive side, beginning and ending in the same point. The inverse
/// moments are those about axes 0, 1 and 2, from the largest to the smallest.
///
/// With x the axis that the loop goes around and y, z the others, 2 E = Σ i_k L_k² and 1 = Σ L_k²
/// leave (i_y − i_x) L_y² + (i_z − i_x) L_z² = level − i_x: an ellipse, seen along x. No motion is
/// solved here.
inline std::vector<Vec3d> polhode(const Vec3d& inverse_moments, double level, int around,
                                  int points) {
  const int x = around, y = (around + 1) % 3, z = (around + 2) % 3;
  const Vec3d& i = inverse_moments;
  const double across = std::sqrt((level - i[x]) / (i[y] - i[x])),
               along = std::sqrt((level - i[x]) / (i[z] - i[x]));
  std::vector<Vec3d> loop;
  for (int n = 0; n <= points; ++n) {
    const auto [sine, cosine] = sine_cosine(2 * std::numbers::pi * n / points);
    Vec3d L;
    L[y] = across * cosine;
    L[z] = along * sine;
    L[x] = std::sqrt(std::max(0.0, 1 - L[y] * L[y] - L[z] * L[z]));
    loop.push_back(L);
  }
  return loop;
}

/// The border between the loops around axis 0 and those around axis 2, where `level` is that of the
/// middle axis: two great circles through both ends of it. `sign`, 1 or −1, says which.
inline std::vector<Vec3d> separatrix(const Vec3d& inverse_moments, double sign, int points) {
  const Vec3d& i = inverse_moments;
  const Vec3d across =
      Vec3d(std::sqrt(i[1] - i[2]), 0, sign * std::sqrt(i[0] - i[1])) / std::sqrt(i[0] - i[2]);
  std::vector<Vec3d> circle;
  for (int n = 0; n <= points; ++n) {
    const auto [sine, cosine] = sine_cosine(2 * std::numbers::pi * n / points);
    circle.emplace_back(cosine * Vec3d::UnitY() + sine * across);
  }
  return circle;
}

/// The radii (rad/s) of the two circles between which the herpolhode runs, the inner one first. The
/// moments (kg m²) are in ascending order; `twice_energy` is 2 E in J, `square` |L|² in its units.
//! [herpolhode_radii]
template <class Real>
std::pair<Real, Real> herpolhode_radii(const Vec3<Real>& I, Same<Real> twice_energy,
                                       Same<Real> square) {
  const auto radius = [&](int i, int j) {  // without spin about the axis that is left
    return std::sqrt((twice_energy * I[j] - square) * (square - twice_energy * I[i]) /
                     (I[i] * I[j] * square));
  };
  const bool around_first = square < twice_energy * I[1];
  return {around_first ? radius(0, 1) : radius(1, 2), radius(0, 2)};
}
//! [herpolhode_radii]

}  // namespace tumble::support
