#include <support/own_steps.hpp>

#include "contests.hpp"

namespace tumble::support {
namespace {

/// Nobody has solved this one: its truth is the highest rung in long double, with steps so short
/// that they no longer matter.
template <class Real>
void contest_driven_top_in(Contest& contest) {
  const auto problem = driven_top<Real>();
  using Wide = Drive<long double>;
  const Problem<Top<long double>, Wide> wide{
      problem.name, exactly(problem.start), {}, problem.seconds};
  const auto truth = after_steps<HighestRung<torque_ladder<long double, Wide>>>(wide, 2000);
  auto list = contestants<torque_ladder<Real, Drive<Real>>>(problem);
  append(list, by_own_steps(problem));
  append_peers(list, problem, peers::Torque::drive, 0);
  measure_all(contest, problem, list, truth);
}

}  // namespace

void driven_tops(Contest& contest) {
  contest_driven_top_in<float>(contest);
  contest_driven_top_in<double>(contest);
}

}  // namespace tumble::support
