#include "contests.hpp"

namespace tumble::support {
namespace {

template <class Real>
void contest_free_tops_in(Contest& contest) {
  for (const FreeProblem<Real>& problem : free_problems<Real>()) {
    auto list = contestants<turning_ladder<Real>>(problem);
    append(list, reduced_free_tops(problem));
    list.push_back(exact_contestant(problem));
    append_peers(list, problem, peers::Torque::none, 0);
    measure_all(contest, problem, list, truth_of(problem));
  }
}

}  // namespace

void free_tops(Contest& contest) {
  contest_free_tops_in<float>(contest);
  contest_free_tops_in<double>(contest);
}

}  // namespace tumble::support
