#include "contests.hpp"

namespace tumble::course {
namespace {

template <class Real>
void contest(std::vector<Measurement>& all, const Effort& effort) {
  for (const FreeProblem<Real>& problem : free_problems<Real>()) {
    auto list = contestants(problem, turning_ladder<Real>);
    list.push_back(exact_contestant(problem));
    append_peers(list, problem, peers::Torque::none, 0);
    measure_all(all, problem, list, truth_of(problem), effort);
  }
}

}  // namespace

std::vector<Measurement> free_tops(const Effort& effort) {
  std::vector<Measurement> all;
  contest<float>(all, effort);
  contest<double>(all, effort);
  return all;
}

}  // namespace tumble::course
