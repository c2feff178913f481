/// @file
/// Simulates a scene as advise promised, beside its exact solution.
#pragma once

#include <support/scene_rules.hpp>
#include <support/shipped_scenes.hpp>
#include <tumble/exact/free_top.hpp>
#include <tumble/exact/kepler.hpp>
#include <tumble/scene/read_scene_file.hpp>

#include "kept.hpp"

template <class Real>
double scene_error(const Json& question, const Json& promise) {
  const std::string name = question["scene"];
  const auto& words = turning_method_words<support::SceneRules>();
  const auto method = std::find(words.begin(), words.end(), promise["method"].get<std::string>());
  if (method == words.end()) fail("a world has no method " + promise["method"].dump());
  const auto& schemes = scheme_words();
  const auto scheme = promise["scheme"].is_null() ? schemes.begin()
                                                  : std::find(schemes.begin(), schemes.end(),
                                                              promise["scheme"].get<std::string>());
  if (scheme == schemes.end()) fail("a world has no scheme " + promise["scheme"].dump());
  const long rate = promise["steps_per_second"], states = question["states_per_second"];
  const std::filesystem::path path = support::scenes_folder() / name;
  Scene<Real> scene = read_scene_file<Real, OneByOne<Real>, support::SceneRules>(
      path, {.step = steps_per_second(rate),
             .turning_method = static_cast<std::size_t>(method - words.begin()),
             .scheme = Scheme(scheme - schemes.begin())});
  const long steps = std::lround(question["seconds"].get<double>() * static_cast<double>(rate));
  const Bodies<Real>& bodies = scene.world.bodies();
  // What is promised is the scene as it is written, not as float has rounded its numbers.
  const Bodies<double> written =
      read_scene_file<double, OneByOne<double>, support::SceneRules>(path).world.bodies();
  double worst = 0;
  if (name == "t_handle.json") {
    const exact::FreeTop<long double> truth(wide(written.tops[0]));
    for (long step = 1; step <= steps; ++step) {
      scene.world.step();
      if (step % (rate / states) != 0) continue;
      const auto right = truth.at(static_cast<long double>(step) / static_cast<long double>(rate));
      worst = std::max(worst,
                       double(angle_between(right.orientation, wide(bodies.tops[0]).orientation)));
    }
    return worst;
  }
  if (name == "orbit.json") {
    std::vector<exact::KeplerOrbit<long double>> orbits;
    for (const Particle<double>& centre : written.centres)
      orbits.emplace_back(
          Particle<long double>{.position = centre.position.template cast<long double>(),
                                .velocity = centre.velocity.template cast<long double>()},
          3.986004418e14L);
    for (long step = 1; step <= steps; ++step) {
      scene.world.step();
      if (step % (rate / states) != 0) continue;
      for (std::size_t body = 0; body < orbits.size(); ++body) {
        const auto right =
            orbits[body].at(static_cast<long double>(step) / static_cast<long double>(rate));
        const Vec3<long double> place = bodies.centres[body].position.template cast<long double>();
        worst = std::max(worst, static_cast<double>((place - right.position).norm()));
      }
    }
    return worst;
  }
  fail("no exact solution of " + name);
}
