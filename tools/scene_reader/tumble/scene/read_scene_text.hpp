/// @file
/// How the text of a scene file becomes a world: what read_scene() calls, element by element.
#pragma once

#include <tumble/scene/read_body.hpp>
#include <tumble/scene/read_effect.hpp>
#include <tumble/scene/read_scene.hpp>

namespace tumble {

inline StepLength read_step(const Object& object) {
  const Value length = object.one_of("per_second", "nanoseconds");
  return object.has("per_second") ? steps_per_second(length.whole(1, 1'000'000))
                                  : step_of_nanoseconds(length.whole(1000, 3'600'000'000'000));
}

//! [read_scene]
template <class Real, class Backend>
Scene<Real, Backend> read_scene_text(std::string_view text, const std::string& file,
                                     const SceneChanges& changes,
                                     std::span<const std::string> turning_methods) {
  const nlohmann::json json = parse_json(text, file);
  const Reading reading{file, range_of<Real>()};
  const Object object = object_called(Value(reading, "", json), "scene");
  Scene<Real, Backend> scene{.title = object.text("title", file),
                             .description = object.text("description", "")};
  scene.duration = object["duration"].positive();
  if (scene.duration > longest_duration)
    object["duration"].reject("at most " + text_of(longest_duration) + " s are simulated");

  StepLength step;
  if (object.has("step")) step = read_step(object_called(object["step"], "step"));
  scene.world = World<Real, Backend>(changes.step.value_or(step));
  if (object.has("turning_method"))
    scene.turning_method = object["turning_method"].one_of("method", turning_methods);
  if (changes.turning_method) scene.turning_method = changes.turning_method;
  if (object.has("scheme"))
    scene.world.step_by(Scheme(object["scheme"].one_of("scheme", scheme_words())));
  if (changes.scheme) scene.world.step_by(*changes.scheme);

  const Value bodies = object["bodies"];
  bodies.list("bodies");
  std::set<std::string> names;
  bool is_random = false;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Object body = object_called(bodies.at(i), "body");
    if (!names.insert(body["name"].text()).second)
      body["name"].reject("another body has that name, and names must differ");
    read_body(body, scene, changes);
    is_random = is_random || body.has("many");
  }
  if (changes.seed != 0 && !is_random)
    bodies.fail("hold nothing random that a seed could change: none of them has the key many");
  if (!object.has("effects")) return scene;
  const Value effects = object["effects"];
  if (!effects.is_array()) effects.reject("it must be a list of effects");
  for (std::size_t i = 0; i < effects.size(); ++i) read_effect(effects.at(i), scene);
  return scene;
}
//! [read_scene]

}  // namespace tumble
