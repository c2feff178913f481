// caught by: The way begins at the one and ends at the other
// message: p* q is the turn in body axes
#pragma once

#include <tumble/rotation_vector.hpp>

template <class Real>
tumble::Quaternion<Real> between(const tumble::Quaternion<Real>& p,
                                 const tumble::Quaternion<Real>& q, Real part) {
  using namespace tumble;
  const Vec3<Real> turn = part * rotation_vector_of(conjugate(p) * q);
  return quaternion_of_rotation_vector(turn) * p;
}
