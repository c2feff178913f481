/// @file
/// What a page that runs a scene by itself can bear.
#pragma once

#include <support/usage_error.hpp>
#include <tumble/scene/scene.hpp>

namespace tumble::simulate {

/// More bodies than this take a page longer to draw than a reader waits.
constexpr std::size_t most_drawn_bodies = 2000;

/// @throws UsageError if the scene has more bodies than a page draws.
template <class Real, class Backend>
void require_drawable(const Scene<Real, Backend>& scene) {
  const std::size_t bodies = scene.world.body_count();
  if (bodies > most_drawn_bodies)
    throw support::UsageError("the scene has " + std::to_string(bodies) +
                              " bodies; a page that runs it by itself draws at most " +
                              std::to_string(most_drawn_bodies));
}

}  // namespace tumble::simulate
