/// @file
/// Gravity as effects: uniform, as a force and as an acceleration, and towards a point.
#pragma once

#include <tumble/effect.hpp>

namespace tumble {

/// Uniform gravity as a force, F = m g.
//! [gravity]
template <class Real>
struct Gravity {
  static constexpr std::string_view name = "gravity";
  static constexpr Quantities reads = quantity::mass;
  Vec3<Real> gravity = {0, 0, Real(-9.81)};  ///< g, m/s², world axes

  void check() const { require_finite("gravity", gravity, "m/s^2"); }
  std::string_view skip_reason(const BodyFlags&) const {
    return gravity == Vec3<Real>::Zero() ? "gravity is zero" : "";
  }
  Vec3<Real> force(const Particle<Real>& centre, Real) const { return mass_of(centre) * gravity; }
  template <class Wide>
  Gravity<Wide> broadcast() const {
    return {gravity.template cast<Wide>()};
  }
  Real potential_energy(const BodyState<Real>& body) const {
    return -mass_of(body.centre) * dot(gravity, body.centre.position);
  }
};
//! [gravity]

/// Uniform gravity as an acceleration, v ← v + h g: the same for every mass, so nobody asks for it.
template <class Real>
struct GravityAsAcceleration {
  static constexpr std::string_view name = "gravity as acceleration";
  static constexpr Quantities reads = quantity::none;
  Vec3<Real> gravity = {0, 0, Real(-9.81)};  ///< g, m/s², world axes

  void check() const { require_finite("gravity", gravity, "m/s^2"); }
  std::string_view skip_reason(const BodyFlags&) const {
    return gravity == Vec3<Real>::Zero() ? "gravity is zero" : "";
  }
  //! [acceleration]
  Vec3<Real> acceleration(const Particle<Real>&, Real) const { return gravity; }
  //! [acceleration]
  template <class Wide>
  GravityAsAcceleration<Wide> broadcast() const {
    return {gravity.template cast<Wide>()};
  }
  Real potential_energy(const BodyState<Real>& body) const {
    return -mass_of(body.centre) * dot(gravity, body.centre.position);
  }
};

/// Gravity towards a point, F = −G M m r/|r|³ with r from the point to the body. `strength` is G M:
/// 3.986e14 m³/s² for the Earth. At the point itself the force is not defined: a step that meets it
/// stops with an error.
template <class Real>
struct PointGravity {
  static constexpr std::string_view name = "point gravity";
  static constexpr Quantities reads = quantity::mass | quantity::position;
  Real strength = 0;                       ///< G M, m³/s², 0 or more
  Vec3<Real> centre = Vec3<Real>::Zero();  ///< m, world axes

  void check() const {
    require_not_negative("strength of point gravity", strength, "m^3/s^2");
    require_finite("centre of point gravity", centre, "m");
  }
  std::string_view skip_reason(const BodyFlags&) const {
    return strength == 0 ? "its strength is zero" : "";
  }
  // Divided by |r| one factor at a time: |r|³ would leave float's range from 7e12 m on.
  //! [towards_a_point]
  Vec3<Real> force(const Particle<Real>& body, Real) const {
    const Vec3<Real> r = body.position - centre;
    const Real distance = r.norm();
    return -(mass_of(body) * (strength / distance / distance)) * (r / distance);
  }
  //! [towards_a_point]
  /// A small step aside turns the force by its angle, so it meets the stiffness G M m/|r|³: with
  /// it, a circular orbit has the angular frequency of its revolutions. Along r the force drives.
  /// At the point itself a step stops anyway.
  Response<Real> response(const BodyState<Real>& body) const {
    const Real distance = (body.centre.position - centre).norm();
    if (distance == 0) return {};
    return {.stiffness = mass_of(body.centre) * (strength / distance / distance / distance)};
  }
  template <class Wide>
  PointGravity<Wide> broadcast() const {
    return {strength, centre.template cast<Wide>()};
  }
  Real potential_energy(const BodyState<Real>& body) const {
    return -mass_of(body.centre) * (strength / (body.centre.position - centre).norm());
  }
};

}  // namespace tumble
