// Prints a scene file, and makes two tables: the shipped scenes, and all keys with their units.
#include <course/record.hpp>
#include <course/shipped_scenes.hpp>
#include <cstdio>
#include <tumble/scene/keys.hpp>
#include <tumble/scene/read_scene.hpp>

namespace {

using namespace tumble;

template <class Kinds>
void write_keys(course::Table& table, const Kinds& kinds) {
  for (const ObjectKeys& kind : kinds)
    for (const Key& key : kind.keys)
      table.row(kind.name, key.name, key.unit.empty() ? "–" : key.unit,
                key.required ? "yes" : "no");
}

}  // namespace

int main(int argument_count, char** arguments) {
  course::Notebook notebook(argument_count, arguments);
  std::ifstream file(std::filesystem::path(TUMBLE_SCENES) / "t_handle.json");
  std::printf("%s", std::string(std::istreambuf_iterator<char>(file), {}).c_str());

  course::Table scenes =
      notebook.table("scenes", {"scene", "title", "bodies", "effects that run", "simulated (s)"});
  for (const std::filesystem::path& path : course::shipped_scenes()) {
    Scene<double> scene = read_scene_file<double>(path);
    scenes.row(path.stem().string(), scene.title, std::to_string(scene.world.body_count()),
               std::to_string(scene.world.plan().passes()), text_of(scene.duration));
  }
  course::Table bodies = notebook.table("scene_keys", {"object", "key", "unit", "required"});
  write_keys(bodies, object_kinds);
  course::Table solids = notebook.table("solid_keys", {"solid", "key", "unit", "required"});
  write_keys(solids, solid_kinds);
  course::Table effects = notebook.table("effect_keys", {"effect", "key", "unit", "required"});
  write_keys(effects, effect_kinds);
}
