// caught by: Where only roundings differ, or the differences don't shrink, there is no order to
// tell message: The last two differ by 4 epsilon
#pragma once
#include <cmath>
#include <limits>
#include <tumble/require.hpp>

template <class Real>
Real observed_order(Real coarse, Real middle, Real fine) {
  const Real first = coarse - middle, second = middle - fine;
  if (!(std::abs(second) >= 4 * std::numeric_limits<Real>::epsilon() * std::abs(fine)))
    tumble::reject("difference of the finer results", second, "", "it must be more than rounding");
  if (!(first / second > 1))
    tumble::reject("ratio of the differences", first / second, "", "it must be above 1");
  return std::log2(first / second);
}

template <class Real>
Real better_result(Real coarse, Real fine, int order) {
  return fine + (fine - coarse) / (std::exp2(Real(order)) - 1);
}
template <class Real>
Real error_left(Real coarse, Real fine, int order) {
  return std::abs(better_result<Real>(coarse, fine, order) - fine);
}
template <class Real>
Real shorter_by(Real error, Real tolerance, int order) {
  return std::pow(error / tolerance, 1 / Real(order));
}
