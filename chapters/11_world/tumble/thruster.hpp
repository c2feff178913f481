/// @file
/// A thruster that is fixed to a body.
#pragma once

#include <limits>
#include <tumble/effect.hpp>

namespace tumble {

/// A force that turns with the body it is fixed to: R F at the centre plus the torque R (p × F).
template <class Real>
struct Thruster {
  static constexpr Quantities reads = quantity::time | quantity::orientation;
  Vec3<Real> force_body = Vec3<Real>::Zero();  ///< F, N, body axes
  Vec3<Real> point = Vec3<Real>::Zero();       ///< p, where it acts: from the centre, m, body axes
  Real from = 0;                               ///< s, when it starts to burn
  Real until = std::numeric_limits<Real>::infinity();  ///< s, when it stops: not before it starts
  std::string name = "thruster";                       ///< what plans and errors call it

  void check() const {
    require_finite("force of a thruster", force_body, "N");
    require_finite("place of a thruster", point, "m");
    require_finite("start of a thruster", from, "s");
    if (!(until >= from))
      reject("end of a thruster", until, "s", "it must not lie before the start");
  }
  bool needs_top() const { return true; }
  bool gives_torque() const { return point.cross(force_body) != Vec3<Real>::Zero(); }
  std::string_view skip_reason(const BodyFlags&) const {
    return force_body == Vec3<Real>::Zero() ? "its force is zero" : "";
  }
  //! [thruster]
  Push<Real> push(const BodyState<Real>& body, Real time) const {
    const Real burning = select(time >= from && time < until, Real(1), Real(0));
    const Vec3<Real> torque_body = point.cross(force_body);
    return {.force = burning * rotate(body.top.orientation, force_body),
            .torque = burning * rotate(body.top.orientation, torque_body)};
  }
  //! [thruster]
  /// Its torque is constant in body axes, and so no turn and no place changes it: nothing that it
  /// does comes back to it.
  NoResponse response(const BodyState<Real>&) const { return {}; }
  template <class Wide>
  Thruster<Wide> broadcast() const {
    return {force_body.template cast<Wide>(), point.template cast<Wide>(), from, until, name};
  }
};

}  // namespace tumble
