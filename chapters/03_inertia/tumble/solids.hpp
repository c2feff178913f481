/// @file
/// The mass properties of common solids of uniform density.
///
/// A solid that looks the same in two mirrors, one in x and one in y, has no products of inertia in
/// these axes, so three second moments of mass about its centre say it all: S_x = ∫x² dm, and
/// likewise S_y and S_z. The tensor is then diag(S_y + S_z, S_x + S_z, S_x + S_y). The solids below
/// differ in those three numbers only, and the cone, which has no third mirror, in its centre too.
///
/// Each mass_properties() returns them for so many kg, and throws std::invalid_argument unless the
/// mass and every length are finite and greater than 0.
#pragma once

#include <numbers>
#include <tumble/mass_properties.hpp>

namespace tumble {

/// Throws unless a length (m) is finite and greater than 0.
template <class Real>
void require_length(std::string_view name, Real length) {
  if (!(length > 0)) reject(name, length, "m", "it must be greater than 0");
  require_finite(name, length, "m");
}

/// Mass properties about the origin from S, the second moments of mass for each kg, in m².
//! [mirrored_solid]
template <class Real>
MassProperties<Real> mirrored_solid(Real mass, const Vec3<Same<Real>>& S) {
  require_mass("mass", mass);
  MassProperties<Real> body{.mass = mass};
  body.inertia.diagonal() = mass * Vec3<Real>(S.y() + S.z(), S.x() + S.z(), S.x() + S.y());
  return body;
}
//! [mirrored_solid]

/// A box about the origin, its edges along the axes.
template <class Real>
struct Box {
  Vec3<Real> size;  ///< whole edges, not halves, m
};

/// m³.
template <class Real>
Real volume(const Box<Real>& box) {
  return box.size.prod();
}

/// S_x = m a²/12, from the mean of x² over the edge, −a/2 … a/2.
//! [box]
template <class Real>
MassProperties<Real> mass_properties(const Box<Real>& box, Same<Real> mass) {
  require_length("x size of the box", box.size.x());
  require_length("y size of the box", box.size.y());
  require_length("z size of the box", box.size.z());
  return mirrored_solid(mass, box.size.cwiseAbs2() / 12);
}
//! [box]

/// An ellipsoid about the origin, its axes along the axes.
template <class Real>
struct Ellipsoid {
  Vec3<Real> semi_axes;  ///< from the centre to the surface, m
};

/// m³.
template <class Real>
Real volume(const Ellipsoid<Real>& ellipsoid) {
  return ellipsoid.semi_axes.prod() * (4 * std::numbers::pi_v<Real> / 3);
}

/// S_x = m a²/5: a unit ball, whose mean of x² is 1/5, stretched by a.
template <class Real>
MassProperties<Real> mass_properties(const Ellipsoid<Real>& ellipsoid, Same<Real> mass) {
  require_length("x semi-axis of the ellipsoid", ellipsoid.semi_axes.x());
  require_length("y semi-axis of the ellipsoid", ellipsoid.semi_axes.y());
  require_length("z semi-axis of the ellipsoid", ellipsoid.semi_axes.z());
  return mirrored_solid(mass, ellipsoid.semi_axes.cwiseAbs2() / 5);
}

/// A cylinder about the origin, its axis along z.
template <class Real>
struct Cylinder {
  Real radius;  ///< m
  Real height;  ///< m
};

/// m³.
template <class Real>
Real volume(const Cylinder<Real>& cylinder) {
  return std::numbers::pi_v<Real> * cylinder.radius * cylinder.radius * cylinder.height;
}

/// S_x = S_y = m r²/4, half of the mean of the squared distance r²/2 from the axis; S_z as in a
/// box.
template <class Real>
MassProperties<Real> mass_properties(const Cylinder<Real>& cylinder, Same<Real> mass) {
  const auto [r, h] = cylinder;
  require_length("radius of the cylinder", r);
  require_length("height of the cylinder", h);
  return mirrored_solid(mass, Vec3<Real>(r * r / 4, r * r / 4, h * h / 12));
}

/// A cone that stands with its base on the plane z = 0, centred on the origin, its tip up.
template <class Real>
struct Cone {
  Real radius;  ///< of the base, m
  Real height;  ///< m
};

/// m³.
template <class Real>
Real volume(const Cone<Real>& cone) {
  return std::numbers::pi_v<Real> * cone.radius * cone.radius * cone.height / 3;
}

/// The centre of mass lies a quarter of the height above the base. About it, S_x = S_y = 3 m r²/20
/// and S_z = 3 m h²/80.
template <class Real>
MassProperties<Real> mass_properties(const Cone<Real>& cone, Same<Real> mass) {
  const auto [r, h] = cone;
  require_length("radius of the cone", r);
  require_length("height of the cone", h);
  MassProperties<Real> body =
      mirrored_solid(mass, Vec3<Real>(3 * r * r / 20, 3 * r * r / 20, 3 * h * h / 80));
  body.centre_of_mass.z() = h / 4;
  return body;
}

/// A rod along z about the origin, so thin that only its length counts. It has no inertia about its
/// own axis: a moment of zero, which cannot be inverted.
template <class Real>
struct ThinRod {
  Real length;  ///< m
};

/// S_z = m l²/12; the others are 0.
template <class Real>
MassProperties<Real> mass_properties(const ThinRod<Real>& rod, Same<Real> mass) {
  const Real l = rod.length;
  require_length("length of the rod", l);
  return mirrored_solid(mass, Vec3<Real>(0, 0, l * l / 12));
}

/// A rectangular plate about the origin in the plane z = 0, so thin that its thickness doesn't
/// count.
template <class Real>
struct ThinPlate {
  Real width;   ///< along x, m
  Real height;  ///< along y, m
};

/// S_x and S_y as in a box, S_z = 0. So I_z = I_x + I_y: as lopsided as matter can be.
template <class Real>
MassProperties<Real> mass_properties(const ThinPlate<Real>& plate, Same<Real> mass) {
  const auto [a, b] = plate;
  require_length("width of the plate", a);
  require_length("height of the plate", b);
  return mirrored_solid(mass, Vec3<Real>(a * a / 12, b * b / 12, 0));
}

/// The same solid made of a material of `density` kg/m³.
//! [mass_properties_of_density]
template <template <class> class Solid, class Real>
MassProperties<Real> mass_properties_of_density(const Solid<Real>& solid, Same<Real> density) {
  if (!(density > 0)) reject("density", density, "kg/m^3", "it must be greater than 0");
  require_finite("density", density, "kg/m^3");
  return mass_properties(solid, density * volume(solid));
}
//! [mass_properties_of_density]

}  // namespace tumble
