/// @file
/// ManyBodies, compiled once for all checks and programs of the course: see many_bodies.cpp and
/// tumble_compile_once in cmake/TumbleCourse.cmake. Users have the headers alone.
#pragma once

#include <tumble/turning_methods.hpp>

// NOLINTBEGIN(bugprone-macro-parentheses): a kind of declaration and a type can stand in none
#define TUMBLE_MANY_BODIES(how, Real)                                             \
  how template class Schedule<Real, natural_width<Real>>;                         \
  how template struct PackedState<Real, natural_width<Real>>;                     \
  how template std::vector<EffectInstance<Real>> motions_of<Real, InPacks<Real>>( \
      const Splitting&);                                                          \
  how template class InPacks<Real>;                                               \
  how template class World<Real, InPacks<Real>>;                                  \
  how template void FirstTurningRules::choose(World<Real, InPacks<Real>>&, std::size_t);
// NOLINTEND(bugprone-macro-parentheses)

namespace tumble {
TUMBLE_MANY_BODIES(extern, float)
TUMBLE_MANY_BODIES(extern, double)
}  // namespace tumble
