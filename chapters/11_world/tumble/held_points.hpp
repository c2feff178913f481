/// @file
/// How a body yields where a force holds it, and what resists its turning.
#pragma once

#include <algorithm>
#include <cmath>
#include <tumble/body_store.hpp>
#include <tumble/principal_axes.hpp>
#include <tumble/rigid_body.hpp>
#include <utility>
#include <vector>

namespace tumble {

/// The largest inverse mass (1/kg) that a force meets at a point of the body, over all directions
/// of the force. `arm` leads there from the centre of mass, m, body axes.
///
/// A force F at r gives the point the acceleration F/m + (J (r × F)) × r, where J is the inverse
/// tensor, so F meets the inverse mass 1/m + J(r × n, r × n) in its own direction n. The vectors
/// r × n fill the plane perpendicular to r. There J is a matrix of two by two, whose larger
/// eigenvalue is (A + B)/2 + √(((A − B)/2)² + C²).
//! [largest_inverse_mass_at]
template <class Real>
Real largest_inverse_mass_at(const RigidBody<Real>& body, const Vec3<Same<Real>>& arm) {
  const Real length = arm.norm();
  if (length == 0) return body.centre.inverse_mass;
  const Vec3<Real> n = arm / length;
  int least = 0;  // the axis that the arm is farthest from
  for (const int axis : {1, 2})
    if (std::abs(n[axis]) < std::abs(n[least])) least = axis;
  Vec3<Real> e = n.cross(Vec3<Real>::Unit(least));
  e /= e.norm();
  const Vec3<Real> f = n.cross(e), &J = body.top.inverse_moments;
  Real A = 0, B = 0, C = 0;
  for (int i = 0; i < 3; ++i) {
    A += J[i] * e[i] * e[i];
    B += J[i] * f[i] * f[i];
    C += J[i] * e[i] * f[i];
  }
  return body.centre.inverse_mass + length * length * ((A + B) / 2 + std::hypot((A - B) / 2, C));
}
//! [largest_inverse_mass_at]

/// How a force F (N) that keeps its direction, at an arm a (m) that turns with the body, resists a
/// small turn: N m/rad, in the axes of the two vectors.
///
/// A turn by θ moves the arm by θ × a, and the torque changes by (θ × a) × F = a (θ·F) − θ (a·F).
/// What resists is the opposite, (a·F) θ − a (F·θ). Its symmetric part is what a potential energy
/// can give; the other part belongs to the torque a × F, and the torques on a body in equilibrium
/// cancel.
//! [turning_stiffness]
template <class Real>
Mat3<Real> turning_stiffness(const Vec3<Real>& arm, const Vec3<Same<Real>>& force) {
  Mat3<Real> stiffness;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      stiffness(i, j) =
          (i == j ? dot(arm, force) : Real(0)) - (arm[i] * force[j] + force[i] * arm[j]) / 2;
  return stiffness;
}
//! [turning_stiffness]

/// The largest eigenvalue of √J K √J, where J holds the inverse moments; 0 if K resists no turn.
///
/// Of a stiffness against turns (N m/rad, body axes) that is the largest square of an angular
/// frequency with which it lets the body oscillate, (rad/s)²; of a damping (N m s/rad), the largest
/// rate at which a spin fades, 1/s.
//! [largest_turning_strength]
template <class Real>
Real largest_turning_strength(const RigidBody<Real>& body, const Mat3<Same<Real>>& K) {
  const Vec3<Real>& J = body.top.inverse_moments;
  Mat3<Real> scaled;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) scaled(i, j) = std::sqrt(J[i]) * K(i, j) * std::sqrt(J[j]);
  if (!is_finite(scaled)) return std::numeric_limits<Real>::infinity();
  return std::max(Real(0), principal_axes<Real>(scaled).moments.z());
}
//! [largest_turning_strength]

/// How fast the axis of a free body circles about its angular momentum, rad/s: the nutation, |L|/I⊥
/// of a top that is symmetric about its axis, whichever way it spins. Of moments that all differ
/// the fastest is taken that any axis has, J₃ √(L₁² + L₂²), where a spin about the first counts by
/// the larger of the other two inverse moments J.
template <class Real>
Real nutation_rate(const Top<Real>& top) {
  const Vec3<Real>&L = top.angular_momentum_body, &J = top.inverse_moments;
  return std::max({J.x() * std::hypot(L.y(), L.z()), J.y() * std::hypot(L.z(), L.x()),
                   J.z() * std::hypot(L.x(), L.y())});
}

/// How many times as easily as at rest a body yields to kicks that come once in each turn of its
/// nutation by `angle` (rad, 0 to below π), see step_limit().
//! [yielding]
template <class Real>
Real yielding(Real angle) {
  return angle == 0 ? 1 : std::tan(angle / 2) / (angle / 2);
}
//! [yielding]

/// What resists the turns of one body: all its holds together.
template <class Real>
struct HeldTurn {
  Mat3<Real> sum = Mat3<Real>::Zero();  ///< body axes
  Real strength = 0;                    ///< of that, see largest_turning_strength()
  Real most = 0;                        ///< the largest part that a hold has in it
  std::size_t hold = 0;                 ///< which has it
};

/// What resists the turns of each body, and which of the holds has the most part in it.
template <class Real>
struct HeldTurns {
  std::vector<HeldTurn<Real>> turns;  ///< by body; no more than up to the last that is held

  /// A hold gives this to a body. `part` is how large that is, and not 0.
  void add(BodyIndex body, const Mat3<Real>& strength, Real part, std::size_t of_hold) {
    if (turns.size() <= body) turns.resize(body + 1);
    HeldTurn<Real>& turn = turns[body];
    turn.sum += strength;
    if (part <= turn.most) return;  // but a NaN counts
    turn.most = part;
    turn.hold = of_hold;
  }

  /// Once all has been added.
  void find_strengths(const NamedBodies<Real>& bodies) {
    for (BodyIndex body = 0; body < turns.size(); ++body)
      if (turns[body].most != 0)
        turns[body].strength = largest_turning_strength<Real>(bodies.body(body), turns[body].sum);
  }

  /// The largest strength where each body yields so many times as easily as at rest, and the hold
  /// that has the most part in it.
  std::pair<Real, std::size_t> largest(const std::vector<Real>& yields) const {
    std::pair<Real, std::size_t> found{0, 0};
    for (BodyIndex body = 0; body < turns.size(); ++body)
      if (const Real strength = turns[body].strength * yields[body]; strength > found.first)
        found = {strength, turns[body].hold};
    return found;
  }
};

}  // namespace tumble
