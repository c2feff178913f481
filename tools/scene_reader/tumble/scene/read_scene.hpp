/// @file
/// From the text of a scene file to a world.
#pragma once

#include <span>
#include <string>
#include <tumble/scene/scene.hpp>

namespace tumble {

/// What read_scene() does before the turning method is chosen; `turning_methods` are the names that
/// the file may use. Defined in read_scene_text.hpp.
template <class Real, class Backend>
Scene<Real, Backend> read_scene_text(std::string_view text, const std::string& file,
                                     const SceneChanges& changes,
                                     std::span<const std::string> turning_methods);

/// The whole scene that `text` describes: JSON as scene.schema.json says. `file` is what errors
/// call it. `Rules` are the turning methods that it can name, see TurningRules: more of them are in
/// chapter 13's turning_rungs.hpp.
/// @throws SceneError with the file, the pointer and what is wrong there. Nothing is left behind.
template <class Real, class Backend = OneByOne<Real>, class Rules = FirstTurningRules>
Scene<Real, Backend> read_scene(std::string_view text, const std::string& file,
                                const SceneChanges& changes = {}) {
  Scene<Real, Backend> scene =
      read_scene_text<Real, Backend>(text, file, changes, turning_method_words<Rules>());
  if (scene.turning_method) Rules::choose(scene.world, *scene.turning_method);
  return scene;
}

#ifdef TUMBLE_COMPILED_SCENES
// The course compiles the reader once for each precision and way of keeping, instead of in every
// program.
extern template Scene<float> read_scene_text(std::string_view, const std::string&,
                                             const SceneChanges&, std::span<const std::string>);
extern template Scene<double> read_scene_text(std::string_view, const std::string&,
                                              const SceneChanges&, std::span<const std::string>);
extern template void FirstTurningRules::choose(World<float>&, std::size_t);
extern template void FirstTurningRules::choose(World<double>&, std::size_t);
#endif

}  // namespace tumble

#ifndef TUMBLE_COMPILED_SCENES
#include <tumble/scene/read_scene_text.hpp>
#endif
