#include <tumble/exact/free_top.hpp>

#include "contests.hpp"
#include "with_odeint.hpp"

namespace tumble::course {
namespace {

template <class Real>
void contest(std::vector<Measurement>& all, const Effort& effort) {
  for (const FreeProblem<Real>& problem : free_problems<Real>()) {
    const auto truth = exact::FreeTop(exactly(problem.start)).at(problem.seconds);
    auto list = contestants(problem, turning_ladder<Real>);
    list.push_back({"exact", "exact", false, [problem](double) {
                      return exact::FreeTop(problem.start).at(static_cast<Real>(problem.seconds));
                    }});
    if constexpr (std::is_same_v<Real, double>)
      append(list, odeint_on(problem, peers::Torque::none, 0));
    measure_all(all, problem, list, truth, effort);
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
