/// @file
/// The substeps of a step: when it kicks, and when it drifts.
#pragma once

#include <array>
#include <cmath>
#include <string_view>
#include <tumble/terms.hpp>
#include <vector>

namespace tumble {

/// By which scheme a world steps all its bodies.
//! [scheme]
enum class Scheme {
  semi_implicit_euler,  ///< a kick, then a drift: chapter 6. Order 1
  verlet,               ///< half a drift, a kick, half a drift. Order 2
  suzuki  ///< five of Verlet's steps, the middle one backwards: Suzuki (1990). Order 4
};
//! [scheme]

inline constexpr std::array<std::string_view, 3> scheme_names = {"semi-implicit Euler", "Verlet",
                                                                 "Suzuki"};
/// As plans and tables call it.
inline std::string_view name_of(Scheme scheme) {
  return scheme_names[static_cast<std::size_t>(scheme)];
}

/// The power of the time step with which the error of a scheme falls, where nothing limits it.
inline int order_of(Scheme scheme) {
  return scheme == Scheme::semi_implicit_euler ? 1 : scheme == Scheme::verlet ? 2 : 4;
}

/// What a substep is: a kick; a drift; `whole`, in which blows and damping act once for the whole
/// step; or `end`, when the step's time has passed.
enum class SubstepKind { kick, whole, drift, end };

/// A part of a step; its times are parts of the whole step.
template <class Real>
struct Substep {
  SubstepKind kind;  ///< which of the four
  Real begins;       ///< of a kick or a drift: where the drifts before it have led to; else 0
  Real lasts;        ///< negative: backwards
};

/// When a substep happens.
template <class Real>
StepTime<Real> step_time_of(const Substep<Real>& substep, const StepTime<Real>& step) {
  return {step.time + substep.begins * step.time_step, substep.lasts * step.time_step};
}

/// Suzuki's p = 1/(4 − ∛4): since p³ + p³ + (1 − 4p)³ + p³ + p³ = 0, the errors of third order of
/// five steps that last p, p, 1 − 4p, p and p cancel.
inline constexpr long double suzuki_length = 0.41449077179437573714L;

/// The substeps of a scheme's step, in their order. Blows and damping, which are given for whole
/// steps, come once, before the last drift. What acts at the end comes once as well, after it.
//! [substeps_of]
template <class Real>
std::vector<Substep<Real>> substeps_of(Scheme scheme) {
  std::vector<Substep<Real>> substeps;
  double elapsed = 0;
  const auto add = [&](SubstepKind kind, double lasts) {
    substeps.push_back({kind, static_cast<Real>(elapsed), static_cast<Real>(lasts)});
    if (kind == SubstepKind::drift) elapsed += lasts;
  };
  if (scheme == Scheme::semi_implicit_euler) {
    add(SubstepKind::kick, 1);
    add(SubstepKind::drift, 1);
  } else {
    constexpr auto p = static_cast<double>(suzuki_length);
    const std::vector<double> lengths =
        scheme == Scheme::verlet ? std::vector{1.0} : std::vector{p, p, 1 - 4 * p, p, p};
    for (const double length : lengths) {
      add(SubstepKind::drift, length / 2);
      add(SubstepKind::kick, length);
      add(SubstepKind::drift, length / 2);
    }
  }
  substeps.insert(substeps.end() - 1, {SubstepKind::whole, 0, 1});
  substeps.push_back({SubstepKind::end, 0, 1});
  return substeps;
}
//! [substeps_of]

/// How far (rad) a swing without damping may come in a step, w h, while a scheme keeps it from
/// growing without bound.
///
/// Verlet's bound is Euler's. With D for half a drift and K for a kick, read from left to right, n
/// steps of Verlet's are (D K D)ⁿ = D (K D D)ⁿ D⁻¹, and K D D is Euler's step: the one grows if the
/// other does. Suzuki's is found by trial, at each hundredth. A step of it is a matrix of
/// determinant 1 that turns the position x and h v into the next ones, and these stay bounded if
/// its trace lies between −2 and 2.
inline double largest_stable_angle(Scheme scheme) {
  if (scheme != Scheme::suzuki) return 2;
  const auto substeps = substeps_of<double>(scheme);
  const auto trace = [&](double angle) {
    std::array<std::array<double, 2>, 2> columns = {{{1, 0}, {0, 1}}};  // x and h v, from 1 and 0
    for (const Substep<double>& substep : substeps)
      for (auto& [x, hv] : columns)
        if (substep.kind == SubstepKind::kick)
          hv -= substep.lasts * angle * angle * x;
        else if (substep.kind == SubstepKind::drift)
          x += substep.lasts * hv;
    return columns[0][0] + columns[1][1];
  };
  int n = 0;
  while (std::abs(trace(0.01 * (n + 1))) < 2) ++n;
  return 0.01 * n;
}

}  // namespace tumble
