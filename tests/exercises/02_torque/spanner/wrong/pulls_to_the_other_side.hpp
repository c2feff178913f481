// caught by: A pull along the spanner is refused, and so is a spanner of no length
// message: to the other side of the spanner
#pragma once
#include <cmath>
#include <tumble/require.hpp>

template <class Real>
Real pull_needed(Real torque, Real length, Real angle) {
  if (!(length > 0)) tumble::reject("length", length, "m", "it must be greater than 0");
  const Real across = length * std::abs(std::sin(angle));
  if (!(across > 0)) tumble::reject("angle", angle, "rad", "along the spanner nothing turns");
  return torque / across;
}
