/// @file
/// Steps under forces and torques that depend on time and place: Euler's two, and splittings into
/// kicks and drifts.
///
/// Every step here takes `evaluate_forces(body, time)`, which must leave in the body the sum of
/// what acts on it at that time (s): particle.force, top.torque. The sum of now is there when a
/// step begins, and that of then when it ends, so call it once before the first. That saves
/// each step an evaluation.
#pragma once

#include <tumble/alternation.hpp>
#include <tumble/semi_implicit_euler.hpp>
#include <tumble/tumbling.hpp>

namespace tumble {

/// Chapter 6's explicit Euler.
template <class Real, class Forces>
void step_explicitly(Particle<Real>& particle, const Forces& evaluate_forces, Same<Real> time,
                     Same<Real> time_step) {
  explicit_step(particle, time_step);
  evaluate_forces(particle, time + time_step);
}

/// Kick, then drift: chapter 1's step, and that of the world.
template <class Body, class Forces, class Real>
void step_by_kick_and_drift(Body& body, const Forces& evaluate_forces, Real time, Real time_step) {
  kick(body, time_step);
  drift(body, time_step);
  evaluate_forces(body, time + time_step);
}

/// Kicks and drifts in the portions of a row. Time passes with the drifts, and a kick takes what
/// acts at the time and place that they have led to.
///
/// For a particle, or for a symmetric top, whose drift is exact, the order is that of the row. Any
/// other top drifts by a rule of second order that is symmetric in time: then it is that of the row
/// if the row is made of whole steps, see alternation.hpp.
///
/// An `evaluate_forces` that has a drift(body, h) of its own drifts by that: in thick air, say,
/// where coasting to a stop is an exact motion too.
///
/// Where force depends on velocity, the order falls to 1: the last kick of a step uses what
/// was evaluated before it.
//! [step_by_row]
template <class Row, class Body, class Forces, class Real>
void step_by_row(Body& body, const Forces& evaluate_forces, Real time, Real time_step) {
  alternate<Row>(
      time_step, [&](Real h) { kick(body, h); },
      [&](Real h) {
        if constexpr (requires { evaluate_forces.drift(body, h); })
          evaluate_forces.drift(body, h);
        else
          drift(body, h);
        time += h;
        evaluate_forces(body, time);
      });
}
//! [step_by_row]

}  // namespace tumble
