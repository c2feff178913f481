// caught by: A pull along the spanner is refused, and so is a spanner of no length
// message: a pull at 4 rad
#pragma once

#include <cmath>
#include <stdexcept>
#include <tumble/require.hpp>

template <class Real>
Real pull_needed(Real torque, Real length, Real angle) {
  if (!(length > 0))
    tumble::reject("length of the spanner", length, "m", "it must be greater than 0");
  const Real across = length * std::sin(angle);
  if (!(angle > 0))
    tumble::reject("angle of the pull", angle, "rad",
                   "it must lie between 0 and pi: along the spanner nothing turns");
  return torque / across;
}
