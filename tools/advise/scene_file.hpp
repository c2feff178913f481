/// @file
/// The candidates for a whole scene: the methods that a world turns by.
#pragma once

#include <array>
#include <filesystem>
#include <vector>

#include "candidate.hpp"
#include "free_top.hpp"

namespace tumble::advise {

/// What a scene is measured with.
struct SceneCandidates {
  std::vector<Candidate> candidates;
  std::size_t bodies = 0;
  Errors uncertainty;                        ///< of the reference
  std::array<long, 2> reference_steps = {};  ///< of its two runs, see Reference
};

/// The methods for the scene in `file`, held against its reference_of().
/// @throws SceneError if the scene is wrong, SimulationError if the reference can't be run at all.
SceneCandidates scene_candidates(const std::filesystem::path& file, const Frames& frames,
                                 const Tolerance& tolerance, const Precisions& precisions,
                                 double longest_run);

}  // namespace tumble::advise
