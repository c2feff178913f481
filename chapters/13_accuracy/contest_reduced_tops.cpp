#include <support/own_steps.hpp>

#include "contests.hpp"

namespace tumble::support {

template <class Real>
std::vector<Contestant<Top<Real>>> reduced_free_tops(const FreeProblem<Real>& problem) {
  auto list = free_tops_by_own_steps(problem);
  append(list, contestants<even_momentum_ladder<Real>>(problem));
  return list;
}

template std::vector<Contestant<Topf>> reduced_free_tops(const FreeProblem<float>&);
template std::vector<Contestant<Topd>> reduced_free_tops(const FreeProblem<double>&);

}  // namespace tumble::support
