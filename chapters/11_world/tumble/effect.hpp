/// @file
/// Which bodies need an effect, and why the others do not.
#pragma once

#include <string>
#include <tumble/forms.hpp>

namespace tumble {

/// What of a body an effect can change.
struct Reach {
  bool centre, top;
};

/// What an effect that writes `writes` can change of a body with these flags.
//! [reach_of]
inline Reach reach_of(Quantities writes, const BodyFlags& flags) {
  const bool pushes = writes.has_any(quantity::force | quantity::velocity) && !flags.is_static;
  const bool turns = writes.has_any(quantity::torque | quantity::spin) && flags.can_turn;
  return {pushes || writes.has(quantity::position),
          turns || (writes.has(quantity::orientation) && !flags.is_point)};
}
//! [reach_of]

/// Why an effect that writes `writes` can change nothing of a body; empty if it can change it.
inline std::string_view unwritable_reason(Quantities writes, const BodyFlags& flags) {
  const Reach reach = reach_of(writes, flags);
  if (reach.centre || reach.top) return {};
  return !writes.has_any(quantity::force | quantity::velocity)
             ? flags.is_point ? "points do not turn" : "locked about every axis"
             : "nothing can move them";
}

/// The answer of an effect's predicate: empty if the effect is needed, else why it is not. An
/// effect without a predicate is needed by every body that it can change.
template <class Real, class Effect>
std::string_view skip_reason(const Effect& effect, const BodyFlags& flags, Quantities writes) {
  if (form_of<Effect, Real>().sees == Sees::top && flags.is_point) return "points do not turn";
  if (HoldsRotor<Effect, Real> && !flags.can_turn) return "locked about every axis";
  if (const std::string_view why = unwritable_reason(writes, flags); !why.empty()) return why;
  if constexpr (requires { effect.needs_top(); })
    if (effect.needs_top() && flags.is_point) return "points have no orientation";
  if constexpr (requires { effect.skip_reason(flags); })
    return effect.skip_reason(flags);
  else
    return {};
}

/// The same for an effect that writes all that its form can write.
template <class Real, class Effect>
std::string_view skip_reason(const Effect& effect, const BodyFlags& flags) {
  return skip_reason<Real>(effect, flags, form_of<Effect, Real>().writes);
}

}  // namespace tumble
