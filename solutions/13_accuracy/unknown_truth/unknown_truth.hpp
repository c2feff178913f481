/// @file
/// Exercise: how wrong is a result, when nobody knows the truth?
#pragma once

#include <cmath>
#include <exercise/todo.hpp>
#include <limits>
#include <tumble/require.hpp>

/// The order of a method, from three of its results for the same number: with steps of length h, of
/// h/2 and of h/4.
/// @throws std::invalid_argument if the last two differ by no more than 8 roundings, 4 epsilon
/// times the last: the steps are too short. Or if the second difference is not smaller than the
/// first and of the same sign: the steps are too long.
template <class Real>
Real observed_order(Real coarse, Real middle, Real fine) {
  //! [solution] the order, from the two differences
  const Real first = coarse - middle, second = middle - fine;
  if (!(std::abs(second) > 4 * std::numeric_limits<Real>::epsilon() * std::abs(fine)))
    tumble::reject("difference of the finer results", second, "",
                   "it must be more than rounding: take longer steps");
  if (!(first / second > 1))
    tumble::reject("ratio of the differences", first / second, "",
                   "it must be above 1: take shorter steps");
  return std::log2(first / second);
  //! [end]
}

/// A better result than either, from one with steps of length h and one with h/2, by a method of
/// this order.
template <class Real>
Real better_result(Real coarse, Real fine, int order) {
  //! [solution] the result without the leading error
  return fine + (fine - coarse) / (std::exp2(Real(order)) - 1);
  //! [end]
}

/// How far the finer of two such results is from the truth, 0 or more.
template <class Real>
Real error_left(Real coarse, Real fine, int order) {
  //! [solution] the leading error of the finer result
  return std::abs(better_result<Real>(coarse, fine, order) - fine);
  //! [end]
}

/// By how much shorter the steps must be for an error of `tolerance` in place of `error`.
template <class Real>
Real shorter_by(Real error, Real tolerance, int order) {
  //! [solution] the factor by which the step must shrink
  return std::pow(error / tolerance, 1 / Real(order));
  //! [end]
}
