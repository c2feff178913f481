#include "paths.hpp"

namespace tumble::simulate {

std::filesystem::path figure_style() {
  return TUMBLE_FIGURE_STYLE;
}
std::filesystem::path plot_script() {
  return TUMBLE_PLOT_SCRIPT;
}
std::filesystem::path live_scene_folder() {
  return TUMBLE_LIVE_SCENE;
}

}  // namespace tumble::simulate
