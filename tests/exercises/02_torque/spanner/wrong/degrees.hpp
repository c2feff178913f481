// caught by: Perpendicular to a spanner of 25 cm the pull is four times the torque in N m
// message: the angle is in rad already
#pragma once
#include <cmath>
#include <tumble/require.hpp>

template <class Real>
Real pull_needed(Real torque, Real length, Real angle) {
  if (!(length > 0)) tumble::reject("length", length, "m", "it must be greater than 0");
  if (!(std::sin(angle) > 0)) tumble::reject("angle", angle, "rad", "it must lie between 0 and pi");
  return torque / (length * std::sin(angle * Real(3.14159265358979323846 / 180)));
}
