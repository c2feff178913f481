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
  //! [solution] the ratio, and the refusal
  tumble::require_finite("tolerance", tolerance, "rad a second");
  if (!(tolerance > 0))
    tumble::reject("tolerance", tolerance, "rad a second", "it must be greater than 0");
  return error / (tolerance * step);
  //! [end]
}

/// The next step as a multiple of the last one, whose error ratio was `ratio`; it was accepted if
/// that is 1 or less. `ratio_before` is that of the last step accepted before it. Ratios fall as
/// h^power. A ratio below 1e-9 counts as 1e-9.
///
/// After a step that was accepted the factor is from 1/5 to 6, and both ratios count; after one
/// that was not it is 1/10 or more, and the last alone counts. It is 1/10 if that is NaN.
template <class Real>
Real step_factor(Real ratio, Real ratio_before, int power) {
  //! [solution] the factor, within its limits
  if (std::isnan(ratio)) return Real(0.1);
  const Real k = Real(power), last = std::max(ratio, Real(1e-9)),
             before = std::max(ratio_before, Real(1e-9));
  if (last > 1) return std::max(Real(0.85) * std::pow(last, -1 / k), Real(0.1));
  const Real wanted = Real(0.85) * std::pow(last, Real(-0.7) / k) * std::pow(before, Real(0.4) / k);
  return std::clamp(wanted, Real(0.2), Real(6));
  //! [end]
}

/// By which factor each step shrinks a small deviation of the errors in the end, on a smooth
/// stretch: 0 or more. The controller multiplies the step by
/// 0.85 ratio^(-last/power) ratio_before^(before/power), with `last` and `before` 0 or more.
template <class Real>
Real deviation_left(Real last, Real before) {
  //! [solution] the size of the larger root
  const Real half = (1 - last) / 2;
  return std::abs(half) + std::sqrt(half * half + before);
  //! [end]
}
