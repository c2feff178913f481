/// @file
/// What an effect's type tells about it: what it reads and writes, whom it visits, how it answers.
#pragma once

#include <optional>
#include <string>
#include <tumble/give_to.hpp>
#include <type_traits>
#include <utility>

namespace tumble {

/// What a world knows of an effect without asking it about a body.
template <class Real>
struct EffectTraits {
  std::string name;               ///< what plans and errors call it
  Phase phase = Phase::force;     ///< in which part of a step it acts
  Sees sees = Sees::nothing;      ///< of a body: its centre, its top, both, or a pair of bodies
  Quantities reads;               ///< what it looks at
  Quantities writes;              ///< and what it changes
  bool needs_top = false;         ///< the (first) body must not be a point
  bool needs_second_top = false;  ///< nor the second
  bool stores_energy = false;     ///< it has a potential energy
  bool replaces = false;          ///< what it writes takes the place of what there was
  bool finds_pairs = false;       ///< it finds the pairs that it joins itself, in each step
  bool has_response = false;      ///< it says how it limits the time step
  bool may_feed_back = false;     ///< it reads how a body moves, and does not say what follows
  bool depends_on_speed = false;  ///< what it gives depends on a velocity or a spin
  int smoothness = 9;             ///< how many derivatives of what it gives never jump; 9: all
  std::optional<int> order = {};  ///< of a turning rule: the order of its error, if it says
  bool is_symmetric = false;      ///< of a turning rule: it says that a step back undoes one forth
  bool joins_two() const { return sees == Sees::pair; }
  bool changes_limit() const { return has_response || phase == Phase::turn; }  ///< of the step
  bool visits_tops() const { return sees == Sees::top; }
};

namespace detail {

/// Which of the quantities of its form the effect writes: a spring at the centre gives no torque.
template <class Real, class Effect>
Quantities writes_of([[maybe_unused]] const Effect& effect) {
  const Quantities all = form_of<Effect, Real>().writes;
  if constexpr (requires { effect.gives_torque(); })
    if (!effect.gives_torque()) return all - quantity::torque;
  return all;
}

/// What the effect declares that it reads, or else all that it sees.
template <class Real, class Effect>
constexpr Quantities reads_of() {
  constexpr Sees sees = form_of<Effect, Real>().sees;
  constexpr Quantities seen = HoldsRotor<Effect, Real> ? quantity::time
                              : sees == Sees::centre   ? quantity::of_centre
                              : sees == Sees::top      ? quantity::of_top
                                                       : quantity::of_body;
  if constexpr (requires { Effect::reads; }) {
    static_assert(seen.has(Effect::reads) || MovesInPlace<Effect, Particle<Real>, Real> ||
                      MovesInPlace<Effect, Top<Real>, Real>,
                  "the effect's function does not see what it reads");
    return Effect::reads;
  } else {
    return seen;
  }
}

template <class Real, class Effect>
auto response_type_of(const Effect& effect, const BodyState<Real>& body) {
  if constexpr (requires { effect.response(body); })
    return effect.response(body);
  else if constexpr (requires { effect.response(body, body); })
    return effect.response(body, body);
}

}  // namespace detail

/// What the effect's response() returns, for a body or for two; void if it has none.
template <class Real, class Effect>
using AnswerOf = decltype(detail::response_type_of<Real, Effect>(
    std::declval<const Effect&>(), std::declval<const BodyState<Real>&>()));

/// It says how it answers what the body does, and so limits the time step.
template <class Real, class Effect>
inline constexpr bool has_response =
    std::is_same_v<AnswerOf<Real, Effect>, Response<Real>> && !FindsPairs<Effect, Real>;

/// What a world knows of this effect.
template <class Real, class Effect>
EffectTraits<Real> traits_of(const Effect& effect) {
  constexpr Form form = form_of<Effect, Real>();
  using Answer = AnswerOf<Real, Effect>;
  EffectTraits<Real> traits{.name = std::string(effect.name),
                            .phase = phase_of<Effect, Real>(),
                            .sees = form.sees,
                            .reads = detail::reads_of<Real, Effect>(),
                            .writes = detail::writes_of<Real>(effect)};
  traits.replaces = form.replaces;
  traits.needs_top = form.sees == Sees::top;
  if constexpr (requires { effect.needs_top(); }) traits.needs_top = effect.needs_top();
  if constexpr (requires { effect.needs_second_top(); })
    traits.needs_second_top = effect.needs_second_top();
  constexpr bool of_one = requires(const BodyState<Real>& body) {
    effect.potential_energy(body);
  };
  constexpr bool of_two = requires(const BodyState<Real>& body) {
    effect.potential_energy(body, body);
  };
  traits.stores_energy = of_one || of_two;
  traits.finds_pairs = FindsPairs<Effect, Real>;
  traits.has_response = has_response<Real, Effect>;
  traits.may_feed_back = !traits.has_response && !std::is_same_v<Answer, NoResponse> &&
                         traits.reads.has_any(quantity::of_motion);
  traits.depends_on_speed = traits.reads.has_any(quantity::velocity | quantity::spin);
  if constexpr (requires { effect.depends_on_speed(); })
    traits.depends_on_speed = effect.depends_on_speed();
  if constexpr (requires { effect.smoothness(); }) traits.smoothness = effect.smoothness();
  if constexpr (requires { effect.order(); }) traits.order = effect.order();
  if constexpr (requires { effect.is_symmetric(); }) traits.is_symmetric = effect.is_symmetric();
  return traits;
}

}  // namespace tumble
