/// @file
/// What an effect is: a value with a name, a phase, a predicate and a kernel.
#pragma once

#include <concepts>
#include <string>
#include <tumble/bodies.hpp>

namespace tumble {

/// The parts of a step, in their order.
//! [phase]
enum class Phase {
  force,    ///< forces and torques are summed; nothing moves
  kick,     ///< the sums change the momenta
  impulse,  ///< blows meet the new velocities
  damping,  ///< speeds fade
  drift     ///< positions and orientations follow
};
//! [phase]

/// What is known of a body while a plan is made, before anything moves. A predicate asks this and
/// nothing else, so its answer holds until somebody changes the scene.
//! [facts]
struct Facts {
  bool is_static = false;      ///< no force can move it
  bool is_point = false;       ///< it has no top
  bool can_turn = false;       ///< it has a top that is not locked about all axes
  bool is_gyroscopic = false;  ///< its moments differ, and no axis is locked
  bool is_pushed = false;      ///< an effect gives it a force
  bool is_torqued = false;     ///< an effect gives it a torque
  bool moves = false;          ///< it has had a velocity, or something can give it one
  bool turns = false;          ///< it has had a spin, or something can give it one
};
//! [facts]

/// What one effect does to one body in the force phase, both in world axes.
template <class Real>
struct Push {
  Vec3<Real> force = Vec3<Real>::Zero();   ///< N, at the centre of mass
  Vec3<Real> torque = Vec3<Real>::Zero();  ///< N m, about the centre of mass
};

/// What one effect does to two bodies that it joins: the force on the first, its opposite on the
/// second, and a torque on each about its own centre of mass. World axes, N and N m.
template <class Real>
struct PairPush {
  Vec3<Real> force_on_first = Vec3<Real>::Zero();
  Vec3<Real> torque_on_first = Vec3<Real>::Zero();
  Vec3<Real> torque_on_second = Vec3<Real>::Zero();
};

/// When a step happens and how long it lasts.
template <class Real>
struct Moment {
  Real time = 0;       ///< s, at the start of the step
  Real time_step = 0;  ///< s
};

/// When step number `tick` happens: at n h, with two roundings however many steps there were.
template <class Real>
Moment<Real> moment_of(std::int64_t tick, Real time_step) {
  return {static_cast<Real>(tick) * time_step, time_step};
}

/// The forms that an effect's kernel can take. The form says what the effect can change, and the
/// world believes it: whoever gives only a force never makes anything turn.
//! [forms]
template <class Effect, class Real>
concept ForceOnCentre = requires(const Effect& effect, const Particle<Real>& centre,
                                 const Real& time) {
  { effect.force(centre, time) } -> std::convertible_to<Vec3<Real>>;
};

template <class Effect, class Real>
concept ForceOnBody = requires(const Effect& effect, const BodyState<Real>& body,
                               const Real& time) {
  { effect.force(body, time) } -> std::convertible_to<Vec3<Real>>;
};

template <class Effect, class Real>
concept TorqueOnTop = requires(const Effect& effect, const Top<Real>& top, const Real& time) {
  { effect.torque(top, time) } -> std::convertible_to<Vec3<Real>>;
};

template <class Effect, class Real>
concept PushOnBody = requires(const Effect& effect, const BodyState<Real>& body, const Real& time) {
  { effect.push(body, time) } -> std::same_as<Push<Real>>;
};

template <class Effect, class Real>
concept PushBetween = requires(const Effect& effect, const BodyState<Real>& body,
                               const Real& time) {
  { effect.push(body, body, time) } -> std::same_as<PairPush<Real>>;
};

template <class Effect, class Real>
concept AccelerationOfCentre = requires(const Effect& effect, const Particle<Real>& centre,
                                        const Real& time) {
  { effect.acceleration(centre, time) } -> std::convertible_to<Vec3<Real>>;
};

template <class Effect, class Real>
concept ActsOnCentre = requires(const Effect& effect, Particle<Real>& centre,
                                const Moment<Real>& moment) {
  effect.act(centre, moment);
  { Effect::phase } -> std::convertible_to<Phase>;
};

template <class Effect, class Real>
concept ActsOnTop = requires(const Effect& effect, Top<Real>& top, const Moment<Real>& moment) {
  effect.act(top, moment);
  { Effect::phase } -> std::convertible_to<Phase>;
};
//! [forms]

/// An effect that visits bodies one by one.
template <class Effect, class Real>
concept EffectOnOne = ForceOnCentre<Effect, Real> || ForceOnBody<Effect, Real> ||
    PushOnBody<Effect, Real> || AccelerationOfCentre<Effect, Real> || ActsOnCentre<Effect, Real> ||
    TorqueOnTop<Effect, Real> || ActsOnTop<Effect, Real>;

/// The answer of an effect's predicate: empty if the effect is needed, else why it is not. An
/// effect without a predicate is needed by every body that can answer it.
template <class Real, class Effect>
std::string_view why_skipped(const Effect& effect, const Facts& facts) {
  constexpr bool on_top = ActsOnTop<Effect, Real> || TorqueOnTop<Effect, Real>;
  if (on_top && facts.is_point) return "points do not turn";
  if (TorqueOnTop<Effect, Real> && !facts.can_turn) return "locked about every axis";
  if (!on_top && !ActsOnCentre<Effect, Real> && facts.is_static) return "nothing can move them";
  if constexpr (requires { effect.needs_top(); })
    if (effect.needs_top() && facts.is_point) return "points have no orientation";
  if constexpr (requires { effect.why_skipped(facts); })
    return effect.why_skipped(facts);
  else
    return {};
}

}  // namespace tumble
