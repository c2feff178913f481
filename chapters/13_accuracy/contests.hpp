/// @file
/// The contests of accuracy_demo, one file each, so that they compile side by side.
#pragma once

#include "with_peers.hpp"

namespace tumble::course {

std::vector<Measurement> free_tops(const Effort& effort);
std::vector<Measurement> torqued_tops(const Effort& effort);
std::vector<Measurement> moving_points(const Effort& effort);

/// What a body measured with one precision goes through: its rungs, the exact solution, the peers.
template <class Body, class Gather, class Truth>
void measure_all(std::vector<Measurement>& all, const Problem<Body, Gather>& problem,
                 const std::vector<Contestant<Body>>& contestants, const Truth& truth,
                 const Effort& effort) {
  const bool single = sizeof(typename ScalarOf<Body>::Type) == sizeof(float);
  for (const Contestant<Body>& contestant : contestants)
    for (Measurement& one :
         measured(problem, single ? "float" : "double", contestant, truth, effort))
      all.push_back(std::move(one));
}

template <class List>
void append(List& list, const List& more) {
  list.insert(list.end(), more.begin(), more.end());
}

}  // namespace tumble::course
