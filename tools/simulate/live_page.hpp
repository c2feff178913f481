/// @file
/// What --live writes: a page that holds the engine and a scene.
#pragma once

#include "live_limits.hpp"
#include "output_file.hpp"
#include "page_text.hpp"
#include "paths.hpp"
#include "simulated_scene.hpp"
#include "steps_until.hpp"

namespace tumble::simulate {

/// The whole file, or nothing if there is none.
inline std::string text_of_file(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Writes the page. The scene is read before, so that what a terminal would refuse is refused here
/// too.
/// @throws SceneError, UsageError, FileError.
inline void write_live_page(const Options& options) {
  const SceneInPacks<double> scene = scene_of<double>(options);
  (void)steps_until(scene);
  require_drawable(scene);
  const std::filesystem::path folder = live_scene_folder();
  const std::string drawing = text_of_file(folder / "scene.live.js"),
                    module = text_of_file(folder / "scene.wasm");
  if (drawing.empty() || module.empty())
    throw FileError(options.live,
                    "the engine for pages was not built; that takes clang++ with Debian's packages "
                    "lld, wasi-libc, libc++-dev-wasm32 and libclang-rt-dev-wasm32");
  OutputFile file(options.live);
  file.write(live_page(scene, text_of_file(options.scene), options.scene.filename().string(),
                       drawing, module));
  file.finish();
  std::printf("wrote %s\n", file.path().c_str());
}

}  // namespace tumble::simulate
