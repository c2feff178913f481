/// @file
/// Refuses members of an effect that nobody would hear. The page on effects has the table of those
/// by which an effect may tell more of itself.
#pragma once

#include <tumble/effect_traits.hpp>
#include <type_traits>

namespace tumble {

namespace detail {

/// The names. What inherits from an effect and from this has a name twice if the effect has it too,
/// in whatever form, and then the name alone is ambiguous.
struct MemberNames {
  int skip_reason, check, prepare, response, potential_energy, gives_torque, needs_top,
      needs_second_top, depends_on_speed, smoothness, find_pairs, broadcast;
};
/// Names that are nearly these, and for which nobody asks.
// NOLINTBEGIN(readability-identifier-naming): they are as others may spell them
struct NearlyMemberNames {
  int skip_reasons, skipReason, skips, why_skipped, why_skiped, checks, prepares, responds,
      responses, potential_energies, potentialEnergy, gives_torques, givesTorque, needs_a_top,
      needsTop, needs_tops, needs_second, needsSecondTop, depends_on_velocity, dependsOnSpeed,
      smooth, find_pair, finds_pairs, findPairs, broadcasts, widened;
};
// NOLINTEND(readability-identifier-naming)
template <class Effect, class Names>
struct WithNames : Effect, Names {};
struct Nothing {};

template <class Effect>
constexpr bool has_nearly_name() {
  using Nearly = WithNames<Effect, NearlyMemberNames>;
  return !requires {
    &Nearly::skip_reasons, &Nearly::skipReason, &Nearly::skips, &Nearly::why_skipped;
    &Nearly::why_skiped, &Nearly::checks, &Nearly::prepares, &Nearly::responds, &Nearly::responses;
    &Nearly::potential_energies, &Nearly::potentialEnergy, &Nearly::gives_torques;
    &Nearly::givesTorque, &Nearly::needs_a_top, &Nearly::needsTop, &Nearly::needs_tops;
    &Nearly::needs_second, &Nearly::needsSecondTop, &Nearly::depends_on_velocity;
    &Nearly::dependsOnSpeed, &Nearly::smooth, &Nearly::find_pair, &Nearly::finds_pairs;
    &Nearly::findPairs, &Nearly::broadcasts, &Nearly::widened;
  };
}

}  // namespace detail

/// Which members of an effect are heard: those that it lacks, and those that it has in the form for
/// which the world asks. A type that is final can't be asked, and counts as heard.
template <class Real, class Effect>
struct IsHeard {
  using Named =
      detail::WithNames<std::conditional_t<std::is_final_v<Effect>, detail::Nothing, Effect>,
                        detail::MemberNames>;
  using Body = BodyState<Real>;
  // clang-format off: its version 14 takes requires for a block
  static constexpr bool skip_reason = requires { &Named::skip_reason; }
  || requires(const Effect& it, const BodyFlags& flags) { it.skip_reason(flags); }
  || (EffectOnTwo<Effect, Real> && requires(const Effect& it) { it.skip_reason(); });
  static constexpr bool check = requires { &Named::check; }
  || requires(Effect& it) { it.check(); };
  static constexpr bool prepare = requires { &Named::prepare; }
  || requires(Effect& it, Real time_step) { it.prepare(time_step); };
  static constexpr bool response = requires { &Named::response; }
  || !std::is_void_v<AnswerOf<Real, Effect>>;
  static constexpr bool potential_energy = requires { &Named::potential_energy; }
  || requires(const Effect& it, const Body& body) { it.potential_energy(body); }
  || requires(const Effect& it, const Body& body) { it.potential_energy(body, body); };
  static constexpr bool gives_torque = requires { &Named::gives_torque; }
  || requires(const Effect& it) { it.gives_torque(); };
  static constexpr bool needs_top = requires { &Named::needs_top; }
  || requires(const Effect& it) { it.needs_top(); };
  static constexpr bool needs_second_top = requires { &Named::needs_second_top; }
  || requires(const Effect& it) { it.needs_second_top(); };
  static constexpr bool depends_on_speed = requires { &Named::depends_on_speed; }
  || requires(const Effect& it) { it.depends_on_speed(); };
  static constexpr bool smoothness = requires { &Named::smoothness; }
  || requires(const Effect& it) { it.smoothness(); };
  static constexpr bool find_pairs = requires { &Named::find_pairs; }
  || FindsPairs<Effect, Real>;
  static constexpr bool broadcast = requires { &Named::broadcast; }
  || requires(const Effect& it) { it.template broadcast<Real>(); };
  // clang-format on
  static constexpr bool others = std::is_final_v<Effect> || !detail::has_nearly_name<Effect>();
};

/// Compiles if all members of the effect are heard; else the compiler says of which form one is.
template <class Real, class Effect>
struct HeardMembers {
  using Is = IsHeard<Real, Effect>;
  static_assert(Is::skip_reason,
                "skip_reason(const BodyFlags&) const returns why a body needs no effect, or \"\"");
  static_assert(Is::check, "check() takes nothing, and throws if a number is wrong");
  static_assert(Is::prepare, "prepare(Real time_step) computes what depends on the step");
  static_assert(Is::response,
                "response() const takes a const BodyState<Real>&, or two of an effect on two");
  static_assert(Is::potential_energy,
                "potential_energy() const takes a const BodyState<Real>&, or two, and returns J");
  static_assert(Is::gives_torque,
                "gives_torque() const is a function, which returns true or false");
  static_assert(Is::needs_top, "needs_top() const is a function, which returns true or false");
  static_assert(Is::needs_second_top,
                "needs_second_top() const is a function, which returns true or false");
  static_assert(Is::depends_on_speed,
                "depends_on_speed() const is a function, which returns true or false");
  static_assert(Is::smoothness, "smoothness() const is a function, and returns an int");
  static_assert(Is::find_pairs,
                "find_pairs(const Bodies<Real>&, std::vector<BodyPair>&) const appends the pairs");
  static_assert(Is::broadcast, "broadcast<Wide>() const is a template without arguments");
  static_assert(Is::others,
                "a member's name is nearly one for which the world asks, see effect_members.hpp");
  static constexpr bool value = true;
};

}  // namespace tumble
