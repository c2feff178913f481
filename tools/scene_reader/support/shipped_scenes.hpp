/// @file
/// The scene files that come with the course.
#pragma once

#include <algorithm>
#include <filesystem>
#include <vector>

namespace tumble::support {

/// Where they lie in this checkout. It is compiled alone: a path that every reader of a scene were
/// compiled with would let the compiler's cache forget them all in another folder.
std::filesystem::path scenes_folder();

inline std::vector<std::filesystem::path> shipped_scenes() {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(scenes_folder()))
    if (entry.path().extension() == ".json" && entry.path().stem().extension() != ".schema")
      paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  return paths;
}

}  // namespace tumble::support
