// caught by: It runs steadily: a part of the way is that part of the angle
// message: that is where the straight line from p to q gets
#pragma once

#include <tumble/rotation_vector.hpp>

template <class Real>
tumble::Quaternion<Real> between(const tumble::Quaternion<Real>& p,
                                 const tumble::Quaternion<Real>& q, Real part) {
  const Real product = p.real * q.real + p.imaginary.dot(q.imaginary);
  return tumble::normalized((1 - part) * p + (product < 0 ? -part : part) * q);
}
