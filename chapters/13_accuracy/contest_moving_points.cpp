#include "contests.hpp"
#include "with_odeint.hpp"

namespace tumble::course {
namespace {

template <class Real>
void contest(std::vector<Measurement>& all, const Effort& effort) {
  const auto on = [&]<class Gather, class Wide>(const Problem<Particle<Real>, Gather>& problem,
                                                const Wide& wide_gather, peers::Force force,
                                                const std::array<double, 2>& parameters) {
    Problem<Particle<long double>, Wide> wide{problem.name, exactly(problem.start), wide_gather,
                                              problem.seconds};
    const auto truth =
        contestant(wide, motion_ladder<long double, Wide>.back()).run(1000 * problem.seconds);
    auto list = contestants(problem, motion_ladder<Real, Gather>);
    if constexpr (std::is_same_v<Real, double>) append(list, odeint_on(problem, force, parameters));
    measure_all(all, problem, list, truth, effort);
  };
  on(spring<Real>("soft spring", 1, 20), SpringForce<long double>{1}, peers::Force::spring, {1, 0});
  on(spring<Real>("stiff spring", 100, 2), SpringForce<long double>{10000}, peers::Force::spring,
     {10000, 0});
  on(eccentric_orbit<Real>(), Star<long double>{1}, peers::Force::star, {1, 0});
  on(projectile<Real, GravityInAir<Real>>(), GravityInAir<long double>{Real(9.81), Real(0.5)},
     peers::Force::gravity_and_drag, {9.81, 0.5});
}

}  // namespace

std::vector<Measurement> moving_points(const Effort& effort) {
  std::vector<Measurement> all;
  contest<float>(all, effort);
  contest<double>(all, effort);
  return all;
}

}  // namespace tumble::course
