#include "contests.hpp"

namespace tumble::course {
namespace {

template <class Real>
void contest_moving_points_in(std::vector<Measurement>& all, const Effort& effort) {
  const auto on = [&]<class Gather>(const Problem<Particle<Real>, Gather>& problem,
                                    peers::Force force, const std::array<double, 2>& parameters) {
    auto list = contestants(problem, motion_ladder<Real, Gather>);
    list.push_back(exact_contestant(problem));
    append_peers(list, problem, force, parameters);
    measure_all(all, problem, list, truth_of(problem), effort);
  };
  on(spring<Real>("soft spring", 1, 20), peers::Force::spring, {1, 0});
  on(spring<Real>("stiff spring", 100, 2), peers::Force::spring, {10000, 0});
  on(eccentric_orbit<Real>(), peers::Force::star, {1, 0});
  const auto flight = projectile<Real>();
  on(flight, peers::Force::gravity_and_drag, {flight.gather.gravity, flight.gather.drag_rate});
}

}  // namespace

std::vector<Measurement> moving_points(const Effort& effort) {
  std::vector<Measurement> all;
  contest_moving_points_in<float>(all, effort);
  contest_moving_points_in<double>(all, effort);
  return all;
}

}  // namespace tumble::course
