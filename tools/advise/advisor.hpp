/// @file
/// Finds the cheapest method and step for a wanted error, and confirms it before it says so.
#pragma once

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "candidate.hpp"

namespace tumble::advise {

/// A candidate with the fineness that it needs, what it then errs and what it takes.
struct Found {
  const Candidate* candidate = nullptr;
  long fineness = 1;  ///< see Candidate
  Errors errors;
  double nanoseconds = 0;  ///< for each simulated second
};

/// What became of a tolerance that was asked for.
struct Verdict {
  std::optional<Found> winner;   ///< confirmed; nothing if there is none
  std::vector<Found> others;     ///< that would do too, confirmed as well, the cheapest first
  std::optional<Found> nearest;  ///< without a winner: what came nearest
};

/// Chooses among candidates.
class Advisor {
 public:
  /// Is told which candidate is tried now, and that it is number `n` of so many.
  using Tell = std::function<void(const Candidate&, std::size_t n, std::size_t of)>;

  /// `longest_run` (s): a method is not tried with smaller steps once a run takes longer.
  Advisor(
      const std::vector<Candidate>& candidates, const Frames& frames, double longest_run,
      Tell tell = [](const Candidate&, std::size_t, std::size_t) {})
      : candidates_(candidates),
        frames_(frames),
        longest_run_(longest_run),
        tell_(std::move(tell)) {}

  /// The candidate that meets the tolerance in the least time.
  Verdict cheapest(const Tolerance& tolerance) const;

  /// What errs least, in terms of the tolerance, at no more than so many ns for each simulated
  /// second.
  std::optional<Found> best_for(double nanoseconds, const Tolerance& tolerance) const;

  /// What takes least at all: each at its coarsest.
  std::optional<Found> least(const Tolerance& tolerance) const;

 private:
  std::optional<Found> search(const Candidate& candidate, const Tolerance& tolerance,
                              double dearest, std::optional<Found>& nearest) const;
  bool confirm(Found& found, const Tolerance& tolerance) const;
  double nanoseconds(const Candidate& candidate, long fineness, int repetitions) const;

  const std::vector<Candidate>& candidates_;
  Frames frames_;
  double longest_run_;
  Tell tell_;
};

}  // namespace tumble::advise
