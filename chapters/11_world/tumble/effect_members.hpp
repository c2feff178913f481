/// @file
/// Refuses members of an effect that nobody would hear. The page on effects has the table of those
/// by which an effect may tell more of itself.
#pragma once

#include <string_view>
#include <tumble/effect_traits.hpp>

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

/// The name of a member that the effect has, but not in the form for which the world asks, so that
/// it would tell nobody anything; "nearly" if a name is nearly one of these, and empty if all is
/// well. A type that is final can't be asked.
template <class Real, class Effect>
constexpr std::string_view unheard_member() {
  if constexpr (!std::is_final_v<Effect>) {
    using Named = detail::WithNames<Effect, detail::MemberNames>;
    using Body = BodyState<Real>;
    if (
        !requires { &Named::skip_reason; } &&
        !requires(const Effect& it, const BodyFlags& flags) { it.skip_reason(flags); } &&
        !(visits_two<Effect, Real> && requires(const Effect& it) { it.skip_reason(); }))
      return "skip_reason";
    if (
        !requires { &Named::check; } && !requires(Effect & it) { it.check(); })
      return "check";
    if (
        !requires { &Named::prepare; } && !requires(Effect & it, Real h) { it.prepare(h); })
      return "prepare";
    if (!requires { &Named::response; } && std::is_void_v<AnswerOf<Real, Effect>>)
      return "response";
    if (
        !requires { &Named::potential_energy; } &&
        !requires(const Effect& it, const Body& body) { it.potential_energy(body); } &&
        !requires(const Effect& it, const Body& body) { it.potential_energy(body, body); })
      return "potential_energy";
    if (
        !requires { &Named::gives_torque; } && !requires(const Effect& it) { it.gives_torque(); })
      return "gives_torque";
    if (
        !requires { &Named::needs_top; } && !requires(const Effect& it) { it.needs_top(); })
      return "needs_top";
    if (
        !requires { &Named::needs_second_top; } &&
        !requires(const Effect& it) { it.needs_second_top(); })
      return "needs_second_top";
    if (
        !requires { &Named::depends_on_speed; } &&
        !requires(const Effect& it) { it.depends_on_speed(); })
      return "depends_on_speed";
    if (
        !requires { &Named::smoothness; } && !requires(const Effect& it) { it.smoothness(); })
      return "smoothness";
    if (!requires { &Named::find_pairs; } && !FindsPairs<Effect, Real>) return "find_pairs";
    if (
        !requires { &Named::broadcast; } &&
        !requires(const Effect& it) { it.template broadcast<Real>(); })
      return "broadcast";
    if (detail::has_nearly_name<Effect>()) return "nearly";
  }
  return {};
}

/// Compiles if all members of the effect are heard; else the compiler says of which form one is.
template <class Real, class Effect>
struct HeardMembers {
  static constexpr std::string_view unheard = unheard_member<Real, Effect>();
  static_assert(unheard != "skip_reason",
                "skip_reason(const BodyFlags&) const returns why a body needs no effect, or \"\"");
  static_assert(unheard != "check", "check() takes nothing, and throws if a number is wrong");
  static_assert(unheard != "prepare", "prepare(Real time_step) computes what depends on the step");
  static_assert(unheard != "response",
                "response() const takes a const BodyState<Real>&, or two of an effect on two");
  static_assert(unheard != "potential_energy",
                "potential_energy() const takes a const BodyState<Real>&, or two, and returns J");
  static_assert(unheard != "gives_torque",
                "gives_torque() const is a function, which returns true or false");
  static_assert(unheard != "needs_top",
                "needs_top() const is a function, which returns true or false");
  static_assert(unheard != "needs_second_top",
                "needs_second_top() const is a function, which returns true or false");
  static_assert(unheard != "depends_on_speed",
                "depends_on_speed() const is a function, which returns true or false");
  static_assert(unheard != "smoothness", "smoothness() const is a function, and returns an int");
  static_assert(unheard != "find_pairs",
                "find_pairs(const Bodies<Real>&, std::vector<BodyPair>&) const appends the pairs");
  static_assert(unheard != "broadcast", "broadcast<Wide>() const is a template without arguments");
  static_assert(unheard != "nearly",
                "a member's name is nearly one for which the world asks, see effect_members.hpp");
  static constexpr bool value = unheard.empty();
};

}  // namespace tumble
