/// @file
/// One line of a plan: an effect of whatever type, run on a group of bodies.
#pragma once

#include <memory>
#include <tumble/effect.hpp>

namespace tumble {

/// Which array elements a pass visits: centres, or tops for an effect on tops, or pairs of bodies,
/// the first and the second in turn.
//! [group]
struct Group {
  bool everyone = false;           ///< the whole array, and members stays empty
  std::vector<BodyIndex> members;  ///< else these
};

/// Calls `kernel` with each element of `array` that the group names.
template <class Element, class Kernel>
void for_each_of(const Group& group, std::vector<Element>& array, const Kernel& kernel) {
  if (group.everyone)
    for (Element& element : array) kernel(element);
  else
    for (const BodyIndex index : group.members) kernel(array[index]);
}

/// Calls `kernel` with each index below `count` that the group names.
template <class Kernel>
void for_each_index(const Group& group, std::size_t count, const Kernel& kernel) {
  if (group.everyone)
    for (BodyIndex index = 0; index < count; ++index) kernel(index);
  else
    for (const BodyIndex index : group.members) kernel(index);
}
//! [group]

/// What of a spring limits the time step.
template <class Real>
struct SpringTerms {
  Real stiffness = 0;   ///< N/m
  Real damping = 0;     ///< N s/m
  Real arm_first = 0;   ///< how far from the centre of mass it holds the (first) body, m
  Real arm_second = 0;  ///< and the second
};

/// What a world knows of an effect without asking it about a body.
template <class Real>
struct EffectTraits {
  std::string name;
  Phase phase = Phase::force;
  std::string_view reads, writes;
  bool joins_two = false;           ///< it visits pairs of bodies
  bool visits_tops = false;         ///< its group names tops
  bool gives_force = false;         ///< it adds to Particle::force
  bool gives_acceleration = false;  ///< it changes velocities in the kick
  bool gives_torque = false;        ///< it adds to Top::torque
  bool gives_motion = false;        ///< it can set a resting centre in motion
  bool gives_spin = false;          ///< it can set a resting top turning
  bool needs_top = false;           ///< the (first) body must not be a point
  bool needs_second_top = false;
  bool stores_energy = false;
  SpringTerms<Real> spring_terms;  ///< without stiffness, if it is no spring
};

/// An effect of any type, so that a world can keep all of them in one list. The call is virtual
/// once for each pass, never for each body.
template <class Real>
class AnyEffect {
 public:
  virtual ~AnyEffect() = default;
  const EffectTraits<Real>& traits() const { return traits_; }
  const std::string& name() const { return traits_.name; }
  Phase phase() const { return traits_.phase; }
  /// Empty if the body needs the effect, else why it does not.
  virtual std::string_view why_skipped(const Facts& facts) const = 0;
  /// The same for a pair.
  virtual std::string_view why_skipped(const Facts& first, const Facts& second) const = 0;
  /// Runs the kernel on a group.
  virtual void act(Bodies<Real>& bodies, const Group& group, const Moment<Real>& moment) const = 0;
  /// What the effect gives one body in the force phase, or as a force m a in the kick: zero for
  /// all other effects.
  virtual Push<Real> push_on(const BodyState<Real>& body, Real time) const = 0;
  /// What it gives a pair.
  virtual PairPush<Real> push_on(const BodyState<Real>& first, const BodyState<Real>& second,
                                 Real time) const = 0;
  /// The energy (J) that the effect stores for a body, where it knows one.
  virtual Real potential_energy(const BodyState<Real>& body) const = 0;
  virtual Real potential_energy(const BodyState<Real>& first,
                                const BodyState<Real>& second) const = 0;

 protected:
  explicit AnyEffect(EffectTraits<Real> traits) : traits_(std::move(traits)) {}

