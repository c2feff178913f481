#include <support/own_steps.hpp>

#include "contests.hpp"

namespace tumble::support {
namespace {

template <class Real>
void contest_moving_points_in(Contest& contest) {
  const auto on = [&]<class Forces>(const Problem<Particle<Real>, Forces>& problem,
                                    peers::Force force, const std::array<double, 2>& parameters) {
    auto list = contestants<motion_ladder<Real, Forces>>(problem);
    append(list, by_own_steps(problem));
    if (force != peers::Force::gravity_and_drag) list.push_back(nystrom_by_own_steps(problem));
    if constexpr (requires { problem.evaluate_forces.pull_energy(problem.start); })
      append(list, in_transformed_time(problem));
    list.push_back(exact_contestant(problem));
    append_peers(list, problem, force, parameters);
    measure_all(contest, problem, list, truth_of(problem));
  };
  on(spring<Real>("soft spring", 1, 20), peers::Force::spring, {1, 0});
  on(spring<Real>("stiff spring", 100, 2), peers::Force::spring, {10000, 0});
  on(eccentric_orbit<Real>(), peers::Force::star, {1, 0});
  const auto flight = projectile<Real>();
  on(flight, peers::Force::gravity_and_drag,
     {flight.evaluate_forces.weight, flight.evaluate_forces.drag_rate});
}

}  // namespace

void moving_points(Contest& contest) {
  contest_moving_points_in<float>(contest);
  contest_moving_points_in<double>(contest);
}

}  // namespace tumble::support
