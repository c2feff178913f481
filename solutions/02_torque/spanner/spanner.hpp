/// @file
/// Exercise: how hard must one pull at a spanner?
#pragma once

#include <cmath>
#include <exercise/todo.hpp>
#include <stdexcept>
#include <tumble/require.hpp>

/// The force (N) that gives a bolt `torque` N m, pulled at the end of a spanner of `length` m, at
/// `angle` rad to the spanner, between 0 and pi.
/// @throws std::invalid_argument if no pull does it: along the spanner, to its other side (where
/// the sine of the angle is negative), or without a spanner.
template <class Real>
Real pull_needed(Real torque, Real length, Real angle) {
  //! [solution] refuse what cannot be, then solve the torque for the force
  if (!(length > 0))
    tumble::reject("length of the spanner", length, "m", "it must be greater than 0");
  const Real across = length * std::sin(angle);
  if (!(across > 0))
    tumble::reject("angle of the pull", angle, "rad",
                   "it must lie between 0 and pi: along the spanner nothing turns");
  return torque / across;
  //! [end]
}