 private:
  EffectTraits<Real> traits_;
};

/// Adds what an effect gives to what already acts on the body.
template <class Real>
void add_push(Bodies<Real>& bodies, BodyIndex body, const Push<Real>& push) {
  bodies.centres[body].force += push.force;
  if (!is_point(bodies, body)) bodies.tops[bodies.top_of[body]].torque += push.torque;
}

/// Listens to the passes of a step, and has nothing to say.
struct Silence {
  template <class Effect>
  void operator()(const Effect&) const {}
};

/// Runs an effect's kernel on one centre, or on one top.
template <class Effect, class Real>
void visit(const Effect& effect, Particle<Real>& centre, const Moment<Real>& moment) {
  if constexpr (ForceOnCentre<Effect, Real>)
    centre.force += effect.force(centre, moment.time);
  else if constexpr (AccelerationOfCentre<Effect, Real>)
    accelerate<Real>(centre, effect.acceleration(centre, moment.time), moment.time_step);
  else
    effect.act(centre, moment);
}

template <class Effect, class Real>
void visit(const Effect& effect, Top<Real>& top, const Moment<Real>& moment) {
  if constexpr (TorqueOnTop<Effect, Real>)
    top.torque += effect.torque(top, moment.time);
  else
    effect.act(top, moment);
}

/// @cond the base class says what it does
/// AnyEffect for one type of effect.
template <class Real, class Effect>
class EffectOf : public AnyEffect<Real> {
  static constexpr bool force_on_centre = ForceOnCentre<Effect, Real>;
  static constexpr bool force_on_body = ForceOnBody<Effect, Real>;
  static constexpr bool push_on_body = PushOnBody<Effect, Real>;
  static constexpr bool push_between = PushBetween<Effect, Real>;
  static constexpr bool accelerates = AccelerationOfCentre<Effect, Real>;
  static constexpr bool on_centre = ActsOnCentre<Effect, Real>;
  static constexpr bool torque_on_top = TorqueOnTop<Effect, Real>;
  static constexpr bool acts_on_top = ActsOnTop<Effect, Real>;
  static constexpr bool on_top = torque_on_top || acts_on_top;
  static_assert(force_on_centre + force_on_body + push_on_body + push_between + accelerates +
                        on_centre + torque_on_top + acts_on_top ==
                    1,
                "an effect has exactly one kernel, in one of the forms in effect.hpp");

 public:
  explicit EffectOf(const Effect& effect) : AnyEffect<Real>(traits_of(effect)), effect_(effect) {}
  const Effect& effect() const { return effect_; }

  std::string_view why_skipped(const Facts& facts) const override {
    return tumble::why_skipped<Real>(effect_, facts);
  }
  std::string_view why_skipped(const Facts& first, const Facts& second) const override {
    if (first.is_static && second.is_static) return "nothing can move either of the two";
    if constexpr (requires { effect_.why_skipped(first, second); })
      return effect_.why_skipped(first, second);
    else
      return {};
  }

  void act(Bodies<Real>& bodies, const Group& group, const Moment<Real>& moment) const override {
    if constexpr (force_on_centre || accelerates || on_centre) {
      for_each_of(group, bodies.centres,
                  [&](Particle<Real>& centre) { visit(effect_, centre, moment); });
    } else if constexpr (on_top) {
      for_each_of(group, bodies.tops, [&](Top<Real>& top) { visit(effect_, top, moment); });
    } else if constexpr (push_between) {
      for (std::size_t i = 0; i < group.members.size(); i += 2) {
        const BodyIndex first = group.members[i], second = group.members[i + 1];
        const PairPush<Real> push =
            effect_.push(state_of(bodies, first), state_of(bodies, second), moment.time);
        add_push<Real>(bodies, first, {push.force_on_first, push.torque_on_first});
        add_push<Real>(bodies, second, {-push.force_on_first, push.torque_on_second});
      }
    } else {
      for_each_index(group, bodies.centres.size(), [&](BodyIndex body) {
        if constexpr (force_on_body)
          bodies.centres[body].force += effect_.force(state_of(bodies, body), moment.time);
        else
          add_push(bodies, body, effect_.push(state_of(bodies, body), moment.time));
      });
    }
  }

