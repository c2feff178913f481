/// @file
/// What a method that chooses its steps can't see for itself: the moments at which a force or a
/// torque changes abruptly, and how long a step may be lest it pass over something short.
#pragma once

#include <tumble/step_control.hpp>
#include <vector>

namespace tumble {

/// What no step passes over.
//! [stops]
template <class Real>
struct Stops {
  std::vector<Real> events = {};  ///< s, by the clock of the forces, in ascending order
  Real longest = std::numeric_limits<Real>::infinity();  ///< of a step, s
};
//! [stops]

/// @throws std::invalid_argument unless the events are finite and in order and the longest step is
/// more than 0.
template <class Real>
void require_stops(const Stops<Real>& stops) {
  if (!(stops.longest > 0)) reject("longest step", stops.longest, "s", "it must be greater than 0");
  for (std::size_t n = 0; n < stops.events.size(); ++n) {
    require_finite("event", stops.events[n], "s");
    if (n > 0 && !(stops.events[n] > stops.events[n - 1]))
      reject("event", stops.events[n], "s", "it must be later than the one before");
  }
}

/// A force or a torque as one leg of an integration sees it: `evaluate_forces`, never asked for a
/// time outside. At an event `evaluate_forces` says what acts from then on; the leg that ends there
/// takes what it says just before.
template <class Forces, class Real>
struct WithinLeg {
  const Forces& evaluate_forces;  ///< of the whole integration
  Real first;                     ///< where the leg begins, s
  Real last;                      ///< and where it ends, s

  /// `time`, or the nearer end of the leg, s.
  Real inside(Real time) const { return std::clamp(time, first, last); }

  /// Its force or torque on `body`, at `time` (s) or at the nearer end.
  template <class Body>
  void operator()(Body& body, Real time) const {
    evaluate_forces(body, inside(time));
  }
  /// @cond What only some have, see rates_under() and AxisTurn.
  template <class Body>
  void in_full(Body& body, Real time) const requires requires {
    evaluate_forces.in_full(body, time);
  }
  { evaluate_forces.in_full(body, inside(time)); }
  template <class Orientation>
  auto torque_body(const Orientation& q, Real time) const requires requires {
    evaluate_forces.torque_body(q, time);
  }
  { return evaluate_forces.torque_body(q, inside(time)); }
  template <class Axis>
  auto torque_on_axis(const Axis& axis, Real time) const {
    return evaluate_forces.torque_on_axis(axis, inside(time));
  }
  /// @endcond
};

/// Takes a body from `time` through `seconds` in legs from event to event. `leg(body,
/// evaluate_forces, begin, length)` makes one of them, in s, and returns what it took. What acts at
/// the end is left in the body. If a leg fails the body is where it was at the start.
/// @throws std::invalid_argument as require_stops().
//! [in_legs]
template <class Body, class Real, class Forces, class Leg>
StepCounts in_legs(Body& body, const Forces& evaluate_forces, Real time, Same<Real> seconds,
                   const Stops<Real>& stops, const Leg& leg) {
  require_stops(stops);
  Body there = body;
  StepCounts all;
  const auto go = [&](Real begin, Real length, Real last) {
    const StepCounts one =
        leg(there, WithinLeg<Forces, Real>{evaluate_forces, begin, last}, begin, length);
    all.steps += one.steps;
    all.rejected += one.rejected;
  };
  const Real end = time + seconds;
  Real begin = time, last = end;
  for (const Real event : stops.events) {
    const Real before = std::nextafter(event, begin);
    if (event > begin && event < end) {
      go(begin, (event - time) - (begin - time), before);
      begin = event;
    } else if (event == end) {
      last = before;
    }
  }
  go(begin, seconds - (begin - time), last);
  evaluate_forces(there, end);
  body = there;
  return all;
}
//! [in_legs]

/// Takes the body of a stepper through one leg of so many `seconds`.
template <class Body, class Stepper, class Real>
StepCounts integrate_leg(Body& body, Stepper& steps, Real seconds, Real longest) {
  const StepCounts counts = integrate_adaptively(
      steps, seconds, steps.first_step(seconds), [](Real, Real) {}, longest);
  body = steps.body();
  return counts;
}

}  // namespace tumble
