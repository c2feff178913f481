// caught by: At a slant it takes a stronger pull, by one over the sine of the angle
// message: that is one over the cosine
#pragma once
#include <cmath>
#include <tumble/require.hpp>

template <class Real>
Real pull_needed(Real torque, Real length, Real angle) {
  if (!(length > 0)) tumble::reject("length", length, "m", "it must be greater than 0");
  if (!(std::sin(angle) > 0)) tumble::reject("angle", angle, "rad", "it must lie between 0 and pi");
  return torque / (length * std::abs(std::cos(angle)));
}
