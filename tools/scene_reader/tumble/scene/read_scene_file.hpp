/// @file
/// From a scene file to a world.
#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <tumble/scene/read_scene.hpp>

namespace tumble {

/// The scene in a file.
/// @throws SceneError as read_scene() does, and if the file can't be read.
template <class Real, class Backend = OneByOne<Real>, class Rules = FirstTurningRules>
Scene<Real, Backend> read_scene_file(const std::filesystem::path& path,
                                     const SceneChanges& changes = {}) {
  std::ifstream in(path, std::ios::binary);
  if (!in || std::filesystem::is_directory(path))
    throw SceneError(path.string(), "", "there is no such file, or it can't be read");
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  return read_scene<Real, Backend, Rules>(text, path.filename().string(), changes);
}

}  // namespace tumble
