// caught by: A tiny turn is cut as exactly as a large one
// message: an arc cosine
#pragma once

#include <tumble/rotation_vector.hpp>

template <class Real>
tumble::Quaternion<Real> between(const tumble::Quaternion<Real>& p,
                                 const tumble::Quaternion<Real>& q, Real part) {
  using namespace tumble;
  const Quaternion<Real> way = q * conjugate(p);
  const Real angle = 2 * std::acos(std::min(std::abs(way.real), Real(1)));
  const Real size = way.imaginary.norm();
  Vec3<Real> turn = Vec3<Real>::Zero();
  if (size > 0) turn = std::copysign(part * angle / size, way.real) * way.imaginary;
  return quaternion_of_rotation_vector(turn) * p;
}
