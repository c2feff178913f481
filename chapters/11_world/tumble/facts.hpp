/// @file
/// What is known of a body: by itself, and under the effects of a scene.
#pragma once

#include <tumble/any_effect.hpp>
#include <tumble/euler_equations.hpp>

namespace tumble {

/// What a body is, whatever acts on it. `before` is what was known of it: a body that has moved
/// may move, and a push of this step alone is still to come.
template <class Real>
Facts facts_alone(const BodyState<Real>& body, bool is_point, const Facts& before = {}) {
  Facts facts;
  facts.is_pushed = before.is_pushed;
  facts.is_torqued = before.is_torqued;
  facts.is_static = is_static(body.centre);
  facts.is_point = is_point;
  facts.can_turn = body.top.inverse_moments != Vec3<Real>::Zero();
  facts.is_gyroscopic = is_gyroscopic(body.top);
  facts.moves = before.moves || body.centre.velocity != Vec3<Real>::Zero();
  facts.turns =
      facts.can_turn && (before.turns || body.top.angular_momentum_body != Vec3<Real>::Zero());
  return facts;
}

/// Notes what an effect that writes `writes` can do to a body that it visits.
/// @return true if that is news
//! [note]
inline bool note(Facts& facts, Quantities writes) {
  const Facts before = facts;
  const bool on_centre = writes.has_any(quantity::force | quantity::velocity) && !facts.is_static;
  const bool on_top = writes.has_any(quantity::torque | quantity::spin) && facts.can_turn;
  facts.is_pushed |= writes.has(quantity::force) && !facts.is_static;
  facts.is_torqued |= writes.has(quantity::torque) && facts.can_turn;
  facts.moves |= on_centre || writes.has(quantity::position);
  facts.turns |= on_top || (writes.has(quantity::orientation) && !facts.is_point);
  return facts != before;
}
//! [note]

/// What is known of a body under some effects. One can call for another, as a first torque calls
/// for the Magnus force; so they are gone through until that brings no news. It ends: a fact only
/// ever turns from false to true. `for_each` calls what it is given with each effect.
//! [facts_under]
template <class Real, class ForEach>
Facts facts_under(Facts facts, const ForEach& for_each) {
  for (bool news = true; news;) {
    news = false;
    for_each([&](const AnyEffect<Real>& effect) {
      if (effect.why_skipped(facts).empty()) news |= note(facts, effect.traits().writes);
    });
  }
  return facts;
}
//! [facts_under]

}  // namespace tumble
