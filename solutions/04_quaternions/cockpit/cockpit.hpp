/// @file
/// Exercise: an aeroplane that turns as its pilot means it.
#pragma once

#include <exercise/todo.hpp>
#include <tumble/rotation_vector.hpp>

/// The orientation, from the aeroplane's axes to the world's, after a turn by `turn`: a rotation
/// vector in rad, in the aeroplane's own axes.
template <class Real>
tumble::Quaternion<Real> steered(const tumble::Quaternion<Real>& orientation,
                                 const tumble::Vec3<Real>& turn) {
  const tumble::Quaternion<Real> stick = tumble::quaternion_of_rotation_vector(turn);
  //! [solution]
  return tumble::renormalized(orientation * stick);
  //! [starter]
  // return tumble::renormalized(stick * orientation);
  //! [end]
}

/// Where the nose points, world axes.
template <class Real>
tumble::Vec3<Real> nose(const tumble::Quaternion<Real>& orientation) {
  return tumble::rotate(orientation, tumble::Vec3<Real>(1, 0, 0));
}
