/// @file
/// What is known of a body: by itself, and under the effects of a scene.
#pragma once

#include <tumble/any_effect.hpp>
#include <tumble/euler_equations.hpp>

namespace tumble {

/// A body's own flags, whatever acts on it. From `before` it keeps that the body has moved or
/// turned, and that a push for the next step is pending.
template <class Real>
BodyFlags flags_alone(const BodyState<Real>& body, bool is_point, const BodyFlags& before = {}) {
  BodyFlags flags;
  flags.is_pushed = before.is_pushed;
  flags.is_torqued = before.is_torqued;
  flags.is_static = is_static(body.centre);
  flags.is_point = is_point;
  flags.can_turn = body.top.inverse_moments != Vec3<Real>::Zero();
  flags.is_gyroscopic = is_gyroscopic(body.top);
  flags.moves = before.moves || body.centre.velocity != Vec3<Real>::Zero();
  flags.turns =
      flags.can_turn && (before.turns || body.top.angular_momentum_body != Vec3<Real>::Zero());
  return flags;
}

/// Notes what an effect that writes `writes` can do to a body that it visits.
/// @return true if that is news
//! [note]
inline bool note(BodyFlags& flags, Quantities writes) {
  const BodyFlags before = flags;
  const Reach reach = reach_of(writes, flags);
  flags.is_pushed |= writes.has(quantity::force) && !flags.is_static;
  flags.is_torqued |= writes.has(quantity::torque) && flags.can_turn;
  flags.moves |= reach.centre;
  flags.turns |= reach.top;
  return flags != before;
}
//! [note]

/// What is known of a body under some effects. One can call for another, as a first torque calls
/// for the Magnus force; so they are gone through until that brings no news. It ends: a flag only
/// ever turns from false to true. `for_each` calls what it is given with each effect.
//! [flags_under]
template <class Real, class ForEach>
BodyFlags flags_under(BodyFlags flags, const ForEach& for_each) {
  for (bool news = true; news;) {
    news = false;
    for_each([&](const AnyEffect<Real>& effect) {
      if (effect.skip_reason(flags).empty()) news |= note(flags, effect.traits().writes);
    });
  }
  return flags;
}
//! [flags_under]

}  // namespace tumble
