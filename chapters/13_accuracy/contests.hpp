/// @file
/// The contests of accuracy_demo, one file each, so that they compile side by side.
#pragma once

#include "with_peers.hpp"

namespace tumble::course {

/// What is wanted of the contests, and what came of it.
struct Contest {
  Effort effort;
  std::string wanted;                      ///< the problem that is measured; without it none is
  std::vector<std::string> problems = {};  ///< all that there are
  std::vector<Measurement> measured = {};
};

void free_tops(Contest& contest);
void torqued_tops(Contest& contest);
void moving_points(Contest& contest);

/// What a body measured with one precision goes through: its rungs, the exact solution, the peers.
template <class Body, class Gather, class Truth>
void measure_all(Contest& contest, const Problem<Body, Gather>& problem,
                 const std::vector<Contestant<Body>>& contestants, const Truth& truth) {
  auto& names = contest.problems;
  if (std::find(names.begin(), names.end(), problem.name) == names.end())
    names.push_back(problem.name);
  if (problem.name != contest.wanted) return;
  const bool single = sizeof(typename ScalarOf<Body>::Type) == sizeof(float);
  for (const Contestant<Body>& contestant : contestants)
    for (Measurement& one :
         measured(problem, single ? "float" : "double", contestant, truth, contest.effort))
      contest.measured.push_back(std::move(one));
}

template <class List>
void append(List& list, const List& more) {
  list.insert(list.end(), more.begin(), more.end());
}

}  // namespace tumble::course
