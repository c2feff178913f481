/// @file
/// The scene that simulate runs: in packs, with every turning method that a file can name. Each
/// precision has a file of its own, so that they compile side by side.
#pragma once

#include <course/scene_rules.hpp>
#include <tumble/in_packs.hpp>
#include <tumble/scene/read_scene.hpp>

#include "options.hpp"

namespace tumble::simulate {

template <class Real>
using SceneInPacks = Scene<Real, InPacks<Real>>;

/// @throws SceneError.
template <class Real>
SceneInPacks<Real> scene_of(const Options& options) {
  return read_scene_file<Real, InPacks<Real>, course::SceneRules>(options.scene, options.changes);
}
extern template SceneInPacks<float> scene_of(const Options&);
extern template SceneInPacks<double> scene_of(const Options&);

}  // namespace tumble::simulate
