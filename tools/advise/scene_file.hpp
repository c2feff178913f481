/// @file
/// The candidates for a whole scene: the methods that a world turns by, and a reference by
/// Richardson where there is no exact solution.
#pragma once

#include <filesystem>
#include <vector>

#include "candidate.hpp"
#include "free_top.hpp"

namespace tumble::advise {

/// What a scene is measured with.
struct SceneCandidates {
  std::vector<Candidate> candidates;
  std::size_t bodies = 0;
  Errors uncertainty;        ///< of the reference
  long reference_steps = 0;  ///< in a frame
};

/// The methods for the scene in `file`. The reference takes ever shorter steps, until it is sure to
/// a fiftieth of what is wanted or a run takes longer than `longest_run` seconds.
/// @throws SceneError if the scene is wrong, SimulationError if the reference can't be run at all.
SceneCandidates scene_candidates(const std::filesystem::path& file, const Frames& frames,
                                 const Tolerance& tolerance, const Precisions& precisions,
                                 double longest_run);

}  // namespace tumble::advise
