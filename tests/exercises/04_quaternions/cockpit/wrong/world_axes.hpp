// caught by: A roll leaves the nose where it points, whichever way that is
// message: it went round the world's x axis
#pragma once
#include <tumble/rotation_vector.hpp>

template <class Real>
tumble::Quaternion<Real> steered(const tumble::Quaternion<Real>& orientation,
                                 const tumble::Vec3<Real>& turn) {
  return tumble::renormalized(tumble::quaternion_of_rotation_vector(turn) * orientation);
}

template <class Real>
tumble::Vec3<Real> nose(const tumble::Quaternion<Real>& orientation) {
  return tumble::rotate(orientation, tumble::Vec3<Real>(1, 0, 0));
}
