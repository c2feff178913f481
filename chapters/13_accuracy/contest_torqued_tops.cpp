#include <course/own_steps.hpp>

#include "contests.hpp"

namespace tumble::course {
namespace {

template <class Real>
void contest_torqued_tops_in(Contest& contest) {
  for (const auto& [name, spin] : {std::pair("heavy top, slow", 3), {"heavy top, fast", 20}}) {
    const auto problem = heavy_top<Real>(name, spin);
    auto list = contestants<torque_ladder<Real, Weight<Real>>>(problem);
    append(list, by_own_steps(problem));
    append(list, axis_by_even_steps(problem));
    list.push_back(exact_contestant(problem));
    append_peers(list, problem, peers::Torque::weight, 1);
    measure_all(contest, problem, list, truth_of(problem));
  }
  // Nobody has solved this one: its truth is the highest rung in long double, with steps so short
  // that they no longer matter.
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

void torqued_tops(Contest& contest) {
  contest_torqued_tops_in<float>(contest);
  contest_torqued_tops_in<double>(contest);
}

}  // namespace tumble::course
