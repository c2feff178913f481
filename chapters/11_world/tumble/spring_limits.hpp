/// @file
/// Up to which time step the stretches of a scene's springs can't feed on themselves.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <tumble/semi_implicit_euler.hpp>
#include <tumble/work.hpp>
#include <vector>

namespace tumble {

/// How easily a force at distance `arm` (m) from the centre of mass moves the point that it acts
/// at, at most: 1/m + arm²/I with the smallest moment, 1/kg.
template <class Real>
Real largest_inverse_mass_at(const RigidBody<Real>& body, Real arm) {
  return body.centre.inverse_mass + arm * arm * body.top.inverse_moments.maxCoeff();
}

/// How far (rad) a swing without damping may come in a step, w h, while a scheme keeps it from
/// growing without bound.
///
/// Verlet's bound is Euler's. With D for half a drift and K for a kick, read from left to right, n
/// steps of Verlet's are (D K D)ⁿ = D (K D D)ⁿ D⁻¹, and K D D is Euler's step: the one grows if the
/// other does. Suzuki's is found by trial, at each hundredth. A step of it is a matrix of
/// determinant 1 that turns the position x and h v into the next ones, and these stay bounded if
/// its trace lies between −2 and 2.
//! [largest_stable_angle]
inline double largest_stable_angle(Scheme scheme) {
  if (scheme != Scheme::suzuki) return 2;
  const auto portions = portions_of<double>(scheme);
  const auto trace = [&](double angle) {
    std::array<std::array<double, 2>, 2> columns = {{{1, 0}, {0, 1}}};  // x and h v, from 1 and 0
    for (const Portion<double>& portion : portions)
      for (auto& [x, hv] : columns)
        if (portion.stroke == Stroke::kick)
          hv -= portion.lasts * angle * angle * x;
        else if (portion.stroke == Stroke::drift)
          x += portion.lasts * hv;
    return columns[0][0] + columns[1][1];
  };
  int n = 0;
  while (std::abs(trace(0.01 * (n + 1))) < 2) ++n;
  return 0.01 * n;
}
//! [largest_stable_angle]

/// The time step (s) up to which no small stretches of springs can grow, and the spring (its place
/// in `entries`) that limits it; infinite without springs. A spring under tension also resists
/// being turned aside, with the tension times its arm: that is left out, and can need a shorter
/// step.
///
/// Springs that share a body stiffen each other. By chapter 6's limit nothing grows while the
/// springs, each of the strength s = h² k + 2 h c, pull back by less than 4 in every direction of
/// motion, in units of the inverse mass. The strongest pull is the largest Σ |Σ √s b x|², summed
/// over the bodies, where b is what a spring does to the body at its end, √w long at most with the
/// inverse mass w there, and the squares of the x, one for each spring, sum to 1. By Cauchy and
/// Schwarz |Σ √s b x|² ≤ Σ √s · Σ √s w x². So no pull exceeds the largest √s (w_a Σ_a √s + w_b Σ_b
/// √s) of a spring, with the sums over the springs at either of its ends.
///
/// Where springs and dampers are in the same proportion everywhere, this is h² times the same of
/// k, plus 2 h times that of c. Elsewhere it is more. In a step t < 1 times as long each s is at
/// most t times as large, so the step that the same proportion would allow is shortened by as much.
///
/// All this is Euler's, and so Verlet's. Without dampers it comes down to w h < 2 for the fastest
/// swing, and Suzuki's scheme bears more. With dampers Euler's limit is taken for Suzuki's too:
/// that is tried on random scenes, and not proved.
//! [spring_limit]
template <class Real>
struct SpringLimit {
  Real time_step = std::numeric_limits<Real>::infinity();
  std::size_t entry = 0;
};

/// `roster` has the bodies and knows the place of a handle, see NamedBodies.
template <class Real, class Roster>
SpringLimit<Real> spring_limit(const Work<Real>& work, const Roster& roster) {
  const std::vector<Entry<Real>>& entries = work.effects;
  struct End {
    SpringTerms<Real> terms;
    BodyIndex body;
    Real inverse_mass;
  };
  struct Spring {
    std::size_t entry, end_count;  // one or two
  };
  const std::size_t count = roster.size();
  std::vector<Spring> springs;
  std::vector<End> ends;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const SpringTerms<Real> terms = entries[i].effect->traits().spring_terms;
    if (!is_spring(*entries[i].effect)) continue;
    std::vector<BodyIndex> targets;
    if (entries[i].everyone)
      for (BodyIndex body = 0; body < count; ++body) targets.push_back(body);
    for (const BodyHandle target : entries[i].targets) targets.push_back(roster.index_of(target));
    const std::size_t stride = entries[i].effect->traits().joins_two() ? 2 : 1;
    for (std::size_t k = 0; k < targets.size(); ++k) {
      const Real arm = k % stride == 0 ? terms.arm_first : terms.arm_second;
      const BodyIndex body = targets[k];
      ends.push_back({terms, body, largest_inverse_mass_at(roster.body(body), arm)});
      if (k % stride == 0) springs.push_back({i, stride});
    }
  }

  // √s (w_a Σ_a √s + w_b Σ_b √s) of each spring, for the strength s that its terms give.
  const auto rows = [&](const auto& strength) {
    std::vector<Real> sums(count, Real(0)), result;
    for (const End& end : ends) sums[end.body] += std::sqrt(strength(end.terms));
    auto end = ends.begin();
    for (const Spring& spring : springs) {
      Real row = 0;
      for (const auto last = end + static_cast<std::ptrdiff_t>(spring.end_count); end != last;
           ++end)
        row += std::sqrt(strength(end->terms)) * end->inverse_mass * sums[end->body];
      result.push_back(row);
    }
    return result;
  };
  const auto stiffness = rows([](const SpringTerms<Real>& terms) { return terms.stiffness; });
  const auto damping = rows([](const SpringTerms<Real>& terms) { return terms.damping; });
  SpringLimit<Real> limit;
  for (std::size_t i = 0; i < springs.size(); ++i) {
    const Real largest = largest_stable_time_step<Real>(stiffness[i], damping[i], 1);
    if (largest < limit.time_step) limit = {largest, springs[i].entry};
  }
  if (!std::isfinite(limit.time_step)) return limit;
  if (std::all_of(damping.begin(), damping.end(), [](Real row) { return row == 0; })) {
    limit.time_step *= static_cast<Real>(largest_stable_angle(work.scheme) / 2);
    return limit;
  }

  const Real h = limit.time_step;
  const auto together = rows([h](const SpringTerms<Real>& terms) {
    return h * terms.stiffness * h + 2 * h * terms.damping;
  });
  const auto most = std::max_element(together.begin(), together.end());
  if (*most > 4 * (1 + 64 * std::numeric_limits<Real>::epsilon()))  // by more than rounding
    limit = {h * 4 / *most, springs[static_cast<std::size_t>(most - together.begin())].entry};
  return limit;
}
//! [spring_limit]

}  // namespace tumble
