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

double uncertainty_of_truth(const FreeTopQuestion& question, const Frames& frames) {
  const auto& I = question.moments;
  double twice_energy = 0;
  for (std::size_t n = 0; n < 3; ++n) twice_energy += I[n] * question.spin[n] * question.spin[n];
  const double fastest = std::sqrt(twice_energy / std::min({I[0], I[1], I[2]}));
  // As counted beside the checks of FreeTop: 290 roundings once, and 65 for each radian, add up so.
  return (5 * std::sqrt(290 / 3.0) + 5 * std::sqrt(65 / 3.0) * fastest * frames.seconds()) *
         double(std::numeric_limits<long double>::epsilon()) / 2;
}

}  // namespace tumble::advise
