/// @file
/// What a scene file becomes.
#pragma once

#include <optional>
#include <tumble/scene/scene_error.hpp>
#include <tumble/scene/solid.hpp>
#include <tumble/world.hpp>

namespace tumble {

constexpr std::int64_t most_bodies = 5'000'000;
constexpr std::size_t longest_name = 200;  ///< bytes
constexpr double longest_duration = 1e9;   ///< s

/// How the bodies of one element of "bodies" are drawn. They stand next to each other in the world:
/// their indices are first, first + 1, … as long as none is removed.
struct BodyModel {
  std::string name;              ///< of the body, or what the names of its copies begin with
  std::size_t first = 0;         ///< index of the first body that is drawn so
  std::size_t count = 0;         ///< and how many there are
  std::vector<ModelPart> parts;  ///< none for a point, or where only the inertia is given
  Posed model_in_body;           ///< where the parts' axes lie in the body's
};

/// One end of a spring as it is drawn: a point (m) in a body's model axes, or of the world.
struct DrawnEnd {
  Vec3d point = Vec3d::Zero();           ///< m
  std::optional<std::size_t> body = {};  ///< its index in the world; none: the point is the world's
};

/// An effect to which the file gives a name of its own.
template <class Effect>
struct Named : Effect {
  std::string name;
};

/// A world to simulate, and what the file says beside it.
//! [scene]
template <class Real, class Backend = OneByOne<Real>>
struct Scene {
  std::string title, description;                  ///< without a title: what errors call the file
  double duration = 0;                             ///< s
  std::optional<std::size_t> turning_method = {};  ///< its number in the list that it was read with
  World<Real, Backend> world = World<Real, Backend>();  ///< with its bodies and effects
  std::vector<BodyModel> models = {};                   ///< in the order of the file
  std::vector<std::array<DrawnEnd, 2>> springs = {};    ///< both ends of each
  std::vector<double> switches = {};  ///< when thrusters and motors start and stop, s
};
//! [scene]

/// What a program may want to be otherwise than the file says.
struct SceneChanges {
  std::optional<StepLength> step = {};             ///< none: the file's
  std::optional<std::size_t> turning_method = {};  ///< its number in the list that is read with
  std::optional<Scheme> scheme = {};               ///< none: the file's
  std::uint64_t seed = 0;  ///< added to the seed of each "many"; but for 0 there must be one
  /// No element of "bodies" becomes more bodies than this.
  std::size_t most_copies = static_cast<std::size_t>(most_bodies);
};

/// Names as scene files spell them: "axis by axis" is axis_by_axis.
template <std::size_t count>
std::array<std::string, count> words_of(const std::array<std::string_view, count>& names) {
  std::array<std::string, count> words;
  for (std::size_t i = 0; i < count; ++i)
    for (const char letter : names[i])
      if (letter != ',')
        words[i] += letter == ' ' || letter == '-'   ? '_'
                    : letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a')
                                                     : letter;
  return words;
}

/// The names of rules: "axis_by_axis", "splitting_kahan_li_8".
template <class Rules>
const auto& turning_method_words() {
  static const auto words = words_of(Rules::names);
  return words;
}

/// The names of schemes: "semi_implicit_euler", "verlet", "suzuki".
inline const auto& scheme_words() {
  static const auto words = words_of(scheme_names);
  return words;
}

}  // namespace tumble
