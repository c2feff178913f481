/// @file
/// A world: bodies, the effects that a scene calls for, and a step that does what they need.
#pragma once

#include <cstdio>
#include <functional>
#include <tumble/failure.hpp>
#include <tumble/one_by_one.hpp>
#include <tumble/other_runs.hpp>
#include <tumble/scenery.hpp>
#include <tumble/step_clock.hpp>
#include <tumble/step_limits.hpp>

namespace tumble {

/// Bodies and effects with a fixed time step; what is in it, see Scenery. A copy of a world is
/// another world in the same state, and knows the handles of the first.
///
/// `Keeping` keeps the bodies and steps them, and changes no bit of how they move.
template <class Real, class Keeping = OneByOne<Real>>
class World : public Scenery<Real, Keeping> {
  using Base = Scenery<Real, Keeping>;
  using Base::planner_, Base::bodies_, Base::change_log_, Base::time_step_, Base::marks_;

 public:
  using Base::work;

  /// @throws std::invalid_argument if the step is negative or longer than an hour. In a step
  /// of 0 s no force, kick or drift moves anything; what effects write by themselves they still
  /// write.
  template <TurningRule<Real> Rule = Splitting>
  explicit World(const StepLength& step = {}, const Rule& rule = {})
      : Scenery<Real, Keeping>(time_step_of<Real>(step)), step_(step) {
    require_step_length(step, 0);
    planner_.turn_by(Keeping::erased_rule(rule));
  }

  // --- Time -------------------------------------------------------------------------------------

  const StepLength& step_length() const { return step_; }
  Real time_step() const { return time_step_; }
  std::int64_t ticks() const { return ticks_; }
  /// n h, s: with two roundings at most, beside that of h, however many steps there were.
  Real time() const { return step_time().time; }
  /// When the next step happens.
  StepTime<Real> step_time() const { return step_time_of(ticks_, time_step_); }

  /// How all bodies move now: with restore() a step, or a thousand, can be taken back.
  Snapshot<Real> save() const { return bodies_.snapshot(ticks_, planner_.alone()); }
  /// All bodies move as they did when the snapshot was saved, and the steps from there on have the
  /// same bits, unless the scene has been changed since, or a push for one step was to come then:
  /// such pushes are dropped. The bodies are taken in the order of the world.
  /// @throws std::invalid_argument if there are more bodies or tops than then, or fewer.
  void restore(const Snapshot<Real>& then) {
    require_as_many("snapshot", then.positions.size(), then.orientations.size(), bodies_);
    planner_.end_inputs(bodies_);
    marks_.forget_all();
    bodies_.restore(then);
    planner_.restore_flags(then.has_moved, then.has_turned, bodies_);
    ticks_ = then.ticks;
  }

  /// The same as save(), for each frame of a game that may have to go back: after the first mark,
  /// and until a body comes or goes, it costs what can move and what was changed, and not what
  /// rests. A mark is for this world, or a copy of it, alone.
  Mark<Real> mark() { return marks_.mark(ticks_, bodies_, planner_); }
  /// See restore() of a Snapshot; it costs what can move now, or could then, and what was changed.
  /// @throws std::invalid_argument if there are more bodies or tops than then, or fewer.
  void restore(const Mark<Real>& then) {
    marks_.restore(then, bodies_, planner_);
    ticks_ = then.ticks;
  }

  // --- The plan ---------------------------------------------------------------------------------

