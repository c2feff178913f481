/// @file
/// Boxes to turn by every rung that a scene can name.
#pragma once

#include <support/random_world.hpp>
#include <tumble/turning_methods.hpp>

namespace tumble::support {

/// The rungs of a scene before this one are chapter 8's.
constexpr std::size_t first_rung = FirstTurningRules::names.size();

/// Boxes of many shapes that spin each about an axis of its own, some of them symmetric.
template <class AnyWorld>
void add_boxes(AnyWorld& world, int count) {
  using Real = std::decay_t<decltype(world.time_step())>;
  RandomGenerator dice(13);
  for (int n = 0; n < count; ++n) {
    Vec3<Real> edges = Vec3<Real>(2, 2, 2) + dice.vector<Real>();
    if (n % 5 == 0) edges.y() = edges.x();
    const std::string name = "box " + std::to_string(n);
    world.add(name, make_rigid_body<Real>(name, mass_properties(Box<Real>{edges}, 2), {},
                                          Vec3<Real>::Zero(), 5 * dice.vector<Real>())
                        .body);
  }
}

}  // namespace tumble::support
