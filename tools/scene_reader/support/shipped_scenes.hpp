/// @file
/// The scene files that come with the course.
#pragma once

#include <algorithm>
#include <filesystem>
#include <vector>

namespace tumble::support {

inline std::vector<std::filesystem::path> shipped_scenes() {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(TUMBLE_SCENES))
    if (entry.path().extension() == ".json" && entry.path().stem().extension() != ".schema")
      paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  return paths;
}

}  // namespace tumble::support
