#include "free_top_trials.hpp"

namespace tumble::advise {

extern template void append_free_top<float>(std::vector<Candidate>&, const FreeTopQuestion&,
                                            const Frames&, const StepKinds&, double);
extern template void append_free_top<double>(std::vector<Candidate>&, const FreeTopQuestion&,
                                             const Frames&, const StepKinds&, double);

namespace {

/// The angle between an orientation and what of it a precision can store, rad.
template <class Real>
double rounding_of(const Quaternion<long double>& truth) {
  const Quaternion<long double> stored = {
      static_cast<Real>(truth.real),
      truth.imaginary.template cast<Real>().template cast<long double>()};
  return static_cast<double>(angle_between(truth, stored));
}

}  // namespace

std::vector<Candidate> free_top_candidates(const FreeTopQuestion& question, const Frames& frames,
                                           const Precisions& precisions, const StepKinds& kinds,
                                           double longest_run) {
  std::vector<Candidate> candidates;
  if (precisions.twice) append_free_top<double>(candidates, question, frames, kinds, longest_run);
  if (precisions.single) append_free_top<float>(candidates, question, frames, kinds, longest_run);
  return candidates;
}

Rounded rounded_truth(const FreeTopQuestion& question, const Frames& frames) {
  const exact::FreeTop<long double> exact(start_of<long double>(question, 0));
  Rounded worst;
  for (long frame = 1; frame <= frames.count; ++frame) {
    if (frame % frames_between_samples(frames) != 0) continue;
    const Quaternion<long double> truth =
        exact.at(static_cast<long double>(frame) / static_cast<long double>(frames.rate))
            .orientation;
    worst.single = std::max(worst.single, rounding_of<float>(truth));
    worst.twice = std::max(worst.twice, rounding_of<double>(truth));
  }
  return worst;
}

double uncertainty_of_truth(const FreeTopQuestion& question, const Frames& frames,
                            const Precisions& precisions) {
  double worst = 0;
  for (int trial = 0; trial < trials; ++trial) {
    const auto look = [&](const auto& start) {
      worst = std::max(worst, uncertainty_of_truth(support::exactly(start), frames.seconds()));
    };
    if (precisions.twice) look(start_of<double>(question, trial));
    if (precisions.single) look(start_of<float>(question, trial));
  }
  return worst;
}

}  // namespace tumble::advise
