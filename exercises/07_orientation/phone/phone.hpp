/// @file
/// Exercise: an orientation from a gyroscope's readings.
#pragma once

#include <exercise/todo.hpp>
#include <tumble/orientation.hpp>
#include <vector>

/// The orientation at the last reading, from that at the first. The readings are angular
/// velocities (rad/s) in the phone's own axes, `interval` seconds apart.
template <class Real>
tumble::Quaternion<Real> faced(tumble::Quaternion<Real> orientation,
                               const std::vector<tumble::Vec3<Real>>& readings, Real interval) {
  todo("a turn for each interval, about the phone's own axes");
}
