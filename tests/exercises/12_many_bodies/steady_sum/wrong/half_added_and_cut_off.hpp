// caught by: The sum is off by at most half a tick for each value, either way
// message: adding a half before cutting off
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <tumble/require.hpp>
#include <vector>

template <class Real>
std::int64_t ticks_of(Real value, Real tick) {
  const Real ticks = value / tick;
  const Real most = std::ldexp(Real(1), 40);
  if (!(std::abs(ticks) <= most))
    tumble::reject("summand", value, "kg m/s", "it must be finite, and at most 2^40 ticks");
  return static_cast<std::int64_t>(std::floor(ticks + Real(0.5)));
}

template <class Real>
std::int64_t sum_of_share(const std::vector<Real>& values, std::size_t first, std::size_t last,
                          Real tick) {
  std::int64_t sum = 0;
  for (std::size_t i = first; i < last; ++i) sum += ticks_of(values[i], tick);
  return sum;
}

template <class Real>
Real sum_on(const std::vector<Real>& values, Real tick, int workers) {
  const auto count = static_cast<std::size_t>(workers);
  std::int64_t sum = 0;
  for (std::size_t worker = count; worker-- > 0;)
    sum += sum_of_share<Real>(values, values.size() * worker / count,
                              values.size() * (worker + 1) / count, tick);
  return static_cast<Real>(sum) * tick;
}
