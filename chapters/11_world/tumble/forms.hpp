/// @file
/// The forms that an effect's function can take: it is named after what it gives.
#pragma once

#include <concepts>
#include <tumble/quantities.hpp>
#include <tumble/terms.hpp>

namespace tumble {

/// What an effect's function can give: a force, N, world axes. It is const and sees everything as
/// const, so what it gives is all that it can change. `Seen` is what it sees: a Particle, a Top, or
/// a BodyState, which is both. `time`, here and below, is when its kick happens, s, by the clock of
/// World::time(): when the step begins, or by Verlet's scheme at its middle.
//! [forms]
template <class Effect, class Seen, class Real>
concept GivesForce = requires(const Effect& effect, const Seen& seen, const Real& time) {
  { effect.force(seen, time) } -> std::convertible_to<Vec3<Real>>;
};
/// A torque, N m, world axes.
template <class Effect, class Seen, class Real>
concept GivesTorque = requires(const Effect& effect, const Seen& seen, const Real& time) {
  { effect.torque(seen, time) } -> std::convertible_to<Vec3<Real>>;
};
/// Force and torque at once.
template <class Effect, class Seen, class Real>
concept GivesPush = requires(const Effect& effect, const Seen& seen, const Real& time) {
  { effect.push(seen, time) } -> std::same_as<Push<Real>>;
};
/// An acceleration, m/s², world axes.
template <class Effect, class Seen, class Real>
concept GivesAcceleration = requires(const Effect& effect, const Seen& seen, const Real& time) {
  { effect.acceleration(seen, time) } -> std::convertible_to<Vec3<Real>>;
};
/// Another velocity, m/s, world axes.
template <class Effect, class Seen, class Real>
concept GivesVelocity = requires(const Effect& effect, const Seen& seen, const StepTime<Real>& at) {
  { effect.velocity(seen, at) } -> std::convertible_to<Vec3<Real>>;
};
/// Another angular momentum, kg m²/s, body axes.
template <class Effect, class Seen, class Real>
concept GivesSpin = requires(const Effect& effect, const Seen& seen, const StepTime<Real>& at) {
  { effect.angular_momentum_body(seen, at) } -> std::convertible_to<Vec3<Real>>;
};
/// Another position of the centre of mass, m, world axes.
template <class Effect, class Seen, class Real>
concept GivesPosition = requires(const Effect& effect, const Seen& seen, const StepTime<Real>& at) {
  { effect.position(seen, at) } -> std::convertible_to<Vec3<Real>>;
};
/// Another orientation, a unit quaternion.
template <class Effect, class Seen, class Real>
concept GivesOrientation = requires(const Effect& effect, const Seen& seen,
                                    const StepTime<Real>& at) {
  { effect.orientation(seen, at) } -> std::same_as<Quaternion<Real>>;
};
//! [forms]

/// Changes what it sees in place, for a time step: the form of a step's own motions, which say what
/// they write.
template <class Motion, class Seen, class Real>
concept MovesInPlace = requires(const Motion& motion, Seen& seen, const Real& time_step) {
  motion(seen, time_step);
  { Motion::writes } -> std::convertible_to<Quantities>;
};

/// A force on two bodies that the effect joins.
template <class Effect, class Real>
concept PushBetween = requires(const Effect& effect, const BodyState<Real>& body,
                               const Real& time) {
  { effect.push(body, body, time) } -> std::same_as<PairPush<Real>>;
};
/// A blow between two bodies, in the impulse phase. It acts on the velocities that the blows before
/// it have left.
template <class Effect, class Real>
concept BlowBetween = requires(const Effect& effect, const BodyState<Real>& body,
                               const StepTime<Real>& at) {
  { effect.blow(body, body, at) } -> std::same_as<PairImpulse<Real>>;
};

/// The angular momentum (kg m²/s, body axes) of what spins inside the body, relative to it: of a
/// rotor.
template <class Effect, class Real>
concept HoldsRotor = requires(const Effect& effect, const Real& time) {
  { effect.rotor_angular_momentum_body(time) } -> std::convertible_to<Vec3<Real>>;
};

/// An effect on two may itself find which bodies meet, in each step, as a contact would.
template <class Effect, class Real>
concept FindsPairs = requires(const Effect& effect, const Bodies<Real>& bodies,
                              std::vector<BodyPair>& pairs) {
  effect.find_pairs(bodies, pairs);
};

/// A force that sees the centre alone, as most do.
template <class Effect, class Real>
concept ForceOnCentre = GivesForce<Effect, Particle<Real>, Real>;

/// What an effect's function sees.
enum class Sees { nothing, centre, top, body, pair };

/// What the form of an effect's function says.
struct Form {
  Sees sees = Sees::nothing;  ///< what is handed to the function
  Quantities writes;          ///< what it may change
  int count = 0;              ///< functions; an effect has one
  bool replaces = false;      ///< what it writes takes the place of what there was
};

namespace detail {

/// What the effect gives when its function sees `Seen`.
template <class Effect, class Seen, class Real>
constexpr Form form_seeing(Sees sees) {
  Form form;
  const auto gives = [&](bool does, Quantities what, bool replaces = false) {
    if (does) form = {sees, form.writes | what, form.count + 1, replaces};
  };
  constexpr bool centre = !std::same_as<Seen, Top<Real>>, top = !std::same_as<Seen, Particle<Real>>;
  gives(centre && GivesForce<Effect, Seen, Real>, quantity::force);
  gives(top && GivesTorque<Effect, Seen, Real>, quantity::torque);
  gives(centre && top && GivesPush<Effect, Seen, Real>, quantity::force | quantity::torque);
  gives(centre && GivesAcceleration<Effect, Seen, Real>, quantity::velocity);
  gives(centre && GivesVelocity<Effect, Seen, Real>, quantity::velocity, true);
  gives(top && GivesSpin<Effect, Seen, Real>, quantity::spin, true);
  gives(centre && GivesPosition<Effect, Seen, Real>, quantity::position, true);
  gives(top && GivesOrientation<Effect, Seen, Real>, quantity::orientation, true);
  return form;
}

}  // namespace detail

/// What an effect sees and writes, and how many of the functions of this header it has.
template <class Effect, class Real>
constexpr Form form_of() {
  const Form centre = detail::form_seeing<Effect, Particle<Real>, Real>(Sees::centre);
  const Form top = detail::form_seeing<Effect, Top<Real>, Real>(Sees::top);
  const Form body = detail::form_seeing<Effect, BodyState<Real>, Real>(Sees::body);
  Form form = centre.count ? centre : top.count ? top : body;
  form.count = centre.count + top.count + body.count;
  if (PushBetween<Effect, Real>)
    form = {Sees::pair, quantity::force | quantity::torque, form.count + 1};
  if (BlowBetween<Effect, Real>)
    form = {Sees::pair, quantity::velocity | quantity::spin, form.count + 1};
  if (HoldsRotor<Effect, Real>)
    form = {Sees::top, quantity::orientation | quantity::spin, form.count + 1};
  if constexpr (MovesInPlace<Effect, Particle<Real>, Real>)
    form = {Sees::centre, Effect::writes, form.count + 1};
  if constexpr (MovesInPlace<Effect, Top<Real>, Real>)
    form = {Sees::top, Effect::writes, form.count + 1};
  return form;
}

/// An effect that visits two bodies at a time.
template <class Effect, class Real>
concept EffectOnTwo = form_of<Effect, Real>()
.sees == Sees::pair;

/// An effect that visits bodies one by one.
template <class Effect, class Real>
concept EffectOnOne = (form_of<Effect, Real>().count != 0 && !EffectOnTwo<Effect, Real>);

/// An effect that can be given its bodies. One that finds its pairs can't: it would reach bodies of
/// which the plan does not know that something acts on them.
template <class Effect, class Real>
concept EffectForSome = (form_of<Effect, Real>().count != 0 && !FindsPairs<Effect, Real>);

/// An effect that names the phase in which it acts.
template <class Effect>
concept NamesPhase = requires {
  { Effect::phase } -> std::convertible_to<Phase>;
};

/// An effect may name its phase if it gives an acceleration, or writes a velocity, a spin or a
/// place itself. A force or a torque has to be in the sums before the kick, a blow after it, and a
/// rotor about the drift.
template <class Effect, class Real>
concept ActsInItsPhase =
    !NamesPhase<Effect> ||
    (form_of<Effect, Real>().sees != Sees::pair && !HoldsRotor<Effect, Real> &&
     Effect::phase != Phase::turn &&
     !form_of<Effect, Real>().writes.has_any(quantity::force | quantity::torque));

/// The phase in which the effect acts: that of what it gives, or, if it gives an acceleration or
/// writes a velocity, a spin or a place itself, the one that it names.
template <class Effect, class Real>
constexpr Phase phase_of() {
  if constexpr (NamesPhase<Effect>)
    return Effect::phase;
  else if (HoldsRotor<Effect, Real>)
    return Phase::turn;
  else if (form_of<Effect, Real>().writes.has_any(quantity::force | quantity::torque))
    return Phase::force;
  else if (BlowBetween<Effect, Real>)
    return Phase::impulse;
  else
    return Phase::kick;
}

}  // namespace tumble
