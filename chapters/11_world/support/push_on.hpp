/// @file
/// What an effect gives to one body, or to two, seen from what running it changes.
#pragma once

#include <tumble/any_effect.hpp>

namespace tumble::support {

/// The top as one that can turn, because a torque has no effect on one that can't.
template <class Real>
Top<Real> free_to_turn(Top<Real> top) {
  if (is_locked(top)) top.inverse_moments.setOnes();
  return top;
}

/// The force and the torque, or for an acceleration the mass times it.
template <class Real>
Push<Real> push_on(const AnyEffect<Real>& effect, const BodyState<Real>& body, Real time) {
  Bodies<Real> bodies;
  const Top<Real> top = free_to_turn(body.top);
  append(bodies, body.centre, &top);
  Members one;
  one.indices.insert(0);
  effect.run(bodies, one, {time, 1}, {});
  const Vec3<Real> gained = bodies.centres[0].velocity - body.centre.velocity;
  return {.force = bodies.centres[0].force + mass_of(body.centre) * gained,
          .torque = bodies.tops[0].torque};
}

/// What it gives to a pair.
template <class Real>
PairPush<Real> push_on(const AnyEffect<Real>& effect, const BodyState<Real>& first,
                       const BodyState<Real>& second, Real time) {
  Bodies<Real> bodies;
  const Top<Real> top = free_to_turn(first.top), other = free_to_turn(second.top);
  append(bodies, first.centre, &top);
  append(bodies, second.centre, &other);
  effect.run(bodies, {{}, {{0, 1}}}, {time, 1}, {});
  return {.force_on_first = bodies.centres[0].force,
          .torque_on_first = bodies.tops[0].torque,
          .torque_on_second = bodies.tops[1].torque};
}

}  // namespace tumble::support
