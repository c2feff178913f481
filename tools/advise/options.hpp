/// @file
/// What the command line of advise asks for.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <support/usage_error.hpp>

#include "candidate.hpp"
#include "free_top.hpp"

namespace tumble::advise {

using support::UsageError;

/// How the program ends.
enum ExitCode {
  confirmed = 0,
  refused = 1,   ///< no method could be confirmed to be that accurate
  bad_input = 2  ///< the command line or the scene is wrong; nothing was measured
};

struct Options {
  std::filesystem::path scene;         ///< empty: a free top is asked for
  std::optional<FreeTopQuestion> top;  ///< nothing: a scene is asked for
  Frames frames;
  Tolerance tolerance;
  Precisions precisions;
  StepKinds kinds;
  double longest_run = 1;  ///< s
  bool json = false;
};

/// @return nothing if the help was printed and that was all.
/// @throws UsageError with a sentence.
std::optional<Options> read_options(int argument_count, char** arguments);

}  // namespace tumble::advise
