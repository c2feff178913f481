/// @file
/// What the command line of simulate asks for.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <support/usage_error.hpp>
#include <tumble/scene/scene.hpp>

namespace tumble::simulate {

using support::UsageError;

/// How the program ends.
enum ExitCode {
  all_simulated = 0,
  step_failed = 1,   ///< a step could not be taken; what was computed before is kept
  bad_input = 2,     ///< the command line or the scene is wrong; nothing was done
  file_failed = 3,   ///< a file could not be written; it was left as it was
  too_little = 4,    ///< memory or threads did not suffice
  interrupted = 128  ///< plus the signal's number, as shells count; what was computed is kept
};

struct Options {
  std::filesystem::path scene;
  bool is_float = false;
  bool only_plan = false, check_plan = false, ledger = true, bill = false;
  SceneChanges changes;
  std::string said;             ///< how --dt was rounded; empty if it was not given
  std::optional<double> until;  ///< s
  std::int64_t every = 1;       ///< steps between two records
  int threads = 1;
  std::string follow;  ///< the body that the view's camera goes with; empty: none
  std::filesystem::path csv, json_lines, plot, view, live, books;  ///< empty if not asked for
};

/// @return nothing if the help was printed and that was all.
/// @throws UsageError with a sentence.
std::optional<Options> read_options(int argument_count, char** arguments);

}  // namespace tumble::simulate
