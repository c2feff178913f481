// caught by: Roll, pull, roll back: the nose has gone sideways
// message: it went to the left
#pragma once
#include <tumble/rotation_vector.hpp>

template <class Real>
tumble::Quaternion<Real> steered(const tumble::Quaternion<Real>& orientation,
                                 const tumble::Vec3<Real>& turn) {
  const tumble::Vec3<Real> back(-turn.x(), turn.y(), turn.z());
  return tumble::renormalized(orientation * tumble::quaternion_of_rotation_vector(back));
}

template <class Real>
tumble::Vec3<Real> nose(const tumble::Quaternion<Real>& orientation) {
  return tumble::rotate(orientation, tumble::Vec3<Real>(1, 0, 0));
}
