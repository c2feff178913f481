/// @file
/// What a force does when it acts off-centre: torque, and forces with their torques gathered.
#pragma once

#include <tumble/force.hpp>

namespace tumble {

/// The torque (N m) about `centre` of a force that acts at `point`: τ = (p − x) × F. All in world
/// axes; positions in m, the force in N.
///
/// The lever arm p − x is formed first: one rounding of what the two positions hold, wherever the
/// origin is. The equal formula p × F − x × F loses digits far from it.
//! [torque_about]
template <class Real>
Vec3<Real> torque_about(const Vec3<Real>& centre, const Vec3<Same<Real>>& point,
                        const Vec3<Same<Real>>& force) {
  return (point - centre).cross(force);
}
//! [torque_about]

/// What a set of forces does to a rigid body: their sum and their torque about one named point.
/// Neither means much without the other, and the torque means nothing without the point.
//! [wrench]
template <class Real>
struct Wrench {
  Vec3<Real> about = Vec3<Real>::Zero();  ///< the point that the torque is taken about, m, world
  Vec3<Real> force = Vec3<Real>::Zero();  ///< the sum of the forces, N, world
  Vec3<Real> torque =
      Vec3<Real>::Zero();  ///< the sum of their torques about that point, N m, world
};
//! [wrench]

using Wrenchf = Wrench<float>;
using Wrenchd = Wrench<double>;

/// Adds `force` (N, world) that acts at `point` (m, world).
/// @throws std::invalid_argument if either is not finite; the wrench is then unchanged.
//! [add_force_at]
template <class Real>
void add_force_at(Wrench<Real>& wrench, const Vec3<Same<Real>>& force,
                  const Vec3<Same<Real>>& point) {
  require_finite("force", force, "N");
  require_finite("point", point, "m");
  wrench.force += force;
  wrench.torque += torque_about(wrench.about, point, force);
}
//! [add_force_at]

/// Adds a couple: a torque (N m, world) with no net force, the same about every point.
/// @throws std::invalid_argument if it is not finite; the wrench is then unchanged.
template <class Real>
void add_couple(Wrench<Real>& wrench, const Vec3<Same<Real>>& torque) {
  require_finite("torque", torque, "N m");
  wrench.torque += torque;
}

/// The same forces with their torque taken about `point` (m, world): τ_p = τ_x + (x − p) × F.
//! [taken_about]
template <class Real>
Wrench<Real> taken_about(const Wrench<Real>& wrench, const Vec3<Same<Real>>& point) {
  return {.about = point,
          .force = wrench.force,
          .torque = wrench.torque + torque_about<Real>(point, wrench.about, wrench.force)};
}
//! [taken_about]

}  // namespace tumble
