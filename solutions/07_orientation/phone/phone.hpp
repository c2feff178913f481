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
  //! [solution] a turn for each interval, about the phone's own axes
  using namespace tumble;
  for (std::size_t n = 0; n + 1 < readings.size(); ++n) {
    const Vec3<Real> middle = (readings[n] + readings[n + 1]) / 2;
    orientation = turn_exponential_body<Real>(orientation, middle, interval);
  }
  return orientation;
  //! [end]
}
