/// @file
/// What a scene is held against, since it has no exact solution: itself with ever shorter steps,
/// extrapolated to steps of no length.
#pragma once

#include <array>
#include <functional>
#include <tumble/scene/scene.hpp>
#include <vector>

#include "candidate.hpp"

namespace tumble::advise {

/// Where all bodies are at one moment.
struct Snapshot {
  std::vector<Vec3d> places;
  std::vector<Quaterniond> orientations;
};

template <class Real>
Snapshot snapshot_of(const Bodies<Real>& bodies) {
  Snapshot snapshot;
  for (const Particle<Real>& centre : bodies.centres)
    snapshot.places.push_back(centre.position.template cast<double>());
  for (const Top<Real>& top : bodies.tops)
    snapshot.orientations.push_back({static_cast<double>(top.orientation.real),
                                     top.orientation.imaginary.template cast<double>()});
  return snapshot;
}

/// Whether a run is compared at the end of this frame. Of many frames a hundred are, spread evenly,
/// with the last among them.
inline bool is_compared(long frame, const Frames& frames) {
  constexpr long most_snapshots = 100;
  return (frames.count - frame) % ((frames.count + most_snapshots - 1) / most_snapshots) == 0;
}

/// The largest differences; a run that ends in no number has failed.
Errors errors_between(const std::vector<Snapshot>& mine, const std::vector<Snapshot>& truth);

/// The power p of the step with which errors fall, from three runs with so many steps and the
/// differences between neighbours: these are as n₁^−p − n₂^−p to n₂^−p − n₃^−p. From 1 to 10, the
/// orders of a world; what falls more slowly is no order at all.
int order_of_fall(double first_difference, double second_difference,
                  const std::array<long, 3>& steps);

/// Richardson: what two runs say about steps of no length. If errors fall as the step to the power
/// `order` and the finer run takes `ratio` times as many steps, then 1/(ratio^order − 1) of the
/// difference is still to go.
std::vector<Snapshot> extrapolated(const std::vector<Snapshot>& coarse,
                                   const std::vector<Snapshot>& fine, double ratio, int order);

/// The best extrapolation, and how far it may be off.
struct Reference {
  std::vector<Snapshot> snapshots;
  Errors uncertainty = failed_run;
  std::array<long, 2> steps = {};  ///< of its two runs, in each piece of a frame
};

/// The scene, stepped by Suzuki's scheme, with steps of a given length.
using SceneWith = std::function<Scene<double>(const StepLength&)>;

/// Runs the scene until three extrapolations agree to a fiftieth of the tolerance or a run would
/// take longer than `longest_run` seconds. Each run cuts the frames at the moments at which effects
/// switch, so that no step contains one. What else has a kink, such as a tether that goes taut,
/// meets other places in the steps of each run: their numbers are Fibonacci's, of which neighbours
/// have no divisor in common.
/// @throws SimulationError if even the shortest steps fail.
Reference reference_of(const SceneWith& scene_with, const Frames& frames,
                       const Tolerance& tolerance, double longest_run);

}  // namespace tumble::advise
