/// @file
/// The turning methods that scene files can name: those of worlds, and the exact solution.
#pragma once

#include <limits>
#include <tumble/exact/free_top.hpp>
#include <tumble/turning_rungs.hpp>

namespace tumble::support {

/// Finds, in every step, the solution that goes through the present state. Its integrals know no
/// packs, so the bodies of a pack are turned one after another.
struct ExactSolution {
  static constexpr std::string_view name = "exact solution";
  static constexpr int order = std::numeric_limits<int>::max();  // no step is too long for it
  static constexpr bool is_symmetric = true;
  template <std::floating_point Real>
  void operator()(Top<Real>& top, Real time_step) const {
    top = exact::FreeTop<Real>(top).at(time_step);
  }
};
using SceneRules = Longer<RungsOfWorlds, ExactSolution>::Type;

}  // namespace tumble::support

#ifdef TUMBLE_COMPILED_RULES
#include <tumble/in_packs.hpp>
namespace tumble {
// They are compiled once, in scene_rules.cpp.
extern template void support::SceneRules::choose(World<float>&, std::size_t);
extern template void support::SceneRules::choose(World<double>&, std::size_t);
extern template void support::SceneRules::choose(ManyBodies<float>&, std::size_t);
extern template void support::SceneRules::choose(ManyBodies<double>&, std::size_t);
}  // namespace tumble
#endif
