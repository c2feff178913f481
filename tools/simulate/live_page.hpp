/// @file
/// A page that holds the engine and a scene: what --live writes.
#pragma once

#include <support/json_text.hpp>
#include <support/live_files.hpp>
#include <support/player_page.hpp>

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

/// The page of a scene; `drawing` is the figure's script, and `module` what computes it.
template <class AnyScene>
std::string live_page(const AnyScene& scene, std::string_view text, std::string_view file,
                      std::string_view drawing, std::string_view module) {
  std::string page = R"(<!DOCTYPE html>
<html lang="en-GB">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>)" + escaped(scene.title) +
                     R"(</title>
<link rel="icon" href="data:,">
<style>
)";
  page.append(support::player_style).append(support::live_style).append(R"(</style>
</head>
<body class="player-page">
<main>
<h1>)");
  page.append(escaped(scene.title)).append("</h1>\n<p>").append(escaped(scene.description));
  page.append(R"(</p>
<noscript><p>The scene is computed and drawn by a script, and this browser runs none.</p></noscript>
<figure class="live" id="live_scene" data-live="scene" data-script="">
<div class="live-picture"></div>
<script type="application/json" class="live-texts">)");
  page.append(support::json_in_script("{\"scene\":" + support::json_text(text) +
                                      ",\"file\":" + support::json_text(file) + "}"));
  page.append("</script>\n</figure>\n</main>\n<script>\n");
  page.append(support::player_script).append(support::live_script).append(drawing);
  page.append("tumble_live.modules.scene = '").append(base64(module));
  return page.append("';\n</script>\n</body>\n</html>\n");
}

/// Writes it. The scene is read before, so that what a terminal would refuse is refused here too.
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
