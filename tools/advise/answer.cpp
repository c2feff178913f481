#include "answer.hpp"

#include <support/record.hpp>

#include "progress.hpp"
#include "scene_file.hpp"

namespace tumble::advise {
namespace {

/// Of the precisions that are asked for, those in which the tolerance is not hopeless from the
/// start.
Precisions fine_enough(const Options& asked, const Rounded& rounded) {
  return {.single = asked.precisions.single && rounded.single <= asked.tolerance.angle,
          .twice = asked.precisions.twice && rounded.twice <= asked.tolerance.angle};
}

/// What the finest precision that is asked for loses by rounding the exact solution, rad.
double least_lost(const Options& asked, const Rounded& rounded) {
  return asked.precisions.twice ? rounded.twice : rounded.single;
}

/// Candidates, and what they are held against; or why there is no need of any.
std::vector<Candidate> candidates_for(const Options& asked, Answer& answer) {
  if (asked.top) {
    answer.reference = "the exact solution in long double";
    answer.uncertainty.angle = uncertainty_of_truth(*asked.top, asked.frames, asked.precisions);
    answer.rounded = rounded_truth(*asked.top, asked.frames);
    if (least_lost(asked, answer.rounded) > asked.tolerance.angle)
      answer.refusal = std::string("the exact orientations, rounded to ") +
                       (asked.precisions.twice ? "double" : "float") + ", are off by up to " +
                       support::number("%.2g rad", least_lost(asked, answer.rounded)) +
                       " already, so no method was tried; ask for more than that" +
                       (asked.precisions.twice ? "" : ", or let double be tried");
    return free_top_candidates(*asked.top, asked.frames, fine_enough(asked, answer.rounded),
                               asked.kinds, asked.longest_run);
  }
  const SceneCandidates made = scene_candidates(asked.scene, asked.frames, asked.tolerance,
                                                asked.precisions, asked.longest_run);
  answer.reference = "Richardson's extrapolation of runs with " +
                     std::to_string(made.reference_steps[0]) + " and " +
                     std::to_string(made.reference_steps[1]) + " steps a state";
  answer.uncertainty = made.uncertainty;
  answer.bodies = made.bodies;
  return made.candidates;
}

}  // namespace

Answer answer_to(const Options& asked) {
  Answer answer{.asked = asked};
  const Progress progress;
  progress.show(asked.top ? "computing the exact solution" : "computing the reference");
  answer.candidates = candidates_for(asked, answer);
  if (!(answer.uncertainty.of(asked.tolerance) <= 0.25)) {
    answer.refusal =
        "the reference is not sure enough of itself to confirm that: it would have to be four "
        "times "
        "as accurate as what is wanted. Ask for four times what it is sure to, or for a shorter "
        "time";
    return answer;
  }
  if (!answer.refusal.empty()) return answer;
  if (answer.candidates.empty()) {
    answer.refusal =
        asked.kinds.any()
            ? "the precision that is asked for can't hold these numbers; let another be tried"
            : "no method with such steps is needed for this top, or none "
              "in a precision that can hold its numbers";
    return answer;
  }
  std::string wanted = "what was asked for";
  const Advisor advisor(answer.candidates, asked.frames, asked.longest_run,
                        [&](const Candidate& candidate, std::size_t n, std::size_t of) {
                          progress.show(wanted + ": trying " + candidate.method + " in " +
                                        candidate.precision + ", " + std::to_string(n) + " of " +
                                        std::to_string(of));
                        });
  answer.verdict = advisor.cheapest(asked.tolerance);
  if (!answer.verdict.winner) {
    answer.refusal =
        "no method here could be confirmed to be that accurate. Ask for no less than the nearest "
        "reaches, for a shorter time, or for a --longest-run of more seconds";
  } else {
    const Tolerance tenth{asked.tolerance.angle / 10, asked.tolerance.place / 10};
    wanted = "a tenth of the error";
    if (answer.uncertainty.of(tenth) <= 0.25 && least_lost(asked, answer.rounded) <= tenth.angle)
      answer.better = advisor.cheapest(tenth).winner;
    answer.worse = advisor.best_for(answer.verdict.winner->nanoseconds / 10, asked.tolerance);
    if (!answer.worse) answer.least = advisor.least(asked.tolerance);
  }
  return answer;
}

}  // namespace tumble::advise
