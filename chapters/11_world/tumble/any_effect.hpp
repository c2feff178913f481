/// @file
/// An effect of whatever type, so that a world can keep all of them in one list.
#pragma once

#include <memory>
#include <tumble/effect_members.hpp>
#include <tumble/index_set.hpp>
#include <tumble/rotors.hpp>
#include <utility>

namespace tumble {

/// One virtual call runs the effect on all its members; none is made for each body.
//! [any_effect]
template <class Real>
class AnyEffect {
 public:
  virtual ~AnyEffect() = default;
  const EffectTraits<Real>& traits() const { return traits_; }
  const std::string& name() const { return traits_.name; }
  Phase phase() const { return traits_.phase; }
  /// Runs the effect's function on bodies one by one, or on pairs. `act` says which part of its
  /// work a rotor does.
  virtual void run(Bodies<Real>& bodies, const Members& members, const StepTime<Real>& at,
                   RotorAct act) const = 0;
  /// Empty if the body needs the effect, else why it does not. One on two is asked without flags:
  /// empty if any pair needs it.
  virtual std::string_view skip_reason(const BodyFlags& flags) const = 0;
  /// The energy (J) that the effect stores for a body, or for two, where it knows one.
  virtual Real potential_energy(const BodyState<Real>& first,
                                const BodyState<Real>& second) const = 0;
  /// The angular momentum of a rotor at `time` (s), kg m²/s, body axes; of other effects 0.
  virtual Vec3<Real> rotor_angular_momentum_body(Real time) const = 0;
  /// How it answers what the body does, or the two; all zero if it does not say, or can't feed on
  /// itself.
  virtual Response<Real> response(const BodyState<Real>& first,
                                  const BodyState<Real>& second) const = 0;
  //! [any_effect]
  /// The same effect prepared for another time step (s); null of one that prepares for none.
  virtual std::shared_ptr<const AnyEffect> prepared(Real time_step) const = 0;

 protected:
  explicit AnyEffect(EffectTraits<Real> traits) : traits_(std::move(traits)) {}

 private:
  EffectTraits<Real> traits_;
};

/// The effect in the form `Erased`. One deleter serves all forms: std::make_shared() would compile
/// one for each.
template <class Erased, class Real, class Effect>
std::shared_ptr<const AnyEffect<Real>> shared_as(const Effect& effect) {
  return std::unique_ptr<const AnyEffect<Real>>(new Erased(effect));
}

/// @cond the base class says what it does
/// What prepared() returns, of an effect in the form `Erased`.
template <class Erased, class Real, class Effect>
std::shared_ptr<const AnyEffect<Real>> prepared_as([[maybe_unused]] Effect effect,
                                                   [[maybe_unused]] Real time_step) {
  if constexpr (requires { effect.prepare(time_step); }) {
    effect.prepare(time_step);
    return shared_as<Erased, Real>(effect);
  } else {
    return nullptr;
  }
}

/// AnyEffect for one type of effect.
template <class Real, class Effect>
class EffectOf : public AnyEffect<Real> {
  static constexpr Form form = form_of<Effect, Real>();
  using Answer = AnswerOf<Real, Effect>;
  static_assert(std::is_void_v<Answer> || std::is_same_v<Answer, Response<Real>> ||
                    std::is_same_v<Answer, NoResponse>,
                "response() returns a Response or, of what can't feed on itself, NoResponse");
  static_assert(form.count == 1, "an effect has exactly one function of those in forms.hpp");
  static_assert(ActsInItsPhase<Effect, Real>,
                "a force or a torque acts in the phase force, a blow in the phase impulse and a "
                "rotor, but nothing else, in the phase turn, whatever the effect names");
  static_assert(HeardMembers<Real, Effect>::value);

 public:
  explicit EffectOf(const Effect& effect)
      : AnyEffect<Real>(traits_of<Real>(effect)), effect_(effect) {}
  const Effect& effect() const { return effect_; }

  void run(Bodies<Real>& bodies, const Members& members, const StepTime<Real>& at,
           [[maybe_unused]] RotorAct act) const override {
    if constexpr (HoldsRotor<Effect, Real>) {
      const Vec3<Real> H = effect_.rotor_angular_momentum_body(at.time);
      for (const BodyIndex i : members.indices) act_on<Real>(bodies.tops[i], act, H, at.time_step);
    } else if constexpr (form.sees == Sees::centre) {
      for (const BodyIndex i : members.indices)
        give_to(bodies.centres[i], effect_, bodies.centres[i], at);
    } else if constexpr (form.sees == Sees::top) {
      for (const BodyIndex i : members.indices)
        give_to(bodies.tops[i], effect_, bodies.tops[i], at);
    } else if constexpr (form.sees == Sees::body) {
      for (const BodyIndex body : members.indices) {
        Top<Real> none;
        const BodyInPlace<Real> one = in_place(bodies, body, none);
        give_to_both(one.centre, one.top, effect_, at);
      }
    } else if constexpr (FindsPairs<Effect, Real>) {
      std::vector<BodyPair> found;
      effect_.find_pairs(std::as_const(bodies), found);
      for (const BodyPair& pair : found) run_on(bodies, pair, at);
    } else {
      for (const BodyPair& pair : members.pairs) run_on(bodies, pair, at);
    }
  }

  std::string_view skip_reason(const BodyFlags& flags) const override {
    if constexpr (form.sees != Sees::pair)
      return tumble::skip_reason<Real>(effect_, flags, this->traits().writes);
    else if constexpr (requires { effect_.skip_reason(); })
      return effect_.skip_reason();
    else
      return {};
  }

  Real potential_energy([[maybe_unused]] const BodyState<Real>& first,
                        [[maybe_unused]] const BodyState<Real>& second) const override {
    if constexpr (requires { effect_.potential_energy(first); })
      return effect_.potential_energy(first);
    else if constexpr (requires { effect_.potential_energy(first, second); })
      return effect_.potential_energy(first, second);
    else
      return 0;
  }

  Vec3<Real> rotor_angular_momentum_body([[maybe_unused]] Real time) const override {
    if constexpr (HoldsRotor<Effect, Real>)
      return effect_.rotor_angular_momentum_body(time);
    else
      return Vec3<Real>::Zero();
  }

  Response<Real> response([[maybe_unused]] const BodyState<Real>& first,
                          [[maybe_unused]] const BodyState<Real>& second) const override {
    if constexpr (!std::is_same_v<Answer, Response<Real>>)
      return {};
    else if constexpr (requires { effect_.response(first); })
      return effect_.response(first);
    else
      return effect_.response(first, second);
  }

  std::shared_ptr<const AnyEffect<Real>> prepared(Real time_step) const override {
    return prepared_as<EffectOf>(effect_, time_step);
  }

 private:
  void run_on(Bodies<Real>& bodies, const BodyPair& pair, const StepTime<Real>& at) const {
    Top<Real> none, second_none;
    give_to_pair<Real>(in_place(bodies, pair.first, none),
                       in_place(bodies, pair.second, second_none), effect_, at);
  }

  static BodyInPlace<Real> in_place(Bodies<Real>& bodies, BodyIndex body, Top<Real>& none) {
    const BodyIndex top = bodies.top_of[body];
    return {bodies.centres[body], top == no_index ? none : bodies.tops[top]};
  }

  Effect effect_;
};
/// @endcond

}  // namespace tumble
