// caught by: It runs steadily: a part of the way is that part of the angle
// message: The quaternion holds half the angle already
#pragma once

#include <tumble/rotation_vector.hpp>

template <class Real>
tumble::Quaternion<Real> between(const tumble::Quaternion<Real>& p,
                                 const tumble::Quaternion<Real>& q, Real part) {
  using namespace tumble;
  const Vec3<Real> turn = part / 2 * rotation_vector_of(q * conjugate(p));
  return quaternion_of_rotation_vector(turn) * p;
}
