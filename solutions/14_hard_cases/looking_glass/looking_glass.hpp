/// @file
/// Exercise: what a mirror does to a moving body, and a test of laws made from it.
#pragma once

#include <exercise/todo.hpp>
#include <tumble/quaternion.hpp>

/// A place, velocity or force as a mirror through the origin shows it. `normal` is perpendicular to
/// the mirror and has the length 1.
template <class Real>
tumble::Vec3<Real> mirrored(const tumble::Vec3<Real>& arrow, const tumble::Vec3<Real>& normal) {
  //! [solution] turn round the part that is perpendicular to the mirror
  return arrow - 2 * normal.dot(arrow) * normal;
  //! [end]
}

/// The spin, angular momentum or torque that the mirrored body has.
template <class Real>
tumble::Vec3<Real> mirrored_spin(const tumble::Vec3<Real>& spin, const tumble::Vec3<Real>& normal) {
  //! [solution] turn round the part along the mirror
  return -mirrored(spin, normal);
  //! [end]
}

/// The orientation of the mirrored body: real part, then imaginary. Seen in the mirror, a point of
/// the body at p in body axes is the mirrored p, turned by it.
template <class Real>
Eigen::Matrix<Real, 4, 1> mirrored_turn(const Eigen::Matrix<Real, 4, 1>& turn,
                                        const tumble::Vec3<Real>& normal) {
  Eigen::Matrix<Real, 4, 1> seen;
  //! [solution] the real part, and the imaginary part, which lies along the axis of the turn
  const tumble::Vec3<Real> imaginary = turn.template tail<3>();
  seen << turn[0], mirrored_spin(imaginary, normal);
  //! [end]
  return seen;
}

/// By how much a law breaks the symmetry: the distance (N) between the mirrored force and the force
/// on the mirrored body. law(velocity, spin) is a force in N.
template <class Real, class Law>
Real broken_by(const Law& law, const tumble::Vec3<Real>& velocity, const tumble::Vec3<Real>& spin,
               const tumble::Vec3<Real>& normal) {
  //! [solution] compare the two ways through the mirror
  const tumble::Vec3<Real> force = law(velocity, spin);
  const tumble::Vec3<Real> in_the_mirror =
      law(mirrored(velocity, normal), mirrored_spin(spin, normal));
  return (mirrored(force, normal) - in_the_mirror).norm();
  //! [end]
}

/// The same of a law with three terms: a v + b ω + c v × ω.
template <class Real>
Real law_broken_by(Real a, Real b, Real c, const tumble::Vec3<Real>& velocity,
                   const tumble::Vec3<Real>& spin, const tumble::Vec3<Real>& normal) {
  using tumble::Vec3;
  const auto law = [&](const Vec3<Real>& v, const Vec3<Real>& w) -> Vec3<Real> {
    return a * v + b * w + c * v.cross(w);
  };
  return broken_by<Real>(law, velocity, spin, normal);
}
