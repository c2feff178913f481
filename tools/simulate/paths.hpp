/// @file
/// Files of this checkout that simulate needs when it runs. They are compiled alone, as
/// support::scenes_folder() is.
#pragma once

#include <filesystem>

namespace tumble::simulate {

/// gnuplot's settings for every figure of the book.
std::filesystem::path figure_style();
/// The script that draws a simulated scene.
std::filesystem::path plot_script();
/// Where the build leaves the engine for pages.
std::filesystem::path live_scene_folder();

}  // namespace tumble::simulate
