/// @file
/// What the advisor chooses among: a method in a precision, that can be run with any number of
/// steps in a frame, timed, and held against the truth.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>

namespace tumble::advise {

/// The largest errors that are wanted; infinite where nobody asks.
struct Tolerance {
  double angle = std::numeric_limits<double>::infinity();  ///< of any orientation, rad
  double place = std::numeric_limits<double>::infinity();  ///< of any centre of mass, m
};

/// The largest errors on the way, of all bodies and all frames that were compared.
struct Errors {
  double angle = 0;     ///< rad
  double place = 0;     ///< m
  double energy = 0;    ///< of a free top, relative
  double momentum = 0;  ///< of a free top, in world axes, relative
  long steps = 0;       ///< how many a method that chooses its own has made in the run
  long rejected = 0;    ///< and how many it has repeated

  /// How large they are in terms of what is wanted: at most 1 if the tolerance is met. A run that
  /// failed is infinitely far off.
  double of(const Tolerance& tolerance) const {
    if (!std::isfinite(angle) || !std::isfinite(place))
      return std::numeric_limits<double>::infinity();
    return std::max(angle / tolerance.angle, place / tolerance.place);
  }
};

inline constexpr Errors failed_run = {.angle = std::numeric_limits<double>::infinity(),
                                      .place = std::numeric_limits<double>::infinity()};

/// The larger one of each, the number of steps included.
inline Errors worse(const Errors& a, const Errors& b) {
  return {std::max(a.angle, b.angle),   std::max(a.place, b.place),
          std::max(a.energy, b.energy), std::max(a.momentum, b.momentum),
          std::max(a.steps, b.steps),   std::max(a.rejected, b.rejected)};
}

/// No frame holds more steps than this.
inline constexpr long most_steps_per_frame = 1L << 24;

/// One method in one precision. How finely it works is said by a whole number, its fineness: so
/// many steps of one length in a frame, or, of a method that chooses its own steps, a tolerance (or
/// an angle) that calls for about so many times as many as the coarsest one.
struct Candidate {
  std::string method, precision;
  std::string scheme = {};  ///< by which a scene's bodies are stepped; none: Euler's
  int order = 0;            ///< what it claims; the highest is tried first
  bool takes_steps = true;  ///< false: the exact solution, asked once a frame
  int power = 0;  ///< 0: steps of one length. Else it chooses them by what it is given, to 1/power
  bool is_given_angle = false;         ///< for each step, rad; else a tolerance, rad a second
  double coarsest = 0;                 ///< what it is given at a fineness of 1
  long finest = most_steps_per_frame;  ///< beyond it there is nothing to gain
  /// The errors at such a fineness. Trial 0 is the question that was asked; the others are others
  /// like it, up to `trials` in all.
  std::function<Errors(long fineness, int trial)> errors = {};
  int trials = 1;
  /// The time of the whole run, ns: the fastest of so many repetitions.
  std::function<double(long fineness, int repetitions)> nanoseconds = {};

  bool chooses_steps() const { return power > 0; }
  /// What a method that chooses its steps is given: steps are as long as its root.
  double given(long fineness) const {
    return coarsest * std::pow(static_cast<double>(fineness), -power);
  }
};

/// When states are wanted: `frames` of them, `rate` in a second.
struct Frames {
  long count = 0, rate = 60;
  double seconds() const { return static_cast<double>(count) / static_cast<double>(rate); }
};

}  // namespace tumble::advise
