/// @file
/// The step, for bodies that lie in plain arrays and are visited one by one.
#pragma once

#include <tumble/body_store.hpp>
#include <tumble/guard.hpp>
#include <tumble/step_order.hpp>

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

  /// The form in which its steps run an effect or a motion.
  template <class Effect>
  static std::shared_ptr<const AnyEffect<Real>> erased(const Effect& effect) {
    return shared_as<EffectOf<Real, Effect>, Real>(effect);
  }

  /// One step. @return the body that diverged, if one did: all are then as they were before,
  /// and so they are where an effect throws
  //! [step]
  std::optional<BodyIndex> step(const StepPlan<Real>& plan, const StepTime<Real>& at) {
    undo_.remember(bodies_, plan);
    try {
      for (const Pass<Real> pass : Passes(plan))
        run(pass, plan, members_of(pass, plan), bodies_, at);
    } catch (...) {  // an effect has thrown
      undo_.restore(bodies_, plan);
      throw;
    }
    const std::optional<BodyIndex> diverged = first_diverged(bodies_, plan);
    if (diverged) undo_.restore(bodies_, plan);
    return diverged;
  }
  //! [step]

 private:
  Bodies<Real> bodies_;
  UndoBuffer<Real> undo_;
};

}  // namespace tumble
