/// @file
/// The mass properties of a ball, two kinds of shell, and a capsule, which is a ball cut in two and
/// pulled apart.
#pragma once

#include <tumble/solids.hpp>

namespace tumble {

/// A solid ball about the origin.
template <class Real>
struct Sphere {
  Real radius;  ///< m
};

/// m³.
template <class Real>
Real volume(const Sphere<Real>& sphere) {
  return 4 * std::numbers::pi_v<Real> / 3 * sphere.radius * sphere.radius * sphere.radius;
}

/// S_x = S_y = S_z = m r²/5: a third of the mean of r², ∫r² r² dr / ∫r² dr = 3 r²/5.
template <class Real>
MassProperties<Real> mass_properties(const Sphere<Real>& sphere, Same<Real> mass) {
  const Real r = sphere.radius;
  require_length("radius of the sphere", r);
  return mirrored_solid(mass, Vec3<Real>::Constant(r * r / 5));
}

/// A hollow sphere about the origin, its wall so thin that only its radius counts: a table tennis
/// ball, nearly.
template <class Real>
struct HollowSphere {
  Real radius;  ///< m
};

/// S_x = S_y = S_z = m r²/3: all the mass is at distance r, and no direction is preferred.
template <class Real>
MassProperties<Real> mass_properties(const HollowSphere<Real>& sphere, Same<Real> mass) {
  const Real r = sphere.radius;
  require_length("radius of the hollow sphere", r);
  return mirrored_solid(mass, Vec3<Real>::Constant(r * r / 3));
}

/// A hollow sphere about the origin whose wall has a thickness.
template <class Real>
struct SphericalShell {
  Real inner_radius;  ///< m; 0 makes it a solid ball
  Real outer_radius;  ///< m
};

/// m³.
template <class Real>
Real volume(const SphericalShell<Real>& shell) {
  const auto [a, b] = shell;
  return 4 * std::numbers::pi_v<Real> / 3 * (b - a) * (a * a + a * b + b * b);
}

/// S_x = S_y = S_z = m/5 (b⁵ − a⁵)/(b³ − a³). Both differences hold the factor b − a; divided out,
/// with q = a/b, nothing cancels in a thin wall: m b²/5 (1 + q + q² + q³ + q⁴)/(1 + q + q²).
template <class Real>
MassProperties<Real> mass_properties(const SphericalShell<Real>& shell, Same<Real> mass) {
  const auto [a, b] = shell;
  require_length("outer radius of the shell", b);
  require_finite("inner radius of the shell", a, "m");
  if (a < 0) reject("inner radius of the shell", a, "m", "it must be 0 or more");
  if (a >= b)
    reject("inner radius of the shell", a, "m",
           "it must be less than the outer radius, " + text_of(b) + " m");
  const Real q = a / b;
  const Real ratio = (1 + q * (1 + q * (1 + q * (1 + q)))) / (1 + q * (1 + q));
  return mirrored_solid(mass, Vec3<Real>::Constant(b * b / 5 * ratio));
}

/// A capsule about the origin: a cylinder along z with half a ball on either end.
template <class Real>
struct Capsule {
  Real radius;  ///< of the cylinder and of both half balls, m
  Real length;  ///< of the cylinder alone, m; 0 makes it a ball
};

/// m³.
template <class Real>
Real volume(const Capsule<Real>& capsule) {
  const auto [r, l] = capsule;
  return std::numbers::pi_v<Real> * r * r * (l + 4 * r / 3);
}

/// The cylinder holds 3l/(3l + 4r) of the mass, the half balls the rest. A half ball's centre is at
/// 3r/8 above its flat side, so its mean of z² is r²/5 + 2 (3r/8)(l/2) + (l/2)².
template <class Real>
MassProperties<Real> mass_properties(const Capsule<Real>& capsule, Same<Real> mass) {
  const auto [r, l] = capsule;
  require_length("radius of the capsule", r);
  require_finite("length of the capsule", l, "m");
  if (l < 0) reject("length of the capsule", l, "m", "it must be 0 or more");
  const Real cylinder = 3 * l / (3 * l + 4 * r), balls = 4 * r / (3 * l + 4 * r);
  const Real across = cylinder * (r * r / 4) + balls * (r * r / 5);
  const Real along = cylinder * (l * l / 12) + balls * (r * r / 5 + 3 * r * l / 8 + l * l / 4);
  return mirrored_solid(mass, Vec3<Real>(across, across, along));
}

}  // namespace tumble
