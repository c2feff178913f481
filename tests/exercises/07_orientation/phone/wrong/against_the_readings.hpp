// caught by: While the rate grows evenly about one axis, the angle is exact
// message: it turns backwards
#pragma once

#include <tumble/orientation.hpp>
#include <vector>

template <class Real>
tumble::Quaternion<Real> faced(tumble::Quaternion<Real> orientation,
                               const std::vector<tumble::Vec3<Real>>& readings, Real interval) {
  using namespace tumble;
  for (std::size_t n = 0; n + 1 < readings.size(); ++n) {
    const Vec3<Real> middle = (readings[n] + readings[n + 1]) / 2;
    orientation = turn_exponential_body<Real>(orientation, -middle, interval);
  }
  return orientation;
}
