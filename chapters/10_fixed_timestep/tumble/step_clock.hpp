/// @file
/// When to step: frame times go in, whole steps come out, and not a nanosecond gets lost on the
/// way.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>
#include <tumble/require.hpp>
#include <type_traits>

namespace tumble {

/// How long a step lasts, exactly: numerator/denominator nanoseconds, in lowest terms. A sixtieth
/// of a second is not a whole number of nanoseconds, but 50 000 000/3 of them.
//! [step_length]
struct StepLength {
  std::int64_t numerator = 50'000'000;
  std::int64_t denominator = 3;
  friend bool operator==(const StepLength&, const StepLength&) = default;
};
//! [step_length]

/// The length of `rate` equal steps in a second.
/// @throws std::invalid_argument if the rate is not between 1 and 1 000 000 per second.
inline StepLength steps_per_second(std::int64_t rate) {
  require_between<std::int64_t>("steps per second", rate, "", 1, 1'000'000);
  // Without signs gcd takes no absolute values. Where all this was inlined, g++ 12.2 made −rate of
  // |rate|, and 241 steps a second became 125.
  const std::uint64_t second = 1'000'000'000, steps = static_cast<std::uint64_t>(rate);
  const std::uint64_t divisor = std::gcd(second, steps);
  return {.numerator = static_cast<std::int64_t>(second / divisor),
          .denominator = static_cast<std::int64_t>(steps / divisor)};
}

/// A step of `nanoseconds`.
/// @throws std::invalid_argument if it is not between a microsecond and an hour.
inline StepLength step_of_nanoseconds(std::int64_t nanoseconds) {
  require_between<std::int64_t>("step", nanoseconds, "ns", 1000, 3'600'000'000'000);
  return {.numerator = nanoseconds, .denominator = 1};
}

/// Throws unless a step written down by hand lasts from `shortest` to an hour. A step of no time
/// moves nothing, which a world may do; a clock could never end handing them out.
/// @throws std::invalid_argument that names the number and its limits.
inline void require_step_length(const StepLength& step, std::int64_t shortest) {
  require_between<std::int64_t>("denominator of the step", step.denominator, "", 1, 1'000'000);
  require_between<std::int64_t>("numerator of the step", step.numerator, "ns", shortest,
                                3'600'000'000'000 * step.denominator);
}

/// The time step h for the formulas of motion, in s. In double both numbers are exact up to 2^53,
/// so that the quotient is rounded once; a longer format in between would round it twice.
template <class Real>
Real time_step_of(const StepLength& step) {
  using Wide = std::conditional_t<std::is_same_v<Real, float>, long double, Real>;
  const std::int64_t second = step.denominator * 1'000'000'000;  // in the numerator's unit
  return static_cast<Real>(static_cast<Wide>(step.numerator) / static_cast<Wide>(second));
}

/// A clock that hands out steps. It never looks at the real time: every frame's duration is told to
/// it, see steps_due(). Its last five numbers are its books, and they always balance:
/// (time_in − dropped_time) · denominator = (steps + dropped_steps) · numerator + remainder.
//! [step_clock]
struct StepClock {
  StepLength step;                           ///< how long a step lasts
  std::int64_t longest_frame = 250'000'000;  ///< ns; the rest of a frame is dropped
  std::int64_t most_steps = 8;               ///< in a frame; steps beyond this are dropped

  std::int64_t time_in = 0;        ///< ns, of all frames
  std::int64_t dropped_time = 0;   ///< ns, because of longest_frame
  std::int64_t steps = 0;          ///< handed out so far: the time in ticks
  std::int64_t dropped_steps = 0;  ///< because of most_steps
  std::int64_t remainder = 0;      ///< 1/denominator ns, for the next frame
};
//! [step_clock]

/// A clock whose settings make sense. A step lasts a nanosecond at least: then there are never more
/// steps than nanoseconds, and the books hold whatever comes in.
/// @throws std::invalid_argument if the step is refused, see require_step_length(), if the longest
/// frame is not between 1 ns and an hour, or the most steps of a frame not between 1 and a million.
inline StepClock make_step_clock(const StepLength& step, std::int64_t longest_frame = 250'000'000,
                                 std::int64_t most_steps = 8) {
  require_step_length(step, step.denominator);
  require_between<std::int64_t>("longest frame", longest_frame, "ns", 1, 3'600'000'000'000);
  require_between<std::int64_t>("most steps in a frame", most_steps, "", 1, 1'000'000);
  return {.step = step, .longest_frame = longest_frame, .most_steps = most_steps};
}

/// Throws unless a time that goes by is 0 or more.
template <class Time>
void require_forward(std::string_view name, Time time, std::string_view unit) {
  if (time < 0) reject(name, time, unit, "time runs forward: it must be 0 or more");
}

/// How many steps to take now that a frame of `frame` nanoseconds is over. What is left of it waits
/// for the next frame; what the two caps cut off is dropped and counted.
/// @throws std::invalid_argument if the frame is negative, or if all frames together exceed 292
/// years; the clock is then unchanged.
//! [steps_due]
inline std::int64_t steps_due(StepClock& clock, std::int64_t frame) {
  require_forward("frame time", frame, "ns");
  if (frame > std::numeric_limits<std::int64_t>::max() - clock.time_in)
    reject("frame time", frame, "ns", "with it the clock would have run for over 292 years");
  const std::int64_t taken = std::min(frame, clock.longest_frame);
  const std::int64_t waiting = clock.remainder + taken * clock.step.denominator;
  const std::int64_t whole = waiting / clock.step.numerator;
  const std::int64_t due = std::min(whole, clock.most_steps);

  clock.time_in += frame;
  clock.dropped_time += frame - taken;
  clock.steps += due;
  clock.dropped_steps += whole - due;
  clock.remainder = waiting % clock.step.numerator;
  return due;
}
//! [steps_due]

/// `seconds` in whole nanoseconds, rounded. A clock of the system that counts in integers is better
/// still: there the differences are exact.
/// @throws std::invalid_argument if it is negative, NaN, or beyond 9.2e9 s, which is 291 years.
inline std::int64_t nanoseconds_of(double seconds) {
  require_finite("frame time", seconds, "s");
  require_forward("frame time", seconds, "s");
  require_between("frame time", seconds, "s", 0, 9.2e9);
  return static_cast<std::int64_t>(std::llround(seconds * 1e9));
}

/// The time that the steps so far have simulated, in s: n h, with one rounding of h and one of the
/// product, and one of n where it has more digits than Real, however large it is.
template <class Real>
Real simulated_time(const StepClock& clock) {
  return static_cast<Real>(clock.steps) * time_step_of<Real>(clock.step);
}

/// The time that was dropped, in s: by how much the simulation is behind the clock on the wall, but
/// for the part of a step that is waiting.
template <class Real>
Real dropped_time(const StepClock& clock) {
  return static_cast<Real>(clock.dropped_time) / Real(1e9) +
         static_cast<Real>(clock.dropped_steps) * time_step_of<Real>(clock.step);
}

/// How far the drawn moment has gone from the step before the last to the last one, 0 to 1.
template <class Real>
Real fraction_of_step(const StepClock& clock) {
  return static_cast<Real>(clock.remainder) / static_cast<Real>(clock.step.numerator);
}

}  // namespace tumble
