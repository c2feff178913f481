// caught by: Between key frames that are nearly the same no digit is lost
// message: an arc cosine has no digits left
#pragma once

#include <tumble/orientation.hpp>

template <class Real>
tumble::Vec3<Real> angular_velocity_between(const tumble::Quaternion<Real>& from,
                                            const tumble::Quaternion<Real>& to, Real time_step) {
  using namespace tumble;
  const Quaternion<Real> turn = to * conjugate(from);
  const Real angle = 2 * std::acos(std::min(std::abs(turn.real), Real(1)));
  const Real size = turn.imaginary.norm();
  if (!(size > 0)) return Vec3<Real>::Zero();
  return std::copysign(angle / (size * time_step), turn.real) * turn.imaginary;
}

template <class Real>
tumble::Vec3<Real> angular_velocity_for_first_order(const tumble::Quaternion<Real>& from,
                                                    const tumble::Quaternion<Real>& to,
                                                    Real time_step) {
  using namespace tumble;
  const Quaternion<Real> turn = to * conjugate(from);
  if (turn.real == 0)
    reject("turn between the key frames", std::numbers::pi_v<Real>, "rad",
           "the first-order rule turns by less than half a turn");
  return 2 / (time_step * turn.real) * turn.imaginary;
}
