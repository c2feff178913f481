/// @file
/// The rules of the chapter in one list, and what each makes of a top.
#pragma once

#include <support/exactly.hpp>
#include <support/tumbling_problems.hpp>
#include <tumble/exact/free_top.hpp>
#include <tumble/tumbling.hpp>
#include <utility>

namespace tumble::support {

template <class Real>
struct Rule {
  const char* name;
  void (*turn)(Top<Real>&, Same<Real>);
};

template <class Real>
constexpr std::array<Rule<Real>, 7> rules = {
    {{"steady: no gyroscopic term", turn_steadily<Real>},
     {"explicit", turn_explicitly<Real>},
     {"explicit, |L| restored", turn_restoring_momentum<Real>},
     {"implicit, one Newton step", turn_implicitly<Real>},
     {"momentum-carrying", turn_carrying_momentum<Real>},
     {"splitting by axes", turn_axis_by_axis<Real>},
     {"splitting with a sphere", turn_by_splitting<Real>}}};

/// What a run of a rule showed: largest relative errors of energy and world angular momentum (the
/// length of the vector of difference), the energy at the end against that at the start, the angle
/// from the exact orientation (rad), and the first step after which the energy had grown a
/// thousandfold or was no number, or 0.
struct Motion {
  double energy_error = 0, momentum_error = 0, energy_ratio = 1, angle = 0;
  int diverged = 0;
};

/// Runs `turn` on a top and watches it. Energy and momentum are formed in long double, so that the
/// observer's rounding is not seen.
template <class Real, class Turn>
Motion watched(Top<Real> top, const Turn& turn, int steps, int steps_to_angle, Real time_step) {
  const Top<long double> start = exactly(top);
  const long double energy = kinetic_energy(start);
  const Vec3<long double> L = angular_momentum_world(start);
  Motion motion;
  for (int n = 1; n <= steps; ++n) {
    turn(top, time_step);
    const Top<long double> now = exactly(top);
    const long double ratio = kinetic_energy(now) / energy;
    if (!(ratio < 1000)) {
      motion.diverged = n;
      return motion;
    }
    motion.energy_ratio = static_cast<double>(ratio);
    motion.energy_error = std::max(motion.energy_error, std::abs(static_cast<double>(ratio - 1)));
    const long double off = (angular_momentum_world(now) - L).norm() / L.norm();
    motion.momentum_error = std::max(motion.momentum_error, static_cast<double>(off));
    if (n == steps_to_angle) {
      const auto there =
          exact::FreeTop<long double>(start).at(static_cast<long double>(time_step) * n);
      motion.angle = static_cast<double>(angle_between(there.orientation, now.orientation));
    }
  }
  return motion;
}

template <class Real, class Turn>
Motion watched(const TumblingProblem& problem, const Turn& turn) {
  return watched(top_of<Real>(problem), turn, 60 * problem.seconds, 60 * problem.seconds_to_angle,
                 Real(1) / 60);
}

}  // namespace tumble::support