  /// What each step does, as a table. It is made when one asks; what it tells of is always right.
  Plan plan() const {
    return {rows_of(planner_, bodies_), accuracy_of(work()), warnings(), unknown_limits(work())};
  }
  /// What may go wrong as the bodies are now, such as a step too long for a spring.
  std::vector<std::string> warnings() const {
    const StepLimit<Real> limit = step_limit();
    if (time_step_ <= limit.time_step) return {};
    const std::string& name = work().effects[limit.entry].effect->name();
    std::string warning = "'" + name + "' on '" + bodies_.name_of(limit.body) +
                          "' may gain energy without bound: the time step is " +
                          text_of(time_step_) + " s, and only up to " + text_of(limit.time_step) +
                          " s can this be excluded";
    if (time_step_ <= limit.at_rest) {
      const BodyIndex body = limit.spinning;
      const Vec3<Real> rotors =
          nutating_momentum<Real>(work(), bodies_.top_of(body), bodies_.body(body).top, time());
      const std::string named = "'" + bodies_.name_of(body) + "'";
      warning +=
          ", since " +
          (rotors == Vec3<Real>::Zero() ? named + " spins" : "a wheel spins in " + named) +
          ", and its nutation turns by " +
          text_of(std::round(time_step_ * limit.nutation_rate * 180 / std::numbers::pi_v<Real>)) +
          " degrees in a step";
    }
    return {warning};
  }

  /// Up to which step no effect that has a response() can feed on itself, as the bodies are now.
  StepLimit<Real> step_limit() const { return tumble::step_limit(work(), bodies_, time()); }

  /// What has changed the plan since the world began, a sentence each; the last hundred of them.
  std::vector<std::string> change_log() const {
    ChangeLog now = change_log_;
    if (now.is_pending()) now.tell(work(), bodies_.size(), ticks_);
    return now.sentences();
  }

  /// From now on a warning is given to this function, and not to standard error.
  void on_warning(std::function<void(const std::string&)> tell) { tell_ = std::move(tell); }

  // --- The step ---------------------------------------------------------------------------------

  /// One step. @throws SimulationError if a number would become infinite or NaN, and whatever an
  /// effect throws; the world is then as it was before the step.
  void step() {
    if (change_log_.is_pending()) tell_changes();
    const std::optional<BodyIndex> diverged = bodies_.kept().step(work(), step_time());
    if (diverged) stop(*diverged);
    ++ticks_;
    planner_.end_inputs(bodies_);
  }

  /// The same step without groups: see step_by_reference() in other_runs.hpp.
  void step_by_reference() {
    step_on_copy([&](Bodies<Real>& bodies, const auto& index_of) {
      tumble::step_by_reference(bodies, work(), planner_.alone(), step_time(), index_of);
    });
  }

  /// The same step with nothing known of any body: see step_exhaustively() in other_runs.hpp.
  void step_exhaustively() {
    step_on_copy([&](Bodies<Real>& bodies, const auto& index_of) {
      tumble::step_exhaustively(bodies, work(), step_time(), index_of);
    });
  }

 private:
  /// Tells of what has changed since the last step.
  void tell_changes() {
    change_log_.tell(work(), bodies_.size(), ticks_);
    if (!std::exchange(this->limit_changed_, false)) return;
    for (const std::string& warning : warnings())
      if (tell_)
        tell_(warning);
      else
        std::fprintf(stderr, "warning: %s\n", warning.c_str());
  }

  template <class Step>
  void step_on_copy(const Step& step) {
    Bodies<Real> bodies = bodies_.kept().bodies();
    step(bodies, [this](BodyHandle body) { return bodies_.index_of(body); });
    if (const std::optional<BodyIndex> diverged = first_diverged(bodies, work())) stop(*diverged);
    bodies_.kept().set_bodies(std::move(bodies));
    marks_.forget_all();
    ++ticks_;
    planner_.end_inputs(bodies_);
  }

  [[noreturn]] void stop(BodyIndex diverged) {
    throw failure<Real>(bodies_.name_of(diverged), diverged, this->bodies(), work(), ticks_,
                        time_step_);
  }

  StepLength step_;
  std::int64_t ticks_ = 0;
  std::function<void(const std::string&)> tell_;
};

using Worldf = World<float>;
using Worldd = World<double>;

}  // namespace tumble

#ifdef TUMBLE_COMPILED_WORLDS  // inside the course alone
#include <support/compiled_worlds.hpp>
#endif
