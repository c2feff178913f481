/// @file
/// What else is found in engines under the name of damping: the part of a speed that one step
/// leaves. Only for comparison.
#pragma once

#include <cmath>

namespace tumble::support {

/// 1 − k h, the first two terms of e^(−k h).
template <class Real>
Real linear_form(Real rate, Real time_step) {
  return 1 - rate * time_step;
}

/// 1/(1 + k h): what the speed at the *end* of the step would lose.
template <class Real>
Real fractional_form(Real rate, Real time_step) {
  return 1 / (1 + rate * time_step);
}

/// d^h, with d the part that is left after a second: e^(−k h) with k = −ln d.
template <class Real>
Real power_form(Real left_after_a_second, Real time_step) {
  return std::pow(left_after_a_second, time_step);
}

}  // namespace tumble::support
