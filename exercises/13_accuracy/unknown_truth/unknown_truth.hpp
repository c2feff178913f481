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
  todo("the order, from the two differences");
}

/// A better result than either, from one with steps of length h and one with h/2, by a method of
/// this order.
template <class Real>
Real better_result(Real coarse, Real fine, int order) {
  todo("the result without the leading error");
}

/// How far the finer of two such results is from the truth, 0 or more.
template <class Real>
Real error_left(Real coarse, Real fine, int order) {
  todo("the leading error of the finer result");
}

/// By how much shorter the steps must be for an error of `tolerance` in place of `error`.
template <class Real>
Real shorter_by(Real error, Real tolerance, int order) {
  todo("the factor by which the step must shrink");
}
