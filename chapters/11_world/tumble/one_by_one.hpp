/// @file
/// The simplest way to keep the bodies of a world and to run its passes: one after another.
#pragma once

#include <optional>
#include <tumble/guard.hpp>

namespace tumble {

/// Bodies in plain arrays, and passes that visit them one by one.
///
/// A World leaves to this class where its bodies are and how a pass gets to them. Chapter 12 has
/// another, for many bodies.
template <class Real>
class OneByOne {
 public:
  std::size_t body_count() const { return bodies_.centres.size(); }
  std::size_t top_count() const { return bodies_.tops.size(); }
  bool is_point(BodyIndex body) const { return tumble::is_point(bodies_, body); }
  const Bodies<Real>& bodies() const { return bodies_; }
  void set_bodies(Bodies<Real> bodies) { bodies_ = std::move(bodies); }

  /// The body; a point has a top that is locked about every axis.
  RigidBody<Real> body(BodyIndex body) const {
    const BodyState<Real> state = state_of(bodies_, body);
    return {.centre = state.centre, .top = state.top};
  }
  /// Of a point only the centre is kept.
  void set_body(BodyIndex body, const RigidBody<Real>& state) {
    bodies_.centres[body] = state.centre;
    if (!is_point(body)) bodies_.tops[bodies_.top_of[body]] = state.top;
  }

  /// Appends a body; `top` is null for a point. @return its index
  BodyIndex append(const Particle<Real>& centre, const Top<Real>* top) {
    return tumble::append(bodies_, centre, top);
  }
  /// Takes a body out; the last one gets its place.
  void take_out(BodyIndex body) { tumble::take_out(bodies_, body); }

  /// The effect in the form that step() runs.
  template <class Effect>
  static std::shared_ptr<const AnyEffect<Real>> erased(const Effect& effect) {
    return std::make_shared<const EffectOf<Real, Effect>>(effect);
  }

  /// Called when there is another plan.
  void plan_changed(const Planned<Real>&) {}

  /// Step number `tick`; `after_pass` is called with the effect of each pass that has run.
  /// @return why it could not be taken, if so; the bodies are then as they were before it
  //! [step]
  template <class AfterPass>
  std::optional<Stopped<Real>> step(const Planned<Real>& planned, std::int64_t tick, Real time_step,
                                    const AfterPass& after_pass) {
    const Moment<Real> moment = moment_of(tick, time_step);
    remember(bodies_, before_);
    for (const Pass<Real>& pass : planned.passes) {
      pass.effect->act(bodies_, pass.group, moment);
      after_pass(*pass.effect);
    }
    const std::optional<BodyIndex> lost = first_lost(bodies_, planned);
    return lost ? std::optional(taken_back(planned, *lost, moment)) : std::nullopt;
  }
  //! [step]

  /// One pass of the plan alone, to measure what it costs.
  void run_pass(const Planned<Real>& planned, std::size_t pass, const Moment<Real>& moment) {
    planned.passes[pass].effect->act(bodies_, planned.passes[pass].group, moment);
  }

 private:
  /// The body as it was before it drifted: the step once more, as far as that. Then all is as it
  /// was before the step.
  Stopped<Real> taken_back(const Planned<Real>& planned, BodyIndex lost,
                           const Moment<Real>& moment) {
    restore(bodies_, before_);
    for (const Pass<Real>& pass : planned.passes)
      if (pass.effect->phase() < Phase::drift) pass.effect->act(bodies_, pass.group, moment);
    const Stopped<Real> stopped{lost, this->body(lost)};
    restore(bodies_, before_);
    return stopped;
  }

  Bodies<Real> bodies_;
  Before<Real> before_;
};

}  // namespace tumble
