#include "contests.hpp"
#include "with_odeint.hpp"

namespace tumble::course {
namespace {

template <class Real>
void contest(std::vector<Measurement>& all, const Effort& effort) {
  const auto on = [&]<class Gather, class Wide>(const Problem<Top<Real>, Gather>& problem,
                                                const Wide& wide_gather, peers::Torque torque,
                                                double parameter) {
    Problem<Top<long double>, Wide> wide{problem.name, exactly(problem.start), wide_gather,
                                         problem.seconds};
    const auto truth =
        contestant(wide, torque_ladder<long double, Wide>.back()).run(400 * problem.seconds);
    auto list = contestants(problem, torque_ladder<Real, Gather>);
    if constexpr (std::is_same_v<Real, double>) append(list, odeint_on(problem, torque, parameter));
    measure_all(all, problem, list, truth, effort);
  };
  on(heavy_top<Real>("heavy top, slow", 3), Weight<long double>{1}, peers::Torque::weight, 1);
  on(heavy_top<Real>("heavy top, fast", 20), Weight<long double>{1}, peers::Torque::weight, 1);
  on(driven_top<Real>(), Drive<long double>{}, peers::Torque::drive, 0);
}

}  // namespace

std::vector<Measurement> torqued_tops(const Effort& effort) {
  std::vector<Measurement> all;
  contest<float>(all, effort);
  contest<double>(all, effort);
  return all;
}

}  // namespace tumble::course
