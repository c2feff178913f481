// caught by: A pull along the spanner is refused, and so is a spanner of no length
// message: every comparison with NaN is false
#pragma once
#include <cmath>
#include <tumble/require.hpp>

template <class Real>
Real pull_needed(Real torque, Real length, Real angle) {
  if (length <= 0) tumble::reject("length", length, "m", "it must be greater than 0");
  if (std::sin(angle) <= 0) tumble::reject("angle", angle, "rad", "it must lie between 0 and pi");
  return torque / (length * std::sin(angle));
}
