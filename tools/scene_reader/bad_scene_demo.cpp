// Mistakes in scene files, and what each is told.
#include <support/record.hpp>
#include <support/refusals.hpp>
#include <tumble/scene/read_scene.hpp>

namespace {

using namespace tumble;

/// Prints what is wrong with a scene of one drop; returns 1 if it was refused.
int try_scene(const char* what, const std::string& bodies, const std::string& effects = "") {
  const std::string text = R"({"title": "Drizzle", "description": "", "duration": 1, "bodies": [)" +
                           bodies + R"(], "effects": [)" + effects + "]}";
  std::printf("%s\n", what);
  try {
    read_scene<float>(text, "drizzle.json");
    support::print_wrapped("is taken");
    return 0;
  } catch (const SceneError& error) {
    support::print_wrapped(error.what());
    return 1;
  }
}

}  // namespace

int main() {
  const std::string drop = R"({"name": "drop", "mass": 4.2e-6})";
  int refused = 0;
  refused += try_scene("A comma too many", drop + ",");
  refused += try_scene("A key that does not exist", R"({"name": "drop", "mas": 4.2e-6})");
  refused += try_scene("A mass below zero", R"({"name": "drop", "mass": -2})");
  refused += try_scene("A mass with its unit", R"({"name": "drop", "mass": "4.2 mg"})");
  refused +=
      try_scene("A mass for which a float is too small", R"({"name": "drop", "mass": 1e40})");
  refused += try_scene("A spring to nobody", drop,
                       R"({"kind": "spring", "bodies": ["dorp"],)"
                       R"( "stiffness": 1, "anchor": [0, 0, 0]})");
  refused += try_scene("Inertia that no real body has",
                       R"({"name": "brick", "mass": 1, "inertia": [1, 1, 3]})");
  support::expect(refused == 7, "each of these scenes is refused");
}
