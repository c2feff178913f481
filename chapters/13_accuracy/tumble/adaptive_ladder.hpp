/// @file
/// The ladder's rungs that choose their own steps: what each is called, its order and what it
/// claims to keep.
///
/// Their Claims mean what those of the other rungs mean, with the mean step (the time divided by
/// the number of steps) for the time step. Each integration cuts its last step to end on time, so
/// none retraces its steps.
#pragma once

#include <tumble/ladder.hpp>
#include <tumble/nystrom_steps.hpp>
#include <tumble/paced_steps.hpp>
#include <tumble/reduced_steps.hpp>

namespace tumble {

/// What a method that chooses its steps is given.
enum class Given {
  tolerance,  ///< rad that may be lost in a second, and as large a part of |L|
  angle       ///< rad that a top shall turn by in a step
};

/// A method that takes a top without torque through some seconds. With what it is `given` to the
/// power 1/`power` its steps get shorter.
//! [free_top_rung]
template <class Real>
struct FreeTopRung {
  std::string_view name;
  Given given;
  int power;
  Claims claims;
  StepCounts (*integrate)(Top<Real>& top, Same<Real> seconds, Same<Real> given);
};
//! [free_top_rung]

/// A pair on all seven numbers of a top without torque.
template <class Pair, class Real>
StepCounts integrate_without_torque(Top<Real>& top, Same<Real> seconds, Same<Real> tolerance) {
  const auto nothing = [](Top<Real>& there, Real) { there.torque.setZero(); };
  return integrate<Pair>(top, nothing, Real(0), seconds, tolerance);
}

/// A splitting in the portions of a row, whose steps follow the pace of a top without torque: one
/// that turns never comes to rest, and one at rest stays there.
template <class Row, class Real>
StepCounts integrate_paced_without_torque(Top<Real>& top, Same<Real> seconds, Same<Real> angle) {
  const auto nothing = [](Top<Real>& there, Real) { there.torque.setZero(); };
  const Real least = top.angular_momentum_body.isZero(0) ? 1 : 0;  // at rest any pace will do
  return integrate_paced<Row>(top, nothing, Real(0), seconds, angle, least);
}

/// Those for a free top.
//! [free_top_rungs]
template <class Real>
constexpr std::array<FreeTopRung<Real>, 7> free_top_rungs = {{
    {"5(4), own steps",
     Given::tolerance,
     4,
     {.order = 5},
     integrate_without_torque<DormandPrince54>},
    {"8(5,3), own steps",
     Given::tolerance,
     7,
     {.order = 8},
     integrate_without_torque<DormandPrince853>},
    {"L apart, 5(4), own steps",
     Given::tolerance,
     4,
     {.order = 5, .momentum = true},
     integrate_free_top<DormandPrince54>},
    {"L apart, 8(5,3), own steps",
     Given::tolerance,
     7,
     {.order = 8, .momentum = true},
     integrate_free_top<DormandPrince853>},
    {"splitting, own steps",
     Given::angle,
     1,
     {.order = 2, .momentum = true},
     integrate_paced_without_torque<Verlet>},
    {"splitting, Suzuki, own steps",
     Given::angle,
     1,
     {.order = 4, .momentum = true},
     integrate_paced_without_torque<Suzuki>},
    {"splitting, Kahan-Li 8, own steps",
     Given::angle,
     1,
     {.order = 8, .momentum = true},
     integrate_paced_without_torque<KahanLiEighth>},
}};
//! [free_top_rungs]

/// A method that takes a particle under force, or a top under torque, from `time` through
/// `seconds`. `evaluate_forces` as in kicked_steps.hpp; `tolerance` and `stops` as in integrate().
template <class Body, class Real, class Forces>
struct AdaptiveRung {
  std::string_view name;
  Claims claims;
  StepCounts (*integrate)(Body& body, const Forces& evaluate_forces, Real time, Same<Real> seconds,
                          ToleranceOf<Body> tolerance, const Stops<Same<Real>>& stops);
};

/// Those for a body under any force or torque.
template <class Body, class Real, class Forces>
constexpr std::array<AdaptiveRung<Body, Real, Forces>, 2> adaptive_rungs = {{
    {"5(4), own steps", {.order = 5}, integrate<DormandPrince54>},
    {"8(5,3), own steps", {.order = 8}, integrate<DormandPrince853>},
}};

/// That for a particle where the force depends on time and place alone.
template <class Real, class Forces>
constexpr AdaptiveRung<Particle<Real>, Real, Forces> nystrom_rung = {
    "Nystrom 8(6), own steps", {.order = 8}, integrate_by_nystrom<DormandPrinceNystrom86>};

/// Those for a symmetric top whose torque depends on time and on where its axis points.
template <class Real, class Forces>
constexpr std::array<AdaptiveRung<Top<Real>, Real, Forces>, 2> axis_rungs = {{
    {"axis apart, 5(4), own steps", {.order = 5}, integrate_axis<DormandPrince54>},
    {"axis apart, 8(5,3), own steps", {.order = 8}, integrate_axis<DormandPrince853>},
}};

}  // namespace tumble
