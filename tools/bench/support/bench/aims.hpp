/// @file
/// What the world is meant to cost, beside what it does.
#pragma once

#include <support/bench/ratios.hpp>

namespace tumble::support::bench {

/// A ratio that should not exceed `aim`, in both precisions.
struct Aim {
  std::string what;
  Maybe in_float, in_double;
  double aim;
};

/// All of one run; `count` bodies fit into the cache.
inline std::vector<Aim> aims(const Ratios& ratios, std::size_t count, Pace pace_in_float,
                             Pace pace_in_double) {
  const auto row = [](std::string what, double aim, const auto& in_precision) {
    return Aim{std::move(what), in_precision("float"), in_precision("double"), aim};
  };
  const auto against = [&](const std::string& ours, const std::string& other, Scene scene,
                           std::size_t n) {
    return [=, &ratios](const std::string& precision) {
      return ratio(ratios.time(ours, scene, n, precision), ratios.time(other, scene, n, precision));
    };
  };
  constexpr Scene points = Scene::points_under_gravity, torqued = Scene::tumbling_with_torque;
  return {row("everything, the world's own rule ÷ plain loop", 1.3,
              against(our_world, splitting_loop, Scene::everything, count)),
          row("everything, cheapest stable rule ÷ plain loop", 1.3,
              against(our_cheapest, cayley_loop, Scene::everything, count)),
          row("points under gravity ÷ plain loop", 1.5,
              against(our_world, splitting_loop, points, count)),
          row("one tumbling body ÷ its functions called one by one", 1.2,
              against(our_one_by_one, bare_body, torqued, 1)),
          row("the same in packs", 1.2, against(our_world, bare_body, torqued, 1)),
          {"the slowest of a hundred steps ÷ median",
           ratio(pace_in_float.slowest_of_hundred, pace_in_float.median),
           ratio(pace_in_double.slowest_of_hundred, pace_in_double.median), 2}};
}

}  // namespace tumble::support::bench
