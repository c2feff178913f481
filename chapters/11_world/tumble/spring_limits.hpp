/// @file
/// Up to which time step the stretches of a scene's springs can't feed on themselves.
#pragma once

#include <limits>
#include <tumble/semi_implicit_euler.hpp>
#include <tumble/work.hpp>

namespace tumble {

/// How easily a force at distance `arm` (m) from the centre of mass moves the point that it acts
/// at, at most: 1/m + arm²/I with the smallest moment, 1/kg.
template <class Real>
Real largest_inverse_mass_at(const RigidBody<Real>& body, Real arm) {
  return body.centre.inverse_mass + arm * arm * body.top.inverse_moments.maxCoeff();
}

/// The time step (s) up to which a scheme keeps a swing of the stiffness k (N/m) and the damping c
/// (N s/m), for a mass of 1 kg, from growing without bound.
///
/// Verlet's bound is that of Euler's step. With D for half a drift and K for a kick, read from left
/// to right, n steps of Verlet's are (D K D)ⁿ = D (K D D)ⁿ D⁻¹, and K D D is Euler's step: the one
/// grows if the other does. Suzuki's bound is found by trial. A step of it is a matrix that turns
/// the position x and h v into the next ones; with the trace T and the determinant Δ of that matrix
/// they stay bounded if |T| < 1 + Δ and Δ ≤ 1. That is tried at each hundredth of Euler's bound.
template <class Real>
Real largest_stable_time_step(Scheme scheme, Real stiffness, Real damping) {
  const Real of_euler = largest_stable_time_step<Real>(stiffness, damping, 1);
  if (scheme != Scheme::suzuki || !std::isfinite(of_euler)) return of_euler;
  const auto portions = portions_of<double>(scheme);
  const auto stays_bounded = [&](double h) {
    const double angle = std::sqrt(static_cast<double>(stiffness)) * h;
    const double lost = static_cast<double>(damping) * h;
    double determinant = 1;
    std::array<std::array<double, 2>, 2> columns = {{{1, 0}, {0, 1}}};  // x and h v, from 1 and 0
    for (const Portion<double>& portion : portions) {
      if (portion.stroke == Stroke::kick) determinant *= 1 - portion.lasts * lost;
      for (auto& [x, hv] : columns)
        if (portion.stroke == Stroke::kick)
          hv -= portion.lasts * (angle * angle * x + lost * hv);
        else if (portion.stroke == Stroke::drift)
          x += portion.lasts * hv;
    }
    return determinant <= 1 && std::abs(columns[0][0] + columns[1][1]) < 1 + determinant;
  };
  const double hundredth = static_cast<double>(of_euler) / 100;
  int n = 0;
  while (n < 500 && stays_bounded((n + 1) * hundredth)) ++n;
  return static_cast<Real>(n * hundredth);
}

/// The time step (s) up to which no small stretches of springs can grow, and the spring (its place
/// in `entries`) that limits it; infinite without springs. A spring under tension also resists
/// being turned aside, with the tension times its arm: that is left out, and can need a shorter
/// step.
///
/// Springs that share a body stiffen each other. With w the inverse mass at an attachment, the
/// equation of all stretches s is s̈ = −A s, where A_ij joins springs i and j through a shared body
/// by at most √k_i √k_j w. Gershgorin's theorem bounds its eigenvalues by the largest row sum,
/// √k_i (w_a Σ_a √k + w_b Σ_b √k), with the sums over the springs at either end. The same holds for
/// the dampers with c in place of k, and chapter 6 has the limit for both together.
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
    std::size_t entry;
    BodyIndex body;
    Real inverse_mass;
  };
  const std::size_t count = roster.size();
  std::vector<Real> root_stiffness(count, Real(0)), root_damping(count, Real(0));
  std::vector<End> ends;
  std::vector<std::size_t> ends_of_spring;  // one or two
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
      ends.push_back({i, body, largest_inverse_mass_at(roster.body(body), arm)});
      if (k % stride == 0) ends_of_spring.push_back(stride);
      root_stiffness[body] += std::sqrt(terms.stiffness);
      root_damping[body] += std::sqrt(terms.damping);
    }
  }
  SpringLimit<Real> limit;
  struct {
    Real stiffness, damping, limit;
  } last = {-1, -1, 0};  // springs that are alike are asked once
  std::size_t end = 0;
  for (const std::size_t stride : ends_of_spring) {
    const SpringTerms<Real> terms = entries[ends[end].entry].effect->traits().spring_terms;
    Real stiffness = 0, damping = 0;
    for (std::size_t k = 0; k < stride; ++k) {
      const End& here = ends[end + k];
      stiffness += std::sqrt(terms.stiffness) * here.inverse_mass * root_stiffness[here.body];
      damping += std::sqrt(terms.damping) * here.inverse_mass * root_damping[here.body];
    }
    if (stiffness != last.stiffness || damping != last.damping)
      last = {stiffness, damping, largest_stable_time_step(work.scheme, stiffness, damping)};
    const Real largest = last.limit;
    if (largest < limit.time_step) limit = {largest, ends[end].entry};
    end += stride;
  }
  return limit;
}
//! [spring_limit]

}  // namespace tumble
