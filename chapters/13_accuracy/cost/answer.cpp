#include "answer.hpp"

#include "scene_file.hpp"

namespace tumble::cost {
namespace {

/// Candidates, and what they are held against.
std::vector<Candidate> candidates_for(const Options& asked, Answer& answer) {
  if (asked.top) {
    answer.reference = "the exact solution in long double";
    answer.uncertainty.angle = uncertainty_of_truth(*asked.top, asked.frames);
    return free_top_candidates(*asked.top, asked.frames, asked.precisions);
  }
  const SceneCandidates made =
      scene_candidates(asked.scene, asked.frames, asked.wish, asked.precisions, asked.longest_run);
  answer.reference = "Richardson's extrapolation of runs with " +
                     std::to_string(made.reference_steps) + " and " +
                     std::to_string(made.reference_steps / 2) + " steps a state";
  answer.uncertainty = made.uncertainty;
  answer.bodies = made.bodies;
  return made.candidates;
}

}  // namespace

Answer answer_to(const Options& asked) {
  Answer answer{.asked = asked};
  answer.candidates = candidates_for(asked, answer);
  if (!(answer.uncertainty.of(asked.wish) <= 0.25)) {
    answer.refusal =
        "the reference is not sure enough of itself to confirm that: it would have to be four "
        "times "
        "as accurate as what is wanted";
    return answer;
  }
  if (answer.candidates.empty()) {
    answer.refusal = "the precision that is asked for can't hold these numbers";
    return answer;
  }
  const Advisor advisor(answer.candidates, asked.frames, asked.longest_run);
  answer.verdict = advisor.cheapest(asked.wish);
  if (!answer.verdict.winner) {
    answer.refusal = "no method here could be confirmed to be that accurate";
  } else {
    const Wish tenth{asked.wish.angle / 10, asked.wish.place / 10};
    if (answer.uncertainty.of(tenth) <= 0.25) answer.better = advisor.cheapest(tenth).winner;
    answer.worse = advisor.best_for(answer.verdict.winner->nanoseconds / 10, asked.wish);
    if (!answer.worse) answer.least = advisor.least(asked.wish);
  }
  return answer;
}

}  // namespace tumble::cost
