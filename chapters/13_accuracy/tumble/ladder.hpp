/// @file
/// The ladder: every method, what it is called, its order and what it claims to keep.
#pragma once

#include <array>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tumble/augmented.hpp>
#include <tumble/compositions.hpp>
#include <tumble/kicked_steps.hpp>
#include <tumble/lie_runge_kutta.hpp>
#include <tumble/linearly_implicit.hpp>
#include <tumble/midpoint.hpp>
#include <tumble/runge_kutta.hpp>

namespace tumble {

/// What a method says of itself. Each claim holds but for rounding, and is checked.
//! [claims]
struct Claims {
  int order = 0;          ///< the error falls as the time step to this power; 0: not at all
  bool energy = false;    ///< a free top's energy is kept
  bool momentum = false;  ///< a free top's angular momentum is kept in the world
  bool reverses = false;  ///< with L turned around, it retraces its steps
  bool bounded = false;   ///< however long the step, a free top stays finite, as long as no turn
                          ///< goes beyond SineCosineConstants::limit and |L|² is in Real's range
};
//! [claims]

/// A method for tops without torque. It may ask that the top is_gyroscopic().
//! [turning_rung]
template <class Real>
struct TurningRung {
  std::string_view name;
  Claims claims;
  void (*turn)(Top<Real>& top, Same<Real> time_step);
};
//! [turning_rung]

/// The rungs for a free top, chapter 8's among them, from the lowest order up.
template <class Real>
constexpr std::array<TurningRung<Real>, 21> turning_ladder = {{
    {"steady", {0, true, false, true, true}, turn_steadily},
    {"explicit", {1, false, false, false, false}, turn_explicitly},
    {"explicit, |L| restored", {1, false, false, false, true}, turn_restoring_momentum},
    {"implicit, one Newton step", {1, false, false, false, false}, turn_implicitly},
    {"linearly implicit", {1, false, false, false, true}, turn_linearly_implicitly},
    {"momentum-carrying", {1, false, true, false, true}, turn_carrying_momentum},
    {"implicit midpoint", {2, true, true, true, false}, turn_by_implicit_midpoint},
    {"Lie midpoint", {2, false, true, true, false}, turn_by_lie_midpoint},
    {"augmented second order", {2, false, true, false, false}, turn_by_augmented_rule},
    {"splitting by axes", {2, false, true, true, true}, turn_axis_by_axis},
    {"splitting", {2, false, true, true, true}, turn_by_splitting},
    {"Runge-Kutta", {4, false, false, false, false}, turn_by_runge_kutta<Kutta>},
    {"Lie Runge-Kutta", {4, false, true, false, false}, turn_by_lie_runge_kutta},
    {"splitting, Suzuki", {4, false, true, true, true}, turn_by_row<Suzuki>},
    {"splitting, Blanes-Moan 4", {4, false, true, true, true}, turn_by_row<BlanesMoanFourth>},
    {"Dormand-Prince 5", {5, false, false, false, false}, turn_by_runge_kutta<DormandPrinceFifth>},
    {"splitting, Yoshida", {6, false, true, true, true}, turn_by_row<Yoshida>},
    {"splitting, Blanes-Moan 6", {6, false, true, true, true}, turn_by_row<BlanesMoanSixth>},
    {"Dormand-Prince 8", {8, false, false, false, false}, turn_by_runge_kutta<DormandPrinceEighth>},
    {"splitting, Kahan-Li 8", {8, false, true, true, true}, turn_by_row<KahanLiEighth>},
    {"splitting, Sofroniou-Spaletta",
     {10, false, true, true, true},
     turn_by_row<SofroniouSpaletta>},
}};

/// The rung of that name.
/// @throws std::invalid_argument if there is none; the sentence lists the names.
template <class Real>
const TurningRung<Real>& turning_rung(std::string_view name) {
  std::string names;
  for (const TurningRung<Real>& rung : turning_ladder<Real>) {
    if (rung.name == name) return rung;
    names.append(names.empty() ? "" : "; ").append(rung.name);
  }
  throw std::invalid_argument("no rung is called '" + std::string(name) + "'; they are: " + names);
}

/// A method for a top under torque, or for a particle under force. `evaluate_forces` as in
/// kicked_steps.hpp.
template <class Body, class Real, class Forces>
struct Rung {
  std::string_view name;
  Claims claims;
  void (*step)(Body& body, const Forces& evaluate_forces, Real time, Real time_step);
};

/// The rungs for the motion of a centre of mass, where force depends on time and place.
template <class Real, class Forces>
constexpr std::array<Rung<Particle<Real>, Real, Forces>, 11> motion_ladder = {{
    {"explicit Euler", {.order = 1}, step_explicitly},
    {"kick and drift", {.order = 1}, step_by_kick_and_drift},
    {"Verlet", {.order = 2, .reverses = true}, step_by_row<Verlet>},
    {"Runge-Kutta", {.order = 4}, step_by_runge_kutta<Kutta>},
    {"Suzuki", {.order = 4, .reverses = true}, step_by_row<Suzuki>},
    {"Dormand-Prince 5", {.order = 5}, step_by_runge_kutta<DormandPrinceFifth>},
    {"Kahan-Li 6", {.order = 6, .reverses = true}, step_by_row<KahanLiSixth>},
    {"Blanes-Moan-Nystrom", {.order = 6, .reverses = true}, step_by_row<BlanesMoanNystrom>},
    {"Dormand-Prince 8", {.order = 8}, step_by_runge_kutta<DormandPrinceEighth>},
    {"Kahan-Li 8", {.order = 8, .reverses = true}, step_by_row<KahanLiEighth>},
    {"Sofroniou-Spaletta", {.order = 10, .reverses = true}, step_by_row<SofroniouSpaletta>},
}};

/// The rungs for a top under torque that depends on time and orientation.
template <class Real, class Forces>
constexpr std::array<Rung<Top<Real>, Real, Forces>, 11> torque_ladder = {{
    {"kick and drift", {.order = 1}, step_by_kick_and_drift},
    {"kicked splitting", {.order = 2, .reverses = true}, step_by_row<Verlet>},
    {"Runge-Kutta", {.order = 4}, step_by_runge_kutta<Kutta>},
    {"Lie Runge-Kutta", {.order = 4}, turn_by_lie_runge_kutta},
    {"kicked splitting, Suzuki", {.order = 4, .reverses = true}, step_by_row<Suzuki>},
    {"Dormand-Prince 5", {.order = 5}, step_by_runge_kutta<DormandPrinceFifth>},
    {"kicked splitting, Kahan-Li 6", {.order = 6, .reverses = true}, step_by_row<KahanLiSixth>},
    {"Dormand-Prince 8", {.order = 8}, step_by_runge_kutta<DormandPrinceEighth>},
    {"Fehlberg 8", {.order = 8}, step_by_runge_kutta<FehlbergEighth>},
    {"kicked splitting, Kahan-Li 8", {.order = 8, .reverses = true}, step_by_row<KahanLiEighth>},
    {"kicked splitting, Sofroniou-Spaletta",
     {.order = 10, .reverses = true},
     step_by_row<SofroniouSpaletta>},
}};

}  // namespace tumble
