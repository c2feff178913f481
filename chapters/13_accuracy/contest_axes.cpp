#include <support/own_steps.hpp>

#include "contests.hpp"

namespace tumble::support {

template <class Real>
std::vector<Contestant<Top<Real>>> heavy_tops_by_own_steps(
    const Problem<Top<Real>, Weight<Real>>& problem) {
  auto list = by_own_steps(problem);
  append(list, axis_by_even_steps(problem));
  return list;
}

template std::vector<Contestant<Topf>> heavy_tops_by_own_steps(const Problem<Topf, Weight<float>>&);
template std::vector<Contestant<Topd>> heavy_tops_by_own_steps(
    const Problem<Topd, Weight<double>>&);

}  // namespace tumble::support
