/// @file
/// World, compiled once for all checks and programs of the course: see worlds.cpp and
/// tumble_compile_once in cmake/TumbleCourse.cmake. Users have the headers alone.
#pragma once

// NOLINTBEGIN(bugprone-macro-parentheses): a kind of declaration and a type can stand in none
#define TUMBLE_WORLD(how, Real)                                                                   \
  how template class Planner<Real>;                                                               \
  how template class UndoBuffer<Real>;                                                            \
  how template class Checkpoints<Real>;                                                           \
  how template class Replay<Real>;                                                                \
  how template class OneByOne<Real>;                                                              \
  how template std::vector<EffectInstance<Real>> motions_of<Real, OneByOne<Real>>(                \
      const Splitting&);                                                                          \
  how template class World<Real>;                                                                 \
  how template void check_body(const std::string&, const Particle<Real>&);                        \
  how template void check_body(const std::string&, const Top<Real>&);                             \
  how template void ChangeLog::tell(const StepPlan<Real>&, std::size_t, std::int64_t);            \
  how template Snapshot<Real> snapshot_of(const NamedBodies<Real>&, const Planner<Real>&,         \
                                          const WorldTime<Real>&);                                \
  how template void restore(const Snapshot<Real>&, const NamedBodies<Real>&, BodyStore<Real>&,    \
                            Planner<Real>&);                                                      \
  how template StepLimit<Real> step_limit(const StepPlan<Real>&, const NamedBodies<Real>&, Real); \
  how template std::vector<std::string> warnings(const StepPlan<Real>&, const NamedBodies<Real>&, \
                                                 const StepTime<Real>&);                          \
  how template std::vector<PlanRow> rows_of(const Planner<Real>&, const NamedBodies<Real>&);      \
  how template SimulationError failure(const std::string&, BodyIndex, const Bodies<Real>&,        \
                                       const StepPlan<Real>&, std::int64_t,                       \
                                       const StepTime<Real>&);
// NOLINTEND(bugprone-macro-parentheses)

namespace tumble {
TUMBLE_WORLD(extern, float)
TUMBLE_WORLD(extern, double)
}  // namespace tumble
