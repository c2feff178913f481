// Prints a scene file, and makes a table of the shipped scenes.
#include <cstdio>
#include <support/record.hpp>
#include <support/shipped_scenes.hpp>
#include <tumble/scene/read_scene_file.hpp>

using namespace tumble;

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  std::ifstream file(support::scenes_folder() / "t_handle.json");
  std::printf("%s", std::string(std::istreambuf_iterator<char>(file), {}).c_str());

  support::Table scenes =
      notebook.table("scenes", {"scene", "title", "bodies", "effects that run", "simulated (s)"});
  for (const std::filesystem::path& path : support::shipped_scenes()) {
    Scene<double> scene = read_scene_file<double>(path);
    scenes.row(path.stem().string(), scene.title, std::to_string(scene.world.body_count()),
               std::to_string(scene.world.plan().passes()), text_of(scene.duration));
  }
}
