/// @file
/// What becomes of a clock that adds up its time steps in floating point, without adding them one
/// by one.
#pragma once

#include <cmath>
#include <cstdint>

namespace tumble::support {

template <class Real>
struct AddedUpTime {
  Real time = 0;
  std::int64_t additions = 0;
  bool stopped = false;  ///< the next addition would change nothing
};

/// The result of `most` times t += h, or of as many as change anything.
///
/// Between two powers of two, from 1 on, all floating-point numbers have one spacing. There t + h
/// is rounded to the same increment every time (unless h lies half-way between two multiples of the
/// spacing, which 1/60 does not), so that one multiplication makes all the additions up to the next
/// power of two. The addition across it is made as it is.
template <class Real>
AddedUpTime<Real> added_up(Real time_step, std::int64_t most) {
  AddedUpTime<Real> sum;
  while (sum.additions < most) {
    const Real next = sum.time + time_step;
    if (next == sum.time) {
      sum.stopped = true;
      break;
    }
    if (sum.time >= 1) {
      const Real increment = next - sum.time;
      const Real power_above = std::ldexp(Real(1), std::ilogb(sum.time) + 1);
      const auto room = static_cast<std::int64_t>((power_above - sum.time) / increment);
      const std::int64_t jump = std::min(room - 1, most - sum.additions - 1);
      if (jump > 0) {
        sum.time += static_cast<Real>(jump) * increment;
        sum.additions += jump;
      }
    }
    sum.time += time_step;
    ++sum.additions;
  }
  return sum;
}

}  // namespace tumble::support
