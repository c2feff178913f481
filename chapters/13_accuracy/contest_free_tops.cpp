#include "contests.hpp"
#include "with_odeint.hpp"

namespace tumble::course {
namespace {

template <class Real>
void contest(std::vector<Measurement>& all, const Effort& effort) {
  for (const FreeProblem<Real>& problem : free_problems<Real>()) {
    Top<long double> truth = exactly(problem.start);
    truth.orientation = FreeTop(truth).orientation(static_cast<long double>(problem.seconds));
    auto list = contestants(problem, turning_ladder<Real>);
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
