/// @file
/// From what an effect gives to what it changes, for one body.
#pragma once

#include <tumble/effect.hpp>
#include <tumble/rigid_body.hpp>
#include <tumble/semi_implicit_euler.hpp>

namespace tumble {

/// True, for each body of a pack, where the top can't turn at all.
template <class Real>
auto is_locked(const Top<Real>& top) {
  return top.inverse_moments.x() == 0 && top.inverse_moments.y() == 0 &&
         top.inverse_moments.z() == 0;
}

/// Adds to the sums what can have an effect: a force has none on a body that can't move.
template <class Real>
void add_push(Particle<Real>& centre, Top<Real>& top, const Push<Real>& push) {
  for (int axis = 0; axis < 3; ++axis) {
    centre.force[axis] += select(is_static(centre), Real(0), push.force[axis]);
    top.torque[axis] += select(is_locked(top), Real(0), push.torque[axis]);
  }
}

/// What the effect gives to a centre. `seen` is what its function sees.
template <class Effect, class Seen, class Real>
void give_to(Particle<Real>& centre, const Effect& effect, const Seen& seen,
             const StepTime<Real>& moment) {
  if constexpr (GivesForce<Effect, Seen, Real>)
    centre.force += effect.force(seen, moment.time);
  else if constexpr (GivesAcceleration<Effect, Seen, Real>)
    accelerate<Real>(centre, effect.acceleration(seen, moment.time), moment.time_step);
  else if constexpr (GivesVelocity<Effect, Seen, Real>)
    centre.velocity = effect.velocity(seen, moment);
  else if constexpr (GivesPosition<Effect, Seen, Real>)
    centre.position = effect.position(seen, moment);
}

/// What it gives to a top.
template <class Effect, class Seen, class Real>
void give_to(Top<Real>& top, const Effect& effect, const Seen& seen, const StepTime<Real>& moment) {
  if constexpr (GivesTorque<Effect, Seen, Real>)
    top.torque += effect.torque(seen, moment.time);
  else if constexpr (GivesSpin<Effect, Seen, Real>)
    top.angular_momentum_body = free_part<Real>(top, effect.angular_momentum_body(seen, moment));
  else if constexpr (GivesOrientation<Effect, Seen, Real>)
    top.orientation = effect.orientation(seen, moment);
}

/// An effect that sees the centre alone, or the top alone.
template <class Effect, class Real>
void visit(const Effect& effect, Particle<Real>& centre, const StepTime<Real>& moment) {
  give_to(centre, effect, centre, moment);
}
template <class Effect, class Real>
void visit(const Effect& effect, Top<Real>& top, const StepTime<Real>& moment) {
  give_to(top, effect, top, moment);
}

/// An effect that sees both.
template <class Effect, class Real>
void visit(const Effect& effect, Particle<Real>& centre, Top<Real>& top,
           const StepTime<Real>& moment) {
  const BodyState<Real> seen{centre, top};
  if constexpr (GivesPush<Effect, BodyState<Real>, Real>) {
    add_push(centre, top, effect.push(seen, moment.time));
  } else {
    give_to(centre, effect, seen, moment);
    give_to(top, effect, seen, moment);
  }
}

/// A body that is changed in place. A point has a top that is thrown away.
template <class Real>
struct BodyInPlace {
  Particle<Real>& centre;
  Top<Real>& top;
};

/// An effect that joins two.
template <class Effect, class Real>
void visit(const Effect& effect, const BodyInPlace<Real>& first, const BodyInPlace<Real>& second,
           const StepTime<Real>& moment) {
  const BodyState<Real> a{first.centre, first.top}, b{second.centre, second.top};
  if constexpr (PushBetween<Effect, Real>) {
    const PairPush<Real> push = effect.push(a, b, moment.time);
    add_push<Real>(first.centre, first.top, {push.force_on_first, push.torque_on_first});
    add_push<Real>(second.centre, second.top, {-push.force_on_first, push.torque_on_second});
  } else {
    const PairBlow<Real> blow = effect.blow(a, b, moment);
    first.centre.velocity += first.centre.inverse_mass * blow.impulse_on_first;
    second.centre.velocity -= second.centre.inverse_mass * blow.impulse_on_first;
    add_angular_momentum<Real>(first.top, blow.turn_on_first);
    add_angular_momentum<Real>(second.top, blow.turn_on_second);
  }
}

}  // namespace tumble
