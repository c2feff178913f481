// caught by: Half a turn is refused by the one that cannot make it
// message: gave up where it should have answered
#pragma once

#include <tumble/orientation.hpp>

template <class Real>
tumble::Vec3<Real> angular_velocity_between(const tumble::Quaternion<Real>& from,
                                            const tumble::Quaternion<Real>& to, Real time_step) {
  return tumble::rotation_vector_of(to * tumble::conjugate(from)) / time_step;
}

template <class Real>
tumble::Vec3<Real> angular_velocity_for_first_order(const tumble::Quaternion<Real>& from,
                                                    const tumble::Quaternion<Real>& to,
                                                    Real time_step) {
  using namespace tumble;
  const Quaternion<Real> turn = to * conjugate(from);
  if (!(turn.real == 2))
    reject("turn between the key frames", std::numbers::pi_v<Real>, "rad",
           "the first-order rule turns by less than half a turn");
  return 2 / (time_step * turn.real) * turn.imaginary;
}