  Push<Real> push_on([[maybe_unused]] const BodyState<Real>& body,
                     [[maybe_unused]] Real time) const override {
    if constexpr (force_on_centre)
      return {.force = effect_.force(body.centre, time)};
    else if constexpr (accelerates)
      return {.force = mass_of(body.centre) * effect_.acceleration(body.centre, time)};
    else if constexpr (force_on_body)
      return {.force = effect_.force(body, time)};
    else if constexpr (push_on_body)
      return effect_.push(body, time);
    else if constexpr (torque_on_top)
      return {.torque = effect_.torque(body.top, time)};
    else
      return {};
  }
  PairPush<Real> push_on([[maybe_unused]] const BodyState<Real>& first,
                         [[maybe_unused]] const BodyState<Real>& second,
                         [[maybe_unused]] Real time) const override {
    if constexpr (push_between)
      return effect_.push(first, second, time);
    else
      return {};
  }
  Real potential_energy([[maybe_unused]] const BodyState<Real>& body) const override {
    if constexpr (requires { effect_.potential_energy(body); })
      return effect_.potential_energy(body);
    else
      return 0;
  }
  Real potential_energy([[maybe_unused]] const BodyState<Real>& first,
                        [[maybe_unused]] const BodyState<Real>& second) const override {
    if constexpr (requires { effect_.potential_energy(first, second); })
      return effect_.potential_energy(first, second);
    else
      return 0;
  }

 private:
  static constexpr bool stores_energy =
      requires(const Effect& effect, const BodyState<Real>& body) {
    effect.potential_energy(body);
  }
  || requires(const Effect& effect, const BodyState<Real>& body) {
    effect.potential_energy(body, body);
  };

  static EffectTraits<Real> traits_of(const Effect& effect) {
    EffectTraits<Real> traits;
    traits.name = effect.name;
    traits.phase = accelerates ? Phase::kick : Phase::force;
    if constexpr (on_centre || acts_on_top) traits.phase = Effect::phase;
    traits.joins_two = push_between;
    traits.visits_tops = on_top;
    traits.gives_force = force_on_centre || force_on_body || push_on_body || push_between;
    traits.gives_acceleration = accelerates;
    traits.gives_torque = torque_on_top || push_on_body || push_between;
    if constexpr (requires { effect.gives_torque(); }) traits.gives_torque = effect.gives_torque();
    traits.gives_motion = traits.gives_force || accelerates || traits.phase == Phase::impulse;
    traits.gives_spin = traits.gives_torque || (acts_on_top && traits.phase == Phase::impulse);
    traits.needs_top = on_top;
    if constexpr (requires { effect.needs_top(); }) traits.needs_top = effect.needs_top();
    if constexpr (requires { effect.needs_second_top(); })
      traits.needs_second_top = effect.needs_second_top();
    traits.stores_energy = stores_energy;
    if constexpr (requires { effect.spring_terms(); }) traits.spring_terms = effect.spring_terms();
    traits.reads = torque_on_top ? "orientation, spin"
                   : on_top      ? "angular momentum"
                   : on_centre   ? "velocity"
                   : force_on_body || push_on_body || push_between
                       ? "position, velocity, orientation, spin"
                       : "position, velocity";
    if constexpr (requires { Effect::reads; }) traits.reads = Effect::reads;
    traits.writes = torque_on_top         ? "torque"
                    : traits.gives_torque ? "force, torque"
                    : traits.gives_force  ? "force"
                    : on_top              ? "angular momentum"
                                          : "velocity";
    if constexpr (requires { Effect::writes; }) traits.writes = Effect::writes;
    return traits;
  }

  Effect effect_;
};
/// @endcond

}  // namespace tumble
