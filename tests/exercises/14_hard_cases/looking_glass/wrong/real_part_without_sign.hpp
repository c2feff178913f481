// caught by: A mirrored body shows the mirrored points
// message: the angle is another one
#pragma once

#include <cmath>
#include <tumble/quaternion.hpp>

template <class Real>
tumble::Vec3<Real> mirrored(const tumble::Vec3<Real>& arrow, const tumble::Vec3<Real>& normal) {
  return arrow - 2 * normal.dot(arrow) * normal;
}

template <class Real>
tumble::Vec3<Real> mirrored_spin(const tumble::Vec3<Real>& spin, const tumble::Vec3<Real>& normal) {
  return -mirrored(spin, normal);
}

template <class Real>
Eigen::Matrix<Real, 4, 1> mirrored_turn(const Eigen::Matrix<Real, 4, 1>& turn,
                                        const tumble::Vec3<Real>& normal) {
  Eigen::Matrix<Real, 4, 1> seen;
  const tumble::Vec3<Real> imaginary = turn.template tail<3>();
  seen << std::abs(turn[0]), mirrored_spin(imaginary, normal);
  return seen;
}

template <class Real, class Law>
Real broken_by(const Law& law, const tumble::Vec3<Real>& velocity, const tumble::Vec3<Real>& spin,
               const tumble::Vec3<Real>& normal) {
  const tumble::Vec3<Real> force = law(velocity, spin);
  const tumble::Vec3<Real> in_the_mirror =
      law(mirrored(velocity, normal), mirrored_spin(spin, normal));
  return (mirrored(force, normal) - in_the_mirror).norm();
}

template <class Real>
Real law_broken_by(Real a, Real b, Real c, const tumble::Vec3<Real>& velocity,
                   const tumble::Vec3<Real>& spin, const tumble::Vec3<Real>& normal) {
  using tumble::Vec3;
  const auto law = [&](const Vec3<Real>& v, const Vec3<Real>& w) -> Vec3<Real> {
    return a * v + b * w + c * v.cross(w);
  };
  return broken_by<Real>(law, velocity, spin, normal);
}
