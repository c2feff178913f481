/// @file
/// Exercise: a sum that is the same, to the bit, on any number of workers.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exercise/todo.hpp>
#include <tumble/require.hpp>
#include <vector>

/// How many ticks `value` is, rounded to the nearest. `tick` is a power of two, so the division
/// rounds nothing.
/// @throws std::invalid_argument if the value is not finite, or more than 2^40 ticks either way.
template <class Real>
std::int64_t ticks_of(Real value, Real tick) {
  todo("the value as a whole number of ticks, or a refusal");
}

/// The sum of values[first] to values[last - 1], as one worker makes it, in ticks.
template <class Real>
std::int64_t sum_of_share(const std::vector<Real>& values, std::size_t first, std::size_t last,
                          Real tick) {
  todo("one worker's sum");
}

/// The sum of up to a million values, each worker summing a share. The last worker is the first to
/// be ready here, to make it no easier than it is.
template <class Real>
Real sum_on(const std::vector<Real>& values, Real tick, int workers) {
  const auto count = static_cast<std::size_t>(workers);
  std::int64_t sum = 0;
  for (std::size_t worker = count; worker-- > 0;)
    sum += sum_of_share<Real>(values, values.size() * worker / count,
                              values.size() * (worker + 1) / count, tick);
  return static_cast<Real>(sum) * tick;
}
