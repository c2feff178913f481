// caught by: A pull along the spanner is refused, and so is a spanner of no length
// message: a spanner of -0.25 m, pulled at -1.57
#pragma once
#include <cmath>
#include <tumble/require.hpp>

template <class Real>
Real pull_needed(Real torque, Real length, Real angle) {
  if (!(std::abs(length) > 0)) tumble::reject("length", length, "m", "it must not be 0");
  const Real across = length * std::sin(angle);
  if (!(across > 0)) tumble::reject("angle", angle, "rad", "it must lie between 0 and pi");
  return torque / across;
}
