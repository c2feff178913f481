/// @file
/// The order that a rung shows: the time step is halved until roundings come into sight.
#pragma once

#include <support/checks.hpp>
#include <support/problems.hpp>

namespace tumble::support {

using Wide = long double;

/// The body of a problem after so many steps of a rung.
template <class Body, class Forces, class Real>
Body after(const Problem<Body, Forces>& problem, const Rung<Body, Real, Forces>& rung, int steps) {
  Body body = problem.start;
  const Real h = static_cast<Real>(problem.seconds) / Real(steps);
  problem.evaluate_forces(body, Real(0));
  for (int n = 0; n < steps; ++n) rung.step(body, problem.evaluate_forces, Real(n) * h, h);
  return body;
}

inline Wide difference(const Particle<Wide>& a, const Particle<Wide>& b) {
  return (a.position - b.position).norm();
}
inline Wide difference(const Top<Wide>& a, const Top<Wide>& b) {
  return angle_between(a.orientation, b.orientation);
}

/// Halves the step, in long double, as long as roundings are out of sight or the run gets long; the
/// last halving shows the order.
template <class Body, class Forces, class Ladder>
void check_orders(const Problem<Body, Forces>& problem, const Body& truth, const Ladder& ladder) {
  for (const auto& rung : ladder) {
    CAPTURE(std::string(rung.name));
    Wide error = 1, order = 0;
    for (int steps = 4; steps <= (1 << 15); steps *= 2) {
      const Wide next = difference(after(problem, rung, steps), truth);
      if (next < 2e-15L) break;
      order = std::log2(error / next);
      error = next;
    }
    CAPTURE(static_cast<double>(order));
    CHECK(std::lround(order) == rung.claims.order);
  }
}

}  // namespace tumble::support
