/// @file
/// From what an effect gives to what it changes, for a body or for two.
#pragma once

#include <tumble/effect.hpp>
#include <tumble/rigid_body.hpp>
#include <tumble/semi_implicit_euler.hpp>

namespace tumble {

/// True where the top can't turn at all; of packs, a mask.
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

/// Applies an effect, or a motion, to a centre. `seen` is what its function sees.
template <class Effect, class Seen, class Real>
void give_to(Particle<Real>& centre, const Effect& effect, const Seen& seen,
             const StepTime<Real>& at) {
  if constexpr (MovesInPlace<Effect, Particle<Real>, Real>)
    effect(centre, at.time_step);
  else if constexpr (GivesForce<Effect, Seen, Real>)
    centre.force += effect.force(seen, at.time);
  else if constexpr (GivesAcceleration<Effect, Seen, Real>)
    accelerate<Real>(centre, effect.acceleration(seen, at.time), at.time_step);
  else if constexpr (GivesVelocity<Effect, Seen, Real>)
    centre.velocity = effect.velocity(seen, at);
  else if constexpr (GivesPosition<Effect, Seen, Real>)
    centre.position = effect.position(seen, at);
}

/// The same for a top.
template <class Effect, class Seen, class Real>
void give_to(Top<Real>& top, const Effect& effect, const Seen& seen, const StepTime<Real>& at) {
  if constexpr (MovesInPlace<Effect, Top<Real>, Real>)
    effect(top, at.time_step);
  else if constexpr (GivesTorque<Effect, Seen, Real>)
    top.torque += effect.torque(seen, at.time);
  else if constexpr (GivesSpin<Effect, Seen, Real>)
    top.angular_momentum_body = free_part<Real>(top, effect.angular_momentum_body(seen, at));
  else if constexpr (GivesOrientation<Effect, Seen, Real>)
    top.orientation = effect.orientation(seen, at);
}

/// Applies an effect that sees both to a body.
template <class Effect, class Real>
void give_to_both(Particle<Real>& centre, Top<Real>& top, const Effect& effect,
                  const StepTime<Real>& at) {
  const BodyState<Real> seen{centre, top};
  if constexpr (GivesPush<Effect, BodyState<Real>, Real>) {
    add_push(centre, top, effect.push(seen, at.time));
  } else {
    give_to(centre, effect, seen, at);
    give_to(top, effect, seen, at);
  }
}

/// A body that is changed in place. A point, which has no top, gets one that nobody keeps.
template <class Real>
struct BodyInPlace {
  Particle<Real>& centre;
  Top<Real>& top;
};

/// Applies an effect that joins two to them.
template <class Real, class Effect>
void give_to_pair(const BodyInPlace<Real>& first, const BodyInPlace<Real>& second,
                  const Effect& effect, const StepTime<Real>& at) {
  const BodyState<Real> a{first.centre, first.top}, b{second.centre, second.top};
  if constexpr (PushBetween<Effect, Real>) {
    const PairPush<Real> push = effect.push(a, b, at.time);
    add_push<Real>(first.centre, first.top, {push.force_on_first, push.torque_on_first});
    add_push<Real>(second.centre, second.top, {-push.force_on_first, push.torque_on_second});
  } else {
    const PairImpulse<Real> blow = effect.blow(a, b, at);
    first.centre.velocity += first.centre.inverse_mass * blow.impulse_on_first;
    second.centre.velocity -= second.centre.inverse_mass * blow.impulse_on_first;
    add_angular_momentum<Real>(first.top, blow.angular_impulse_on_first);
    add_angular_momentum<Real>(second.top, blow.angular_impulse_on_second);
  }
}

}  // namespace tumble
