// caught by: Of the two ways round it takes the shorter, whatever the signs of the quaternions
// message: it went the long way round
#pragma once

#include <tumble/rotation_vector.hpp>

template <class Real>
tumble::Quaternion<Real> between(const tumble::Quaternion<Real>& p,
                                 const tumble::Quaternion<Real>& q, Real part) {
  using namespace tumble;
  const Quaternion<Real> turn = q * conjugate(p);
  const Real size = turn.imaginary.norm(), half = std::atan2(size, turn.real);
  const Vec3<Real> vector =
      size > 0 ? Vec3<Real>(2 * part * half / size * turn.imaginary) : Vec3<Real>::Zero();
  return quaternion_of_rotation_vector(vector) * p;
}
