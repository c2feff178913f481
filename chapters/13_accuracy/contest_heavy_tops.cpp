#include "contests.hpp"

namespace tumble::support {
namespace {

template <class Real>
void contest_heavy_tops_in(Contest& contest) {
  for (const auto& [name, spin] : {std::pair("heavy top, slow", 3), {"heavy top, fast", 20}}) {
    const auto problem = heavy_top<Real>(name, spin);
    auto list = contestants<torque_ladder<Real, Weight<Real>>>(problem);
    append(list, heavy_tops_by_own_steps(problem));
    list.push_back(exact_contestant(problem));
    append_peers(list, problem, peers::Torque::weight, 1);
    measure_all(contest, problem, list, truth_of(problem));
  }
}

}  // namespace

void heavy_tops(Contest& contest) {
  contest_heavy_tops_in<float>(contest);
  contest_heavy_tops_in<double>(contest);
}

}  // namespace tumble::support
