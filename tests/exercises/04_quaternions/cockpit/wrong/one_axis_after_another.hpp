// caught by: A stick pushed every way at once is one turn, about an axis of the aeroplane's own
// message: one after another
#pragma once
#include <tumble/rotation_vector.hpp>

template <class Real>
tumble::Quaternion<Real> steered(const tumble::Quaternion<Real>& orientation,
                                 const tumble::Vec3<Real>& turn) {
  tumble::Quaternion<Real> steered = orientation;
  for (int axis = 0; axis < 3; ++axis)
    steered = steered * tumble::quaternion_of_rotation_vector<Real>(turn[axis] *
                                                                    tumble::Vec3<Real>::Unit(axis));
  return tumble::renormalized(steered);
}

template <class Real>
tumble::Vec3<Real> nose(const tumble::Quaternion<Real>& orientation) {
  return tumble::rotate(orientation, tumble::Vec3<Real>(1, 0, 0));
}
