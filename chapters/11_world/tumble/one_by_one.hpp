/// @file
/// The step, for bodies that lie in plain arrays and are visited one by one.
#pragma once

#include <tumble/body_store.hpp>
#include <tumble/guard.hpp>
#include <tumble/rotors.hpp>
#include <tumble/tumbling.hpp>

namespace tumble {

/// Keeps the bodies of a World and steps them. Chapter 12 has another, for many bodies.
template <class Real>
class OneByOne final : public BodyStore<Real> {
 public:
  explicit OneByOne(Bodies<Real> bodies = {}) : bodies_(std::move(bodies)) {}
  const Bodies<Real>& bodies() const { return bodies_; }
  void set_bodies(Bodies<Real> bodies) { bodies_ = std::move(bodies); }

  const BodyMap& map() const override { return bodies_; }
  RigidBody<Real> body(BodyIndex body) const override {
    const BodyState<Real> state = state_of(bodies_, body);
    return {.centre = state.centre, .top = state.top};
  }
  void set_body(BodyIndex body, const RigidBody<Real>& state) override {
    bodies_.centres[body] = state.centre;
    if (const BodyIndex top = bodies_.top_of[body]; top != no_index) bodies_.tops[top] = state.top;
  }
  void append(const Particle<Real>& centre, const Top<Real>* top) override {
    tumble::append(bodies_, centre, top);
  }
  void take_out(BodyIndex body) override { tumble::take_out(bodies_, body); }

  /// The form in which its steps run an effect or a rule.
  template <class Effect>
  static std::shared_ptr<const AnyEffect<Real>> erased(const Effect& effect) {
    return std::make_shared<const EffectOf<Real, Effect>>(effect);
  }
  template <class Rule>
  static std::shared_ptr<const AnyRule<Real>> erased_rule(const Rule& rule) {
    return std::make_shared<const RuleOf<Real, Rule>>(rule);
  }

  /// One step. @return the body that diverged, if one did: all are then as they were before,
  /// and so they are where an effect throws
  //! [step]
  std::optional<BodyIndex> step(const Work<Real>& work, const StepTime<Real>& moment) {
    undo_.remember(bodies_, work);
    try {
      for (const Substep<Real>& substep : work.substeps)  // of Euler's step: kick, whole, drift
        switch (substep.kind) {
          case SubstepKind::kick:
            kick_all(work, step_time_of(substep, moment));
            break;
          case SubstepKind::whole:
            run(work, Phase::impulse, bodies_, moment);
            run(work, Phase::damping, bodies_, moment);
            break;
          case SubstepKind::drift:
            drift_all(work, step_time_of(substep, moment));
        }
      run(work, Phase::drift, bodies_, moment);
    } catch (...) {  // an effect has thrown
      undo_.restore(bodies_, work);
      throw;
    }
    const std::optional<BodyIndex> diverged = first_diverged(bodies_, work);
    if (diverged) undo_.restore(bodies_, work);
    return diverged;
  }
  //! [step]

 private:
  //! [strokes]
  void kick_all(const Work<Real>& work, const StepTime<Real>& moment) {
    const Real h = moment.time_step;
    run(work, Phase::force, bodies_, moment);
    add(work.inputs, bodies_);
    run(work, Phase::kick, bodies_, moment);
    for_each_of(work.pushed, bodies_.centres,
                [&](auto& centre) { kick(centre, h), clear_force(centre); });
    for_each_of(work.torqued, bodies_.tops, [&](auto& top) { kick(top, h), clear_torque(top); });
  }
  void drift_all(const Work<Real>& work, const StepTime<Real>& moment) {
    const Real h = moment.time_step;
    for_each_of(work.movers, bodies_.centres, [&](auto& centre) { drift(centre, h); });
    const auto rotor = [&](std::size_t i, RotorAct act) {
      run_rotor(work, i, act, bodies_.tops, moment);
    };
    with_rotors(rotors_of(work), rotor, [&] {
      for_each_of(work.steady, bodies_.tops, [&](auto& top) { turn_steadily(top, h); });
      work.rule->turn(bodies_.tops, work.tumbling, h);
    });
  }
  //! [strokes]

  Bodies<Real> bodies_;
  UndoBuffer<Real> undo_;
};

}  // namespace tumble
