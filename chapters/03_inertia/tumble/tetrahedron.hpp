/// @file
/// The mass properties of a tetrahedron: any four corners, and the brick that every mesh is built
/// from.
#pragma once

#include <algorithm>
#include <array>
#include <tumble/mass_properties.hpp>

namespace tumble {

/// Four corners (m, model axes), in any order.
template <class Real>
struct Tetrahedron {
  std::array<Vec3<Real>, 4> corners;
};

/// A sixth of the box that the three edges from one corner span.
template <class Real>
Real volume(const Tetrahedron<Real>& tetrahedron) {
  const auto& [a, b, c, d] = tetrahedron.corners;
  return std::abs(dot(b - a, (c - a).cross(d - a))) / 6;
}

/// The centre of mass c is the mean of the corners. About it the second moments are
/// m/20 Σ (p − c)(p − c)ᵀ over the four corners p: as if each corner were a particle of m/20, and
/// the rest of the mass at the centre (the derivation is in the chapter).
///
/// @throws std::invalid_argument if the corners lie in one plane, as far as rounding can tell:
/// their volume is below what 16 roundings make of the product of the three edges.
//! [tetrahedron]
template <class Real>
MassProperties<Real> mass_properties(const Tetrahedron<Real>& tetrahedron, Same<Real> mass) {
  require_mass("mass", mass);
  require_not_flat(tetrahedron);
  const auto& [a, b, c, d] = tetrahedron.corners;
  const Vec3<Real> to_centre = ((b - a) + (c - a) + (d - a)) / 4;
  MassProperties<Real> body{.mass = mass, .centre_of_mass = a + to_centre};
  for (const Vec3<Real>& corner : tetrahedron.corners)
    body.inertia += inertia_of_particle<Real>(mass / 20, (corner - a) - to_centre);
  return body;
}
//! [tetrahedron]

template <class Real>
void require_not_flat(const Tetrahedron<Real>& tetrahedron) {
  for (const Vec3<Real>& corner : tetrahedron.corners)
    require_finite("corner of the tetrahedron", corner, "m");
  const auto& [a, b, c, d] = tetrahedron.corners;
  const Real longest = std::max({(b - a).norm(), (c - a).norm(), (d - a).norm()});
  // Dividing by the longest edge first keeps products of three lengths within the range of Real.
  const Vec3<Real> ab = (b - a) / longest, ac = (c - a) / longest, ad = (d - a) / longest;
  const Real slack = 16 * (std::numeric_limits<Real>::epsilon() / 2);
  if (!(std::abs(dot(ab, ac.cross(ad))) > slack * ab.norm() * ac.norm() * ad.norm()))
    throw std::invalid_argument("the corners of the tetrahedron, " + text_of(a) + ", " +
                                text_of(b) + ", " + text_of(c) + " and " + text_of(d) +
                                " m, lie in one plane; they must enclose a volume");
}

}  // namespace tumble
