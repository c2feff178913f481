/// @file
/// The contests of accuracy_demo, in files of their own, so that they compile side by side and no
/// compiler needs more than a gigabyte.
#pragma once

#include "with_peers.hpp"

namespace tumble::support {

/// What is wanted of the contests, and what came of it.
struct Contest {
  Effort effort;
  std::string wanted;                      ///< the problem that is measured; without it none is
  std::vector<std::string> problems = {};  ///< all that there are
  std::vector<Measurement> measured = {};
};

void free_tops(Contest& contest);
void heavy_tops(Contest& contest);
void driven_tops(Contest& contest);
void moving_points(Contest& contest);

/// A free top by the rungs that keep L apart from the orientation.
template <class Real>
std::vector<Contestant<Top<Real>>> reduced_free_tops(const FreeProblem<Real>& problem);

/// A heavy top by the rungs that choose their own steps, and by those that keep its axis apart.
template <class Real>
std::vector<Contestant<Top<Real>>> heavy_tops_by_own_steps(
    const Problem<Top<Real>, Weight<Real>>& problem);

/// What a body measured with one precision goes through: its rungs, the exact solution, the peers.
template <class Body, class Forces, class Truth>
void measure_all(Contest& contest, const Problem<Body, Forces>& problem,
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

}  // namespace tumble::support
