/// @file
/// The turning methods that scene files can name: those of worlds, and the exact solution.
#pragma once

#include <limits>
#include <tumble/exact/free_top.hpp>
#include <tumble/turning_rungs.hpp>

namespace tumble::course {

/// Finds, in every step, the solution that goes through the present state. Its integrals know no
/// packs, so the bodies of a pack are turned one after another.
//! [exact_rule]
struct ExactSolution {
  static constexpr std::string_view name = "exact solution";
  static constexpr int order = std::numeric_limits<int>::max();  // no step is too long for it
  static constexpr bool is_symmetric = true;
  template <std::floating_point Real>
  void operator()(Top<Real>& top, Real time_step) const {
    top = exact::FreeTop<Real>(top).at(time_step);
  }
};
//! [exact_rule]
using SceneRules = Longer<RungsOfWorlds, ExactSolution>::Type;

}  // namespace tumble::course

#ifdef TUMBLE_COMPILED_SCENES
#include <tumble/in_packs.hpp>
namespace tumble {
// They are compiled once, see chapters/13_accuracy/scene.
extern template void course::SceneRules::choose(World<float>&, std::size_t);
extern template void course::SceneRules::choose(World<double>&, std::size_t);
extern template void course::SceneRules::choose(ManyBodies<float>&, std::size_t);
extern template void course::SceneRules::choose(ManyBodies<double>&, std::size_t);
}  // namespace tumble
#endif
