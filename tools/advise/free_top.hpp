/// @file
/// The candidates for one top without torque: every rung of the ladder, with steps of one length
/// and with its own, and the exact solution.
#pragma once

#include <array>
#include <vector>

#include "candidate.hpp"

namespace tumble::advise {

/// A top without torque: its principal moments (kg m²) and its spin (rad/s, body axes).
struct FreeTopQuestion {
  std::array<double, 3> moments = {}, spin = {};
};

/// Which precisions may answer.
struct Precisions {
  bool single = true, twice = true;
};

/// By which steps a method may get there. The exact solution takes none, and is left out where one
/// of the two is ruled out.
struct StepKinds {
  bool even = true;  ///< of one length
  bool own = true;   ///< chosen by the method
  bool any() const { return even && own; }
};

/// All methods that turn this top rightly as the step goes to zero. One that chooses its own steps
/// and is seen to need more than `longest_run` seconds even at its coarsest is not run.
/// The moments must be those of some body. A precision that can't store them is left out.
std::vector<Candidate> free_top_candidates(const FreeTopQuestion& question, const Frames& frames,
                                           const Precisions& precisions, const StepKinds& kinds,
                                           double longest_run);

/// How far the exact orientations are off at most, rad, once they are rounded to float and to
/// double: no method that stores its states so can be expected to be nearer.
struct Rounded {
  double single = 0, twice = 0;
};
Rounded rounded_truth(const FreeTopQuestion& question, const Frames& frames);

/// How far the exact solution in long double may itself be off, rad, for this question and those
/// like it, in the precisions that may answer.
double uncertainty_of_truth(const FreeTopQuestion& question, const Frames& frames,
                            const Precisions& precisions);

}  // namespace tumble::advise
