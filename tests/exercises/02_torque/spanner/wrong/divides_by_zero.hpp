// caught by: A pull along the spanner is refused, and so is a spanner of no length
// message: at 0 rad, got an answer
#pragma once
#include <cmath>
#include <tumble/require.hpp>

template <class Real>
Real pull_needed(Real torque, Real length, Real angle) {
  return torque / (length * std::sin(angle));
}
