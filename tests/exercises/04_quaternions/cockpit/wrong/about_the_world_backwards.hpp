// caught by: Pulling the stick lifts the nose towards the pilot's head, not towards the sky
// message: about an axis of the world and backwards
#pragma once

#include <tumble/rotation_vector.hpp>

template <class Real>
tumble::Quaternion<Real> steered(const tumble::Quaternion<Real>& orientation,
                                 const tumble::Vec3<Real>& turn) {
  const tumble::Quaternion<Real> stick = tumble::quaternion_of_rotation_vector(turn);
  return tumble::renormalized(tumble::conjugate(stick) * orientation);
}

template <class Real>
tumble::Vec3<Real> nose(const tumble::Quaternion<Real>& orientation) {
  return tumble::rotate(orientation, tumble::Vec3<Real>(1, 0, 0));
}
