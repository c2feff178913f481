/// @file
/// Exercise: how long the next step may be, from two errors.
#pragma once

#include <algorithm>
#include <cmath>
#include <exercise/todo.hpp>
#include <tumble/require.hpp>

/// The error of a step of `step` s, as a part of what it may be: `error` is in rad, and a second
/// may add `tolerance` rad.
/// @throws std::invalid_argument unless the tolerance is finite and greater than 0.
template <class Real>
Real error_ratio(Real error, Real tolerance, Real step) {
  todo("the ratio, and the refusal");
}

/// The next step as a multiple of the last one, whose error ratio was `ratio`; it was accepted if
/// that is 1 or less. `ratio_before` is that of the last step accepted before it. Ratios fall as
/// h^power. A ratio below 1e-9 counts as 1e-9.
///
/// After a step that was accepted the factor is from 1/5 to 6, and both ratios count; after one
/// that was not it is 1/10 or more, and the last alone counts. It is 1/10 if that is NaN.
template <class Real>
Real step_factor(Real ratio, Real ratio_before, int power) {
  todo("the factor, within its limits");
}

/// By which factor each step shrinks a small deviation of the errors in the end, on a smooth
/// stretch: 0 or more. The controller multiplies the step by
/// 0.85 ratio^(-last/power) ratio_before^(before/power), with `last` and `before` 0 or more.
template <class Real>
Real deviation_left(Real last, Real before) {
  todo("the size of the larger root");
}
