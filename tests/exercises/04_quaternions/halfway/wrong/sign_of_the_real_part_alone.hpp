// caught by: Of the two ways round it takes the shorter, whatever the signs of the quaternions
// message: but away from the second
#pragma once

#include <tumble/rotation_vector.hpp>

template <class Real>
tumble::Quaternion<Real> between(const tumble::Quaternion<Real>& p,
                                 const tumble::Quaternion<Real>& q, Real part) {
  using namespace tumble;
  Quaternion<Real> way = q * conjugate(p);
  way.real = std::abs(way.real);
  const Vec3<Real> turn = part * rotation_vector_of(way);
  return quaternion_of_rotation_vector(turn) * p;
}
