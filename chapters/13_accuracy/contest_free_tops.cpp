#include "contests.hpp"

namespace tumble::course {
namespace {

template <class Real>
void contest_free_tops_in(std::vector<Measurement>& all, const Effort& effort) {
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
  contest_free_tops_in<float>(all, effort);
  contest_free_tops_in<double>(all, effort);
  return all;
}

}  // namespace tumble::course
