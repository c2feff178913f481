/// @file
/// What an effect is: a value with a name and one function. And which bodies need it, and why the
/// others do not.
#pragma once

#include <string>
#include <tumble/forms.hpp>

namespace tumble {

/// Why an effect that writes `writes` can change nothing of a body; empty if it can change it.
inline std::string_view why_unwritable(Quantities writes, const Facts& facts) {
  const bool centre = writes.has_any(quantity::force | quantity::velocity) && !facts.is_static;
  const bool top = writes.has_any(quantity::torque | quantity::spin) && facts.can_turn;
  const bool place = writes.has(quantity::position);
  const bool facing = writes.has(quantity::orientation) && !facts.is_point;
  if (centre || top || place || facing) return {};
  return !writes.has_any(quantity::force | quantity::velocity)
             ? facts.is_point ? "points do not turn" : "locked about every axis"
             : "nothing can move them";
}

/// The answer of an effect's predicate: empty if the effect is needed, else why it is not. An
/// effect without a predicate is needed by every body that it can change.
template <class Real, class Effect>
std::string_view why_skipped(const Effect& effect, const Facts& facts, Quantities writes) {
  if (form_of<Effect, Real>().sees == Sees::top && facts.is_point) return "points do not turn";
  if (HoldsRotor<Effect, Real> && !facts.can_turn) return "locked about every axis";
  if (const std::string_view why = why_unwritable(writes, facts); !why.empty()) return why;
  if constexpr (requires { effect.needs_top(); })
    if (effect.needs_top() && facts.is_point) return "points have no orientation";
  if constexpr (requires { effect.why_skipped(facts); })
    return effect.why_skipped(facts);
  else
    return {};
}

/// The same for an effect that writes all that its form can write.
template <class Real, class Effect>
std::string_view why_skipped(const Effect& effect, const Facts& facts) {
  return why_skipped<Real>(effect, facts, form_of<Effect, Real>().writes);
}

}  // namespace tumble
