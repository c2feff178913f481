// caught by: Half the interval, a quarter of the error
// message: Are the turns made in body axes, one after the other?
#pragma once

#include <tumble/orientation.hpp>
#include <vector>

template <class Real>
tumble::Quaternion<Real> faced(tumble::Quaternion<Real> orientation,
                               const std::vector<tumble::Vec3<Real>>& readings, Real interval) {
  using namespace tumble;
  Vec3<Real> sum = Vec3<Real>::Zero();
  for (std::size_t n = 0; n + 1 < readings.size(); ++n) sum += (readings[n] + readings[n + 1]) / 2;
  return turn_exponential_body<Real>(orientation, sum, interval);
}
