#include <support/shipped_scenes.hpp>

std::filesystem::path tumble::support::scenes_folder() {
  return TUMBLE_SCENES;
}
