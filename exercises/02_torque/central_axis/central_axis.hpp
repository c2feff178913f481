/// @file
/// Exercise: the line about which a set of forces does nothing but push and twist.
#pragma once

#include <exercise/todo.hpp>
#include <tumble/torque.hpp>

/// The point (m, world) of the central axis that is nearest to the point which the wrench is taken
/// about. About every point of that axis the torque is parallel to the force, or zero.
/// @throws std::invalid_argument if the force is zero: a couple has no such axis.
template <class Real>
tumble::Vec3<Real> point_on_central_axis(const tumble::Wrench<Real>& wrench) {
  todo("the nearest point about which the torque is parallel to the force");
}
