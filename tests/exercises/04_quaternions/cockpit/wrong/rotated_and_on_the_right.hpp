// caught by: Pulling the stick lifts the nose towards the pilot's head, not towards the sky
// message: it rose to the sky
#pragma once
#include <tumble/rotation_vector.hpp>

template <class Real>
tumble::Quaternion<Real> steered(const tumble::Quaternion<Real>& orientation,
                                 const tumble::Vec3<Real>& turn) {
  using namespace tumble;
  const Vec3<Real> seen = rotate_back(orientation, turn);
  return renormalized(orientation * quaternion_of_rotation_vector(seen));
}

template <class Real>
tumble::Vec3<Real> nose(const tumble::Quaternion<Real>& orientation) {
  return tumble::rotate(orientation, tumble::Vec3<Real>(1, 0, 0));
}
