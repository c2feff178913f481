// caught by: A step that is shorter by the factor found has the error that was asked for
// message: an error of 40.5 one of 0.5
#pragma once

#include <cmath>
#include <limits>
#include <tumble/require.hpp>

template <class Real>
Real observed_order(Real coarse, Real middle, Real fine) {
  const Real first = coarse - middle, second = middle - fine;
  if (!(std::abs(second) > 4 * std::numeric_limits<Real>::epsilon() * std::abs(fine)))
    tumble::reject("difference of the finer results", second, "",
                   "it must be more than rounding: take longer steps");
  if (!(first / second > 1))
    tumble::reject("ratio of the differences", first / second, "",
                   "it must be above 1: take shorter steps");
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
Real shorter_by(Real, Real, int order) {
  return std::pow(Real(256), 1 / Real(order));
}
