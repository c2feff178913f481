/// @file
/// The scene that simulate runs: in packs, with every turning method that a file can name.
#pragma once

#include <support/scene_rules.hpp>
#include <tumble/in_packs.hpp>
#include <tumble/scene/read_scene_file.hpp>

#include "options.hpp"

namespace tumble::simulate {

template <class Real>
using SceneInPacks = Scene<Real, InPacks<Real>>;

/// @throws SceneError.
template <class Real>
SceneInPacks<Real> scene_of(const Options& options) {
  return read_scene_file<Real, InPacks<Real>, support::SceneRules>(options.scene, options.changes);
}

}  // namespace tumble::simulate
