/// @file
/// Exercise: the orientations between two others.
#pragma once

#include <exercise/todo.hpp>
#include <tumble/rotation_vector.hpp>

/// The orientation after the `part` (0 to 1) of the shortest way from p to q, turning steadily
/// about one axis. Both have norm 1 and lead from body axes to world axes.
template <class Real>
tumble::Quaternion<Real> between(const tumble::Quaternion<Real>& p,
                                 const tumble::Quaternion<Real>& q, Real part) {
  todo("the part of the turn that leads from p to q, after p");
}
