/// @file
/// Steps a scene by its plan and beside it exhaustively, and says where they part.
#pragma once

#include "options.hpp"

namespace tumble::simulate {

/// @return all_simulated if they never part, else step_failed.
/// @throws UsageError, SceneError.
ExitCode check_plan(const Options& options);

}  // namespace tumble::simulate
