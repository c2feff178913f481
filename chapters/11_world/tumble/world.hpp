/// @file
/// A world: bodies, the effects that a scene calls for, and a step that runs what the plan says.
#pragma once

#include <tumble/make_rigid_body.hpp>
#include <tumble/one_by_one.hpp>
#include <tumble/spring_limits.hpp>
#include <tumble/step_clock.hpp>
#include <tumble/step_order.hpp>
#include <unordered_map>
#include <unordered_set>

namespace tumble {

/// Bodies and effects with a fixed time step. Everything that could change the plan goes through
/// the world, so the plan is always right. A copy of a world is another world in the same state.
///
/// `Keeping` says how the bodies are kept and visited, and changes no bit of how they move.
template <class Real, class Keeping = OneByOne<Real>>
class World {
 public:
  /// @throws std::invalid_argument if the step is negative or longer than an hour. One of no time
  /// does nothing.
  template <TurningRule<Real> Rule = Splitting>
  explicit World(const StepLength& step = {}, const Rule& rule = {})
      : step_(step),
        time_step_(time_step_of<Real>(step)),
        turning_method_(Rule::name),
        tumbling_(tumbling_effect<Real, Keeping>(rule)) {
    require_step_length(step, 0);
  }

  // --- Bodies -----------------------------------------------------------------------------------

  /// Adds a point. @throws std::invalid_argument if the name is empty or taken, or a number is not
  /// finite.
  BodyHandle add(const std::string& name, const Particle<Real>& point) {
    return append_body(name, point, nullptr);
  }

  /// Adds a body, which should come from make_rigid_body() or make_static_body().
  BodyHandle add(const std::string& name, const RigidBody<Real>& body) {
    check_top(name, body.top);
    return append_body(name, body.centre, &body.top);
  }

  /// Takes a body out, and the effects that are fixed to it.
  void remove(BodyHandle body) {
    const BodyIndex index = slots_.index_of(body);
    std::erase_if(effects_, [&](Entry<Real>& entry) {
      const auto found = std::find(entry.targets.begin(), entry.targets.end(), body);
      if (found == entry.targets.end()) return false;
      if (entry.effect->traits().joins_two) {
        std::vector<BodyHandle> kept;
        for (std::size_t i = 0; i < entry.targets.size(); i += 2)
          if (entry.targets[i] != body && entry.targets[i + 1] != body)
            kept.insert(kept.end(), {entry.targets[i], entry.targets[i + 1]});
        entry.targets = kept;
      } else {
        std::erase(entry.targets, body);
      }
      return entry.targets.empty();
    });
    call_for("'" + names_[index] + "' was removed");
    handles_.erase(names_[index]);
    kept_.take_out(index);
    slots_.release(body);
    replace_by_last(names_, index);
    replace_by_last(histories_, index);
  }

  bool contains(BodyHandle body) const { return slots_.contains(body); }
  std::size_t body_count() const { return kept_.body_count(); }
  std::size_t top_count() const { return kept_.top_count(); }

  /// @throws std::invalid_argument if no body is called so.
  BodyHandle find(const std::string& name) const {
    const auto found = handles_.find(name);
    if (found == handles_.end()) throw std::invalid_argument("no body is called '" + name + "'");
    return found->second;
  }
  const std::string& name_of(BodyHandle body) const { return names_[slots_.index_of(body)]; }
  BodyHandle handle_at(BodyIndex index) const { return slots_.handle_of(index); }

  /// The body as it is now; a point has a top that is locked about every axis.
  RigidBody<Real> body(BodyHandle body) const { return kept_.body(slots_.index_of(body)); }
  /// All of them: a reference to them, or, from a Keeping that has them in another form, a copy.
  decltype(auto) bodies() const { return kept_.bodies(); }
  /// How the bodies are kept.
  Keeping& keeping() { return kept_; }

  // --- Changes while it runs --------------------------------------------------------------------

  /// Puts another body in the place of one that is not a point: with another mass, say. It keeps
  /// its name and its effects.
  void replace(BodyHandle body, const RigidBody<Real>& by) {
    const BodyIndex index = slots_.index_of(body);
    check_centre(names_[index], by.centre);
    check_top(names_[index], by.top);
    require_top(index);
    kept_.set_body(index, by);
    note_motion(index);
    call_for("'" + names_[index] + "' was replaced");
  }

  void set_position(BodyHandle body, const Vec3<Same<Real>>& position) {
    const BodyIndex index = slots_.index_of(body);
    require_finite(names_[index] + ": position", position, "m");
    change(index, [&](RigidBody<Real>& changed) { changed.centre.position = position; });
  }

  void set_velocity(BodyHandle body, const Vec3<Same<Real>>& velocity) {
    const BodyIndex index = slots_.index_of(body);
    require_finite(names_[index] + ": velocity", velocity, "m/s");
    change(index, [&](RigidBody<Real>& changed) { changed.centre.velocity = velocity; });
    note_motion(index);
  }

  void set_orientation(BodyHandle body, const Quaternion<Real>& orientation) {
    const BodyIndex index = slots_.index_of(body);
    require_top(index);
    const Quaternion<Real> q = checked_orientation(orientation, names_[index] + ": orientation");
    change(index, [&](RigidBody<Real>& changed) { changed.top.orientation = q; });
  }

  /// Sets the angular velocity, rad/s, world axes.
  void set_angular_velocity(BodyHandle body, const Vec3<Same<Real>>& angular_velocity) {
    const BodyIndex index = slots_.index_of(body);
    require_top(index);
    change(index, [&](RigidBody<Real>& changed) {
      set_checked_angular_velocity(names_[index], changed.top, angular_velocity);
    });
    note_motion(index);
  }

  /// A blow of `impulse` N s at `point` m, world axes, between two steps.
  void apply_impulse_at(BodyHandle body, const Vec3<Same<Real>>& impulse,
                        const Vec3<Same<Real>>& point) {
    const BodyIndex index = slots_.index_of(body);
    change(index, [&](RigidBody<Real>& changed) {
      tumble::apply_impulse_at(changed, impulse, point);
      require_finite(names_[index] + ": velocity after the blow", changed.centre.velocity, "m/s");
      require_finite(names_[index] + ": angular momentum after the blow",
                     changed.top.angular_momentum_body, "kg m^2/s");
    });
    note_motion(index);
  }

  // --- Effects ----------------------------------------------------------------------------------

  /// Adds an effect for every body, those to come too.
  template <class Effect>
  requires EffectOnOne<Effect, Real> EffectHandle add(const Effect& effect) {
    return append_effect(effect, true, {});
  }

  /// Adds an effect for some bodies; for one that joins two, each first followed by its second.
  template <class Effect>
  requires EffectOnOne<Effect, Real> || PushBetween<Effect, Real> EffectHandle
  add(const Effect& effect, const std::vector<BodyHandle>& bodies) {
    return append_effect(effect, false, bodies);
  }

  void remove(EffectHandle effect) {
    const auto found = std::find_if(effects_.begin(), effects_.end(),
                                    [&](const auto& entry) { return entry.handle == effect; });
    if (found == effects_.end())
      throw std::out_of_range("stale handle: effect " + std::to_string(effect.number) +
                              " has been removed or never was in this world");
    call_for("'" + found->effect->name() + "' was removed");
    effects_.erase(found);
  }

  /// From now on the bodies whose moments differ turn by `rule`: one of turning_methods.hpp, or of
  /// the user's own.
  template <TurningRule<Real> Rule>
  void turn_by(const Rule& rule) {
    turning_method_ = Rule::name;
    tumbling_ = tumbling_effect<Real, Keeping>(rule);
    call_for("another method of turning was chosen");
  }

  /// The effects of the scene, in the order in which they came.
  const std::vector<Entry<Real>>& effects() const { return effects_; }
  /// The name of the rule by which bodies turn whose moments differ.
  const std::string& turning_method() const { return turning_method_; }
  /// The effect that does so.
  const std::shared_ptr<const AnyEffect<Real>>& tumbling() const { return tumbling_; }

  // --- Time -------------------------------------------------------------------------------------

  const StepLength& step_length() const { return step_; }
  Real time_step() const { return time_step_; }
  std::int64_t ticks() const { return ticks_; }
  /// n h, s: with two roundings, beside that of h, however many steps there were.
  Real time() const { return moment_of(ticks_, time_step_).time; }

  // --- The plan ---------------------------------------------------------------------------------

  /// What each step will do. It is made anew when something has changed what the scene calls for.
  const Plan& plan() {
    if (stale_) make_plan();
    return planned_.plan;
  }

  /// What has changed the plan since the world began, a sentence each.
  const std::vector<std::string>& news() {
    plan();
    return news_;
  }

  /// The passes of the plan, in order.
  const std::vector<Pass<Real>>& passes() {
    plan();
    return planned_.passes;
  }

  /// What the plan knows of each body.
  const std::vector<Facts>& facts() {
    plan();
    return planned_.facts;
  }
  const Slots& slots() const { return slots_; }

  /// The plan with all that carries it out.
  const Planned<Real>& planned() {
    plan();
    return planned_;
  }

  // --- The step ---------------------------------------------------------------------------------

  /// One step. @throws SimulationError if a number would become infinite or NaN; the world is then
  /// as it was before the step.
  void step() { step(Silence{}); }

  /// The same; `after_pass` is called with the effect of each pass that has run.
  template <class AfterPass>
  requires std::invocable < AfterPass, const AnyEffect<Real>
  & > void step(const AfterPass& after_pass) {
    plan();
    if (const auto stopped = kept_.step(planned_, ticks_, time_step_, after_pass)) stop(*stopped);
    ++ticks_;
  }

  /// The same step without a plan: every effect visits every body that it is meant for, one by one,
  /// and asks its predicate each time. Slow, and simple enough to be believed.
  //! [step_by_reference]
  void step_by_reference() {
    Bodies<Real> bodies = kept_.bodies(), kicked;
    const Moment<Real> moment = moment_of(ticks_, time_step_);
    const std::vector<Entry<Real>> entries = in_order<Real, Keeping>(effects_, tumbling_);
    const std::vector<Facts> facts = facts_of_all(bodies, histories_, entries, slots_);
    for (const Entry<Real>& entry : entries) {
      visit_one_by_one(entry, facts, bodies, moment);
      if (entry.effect->phase() < Phase::drift) kicked = bodies;
    }
    plan();  // its passes name the culprit
    if (const auto lost = first_lost(bodies, planned_)) {
      const BodyState<Real> state = state_of(kicked, *lost);
      stop({*lost, {.centre = state.centre, .top = state.top}});
    }
    kept_.set_bodies(std::move(bodies));
    ++ticks_;
  }
  //! [step_by_reference]

 private:
  static void check_centre(const std::string& name, const Particle<Real>& centre) {
    require_finite(name + ": position", centre.position, "m");
    require_finite(name + ": velocity", centre.velocity, "m/s");
    require_not_negative(name + ": inverse mass", centre.inverse_mass, "1/kg");
  }

  static void check_top(const std::string& name, const Top<Real>& top) {
    checked_orientation(top.orientation, name + ": orientation");
    require_finite(name + ": angular momentum", top.angular_momentum_body, "kg m^2/s");
    require_finite(name + ": inverse moments", top.inverse_moments, "1/(kg m^2)");
    if (top.inverse_moments.minCoeff() < 0)
      reject(name + ": inverse moments", top.inverse_moments, "1/(kg m^2)",
             "each must be 0 or more");
  }

  BodyHandle append_body(const std::string& name, const Particle<Real>& centre,
                         const Top<Real>* top) {
    if (name.empty()) throw std::invalid_argument("a body needs a name");
    if (handles_.contains(name))
      throw std::invalid_argument("two bodies are called '" + name + "'; names must differ");
    check_centre(name, centre);
    const BodyIndex index = kept_.append(centre, top);
    histories_.push_back({});
    names_.push_back(name);
    const BodyHandle handle = slots_.take(index);
    handles_.emplace(name, handle);
    note_motion(index);
    call_for("'" + name + "' came");
    return handle;
  }

  void require_top(BodyIndex index) const {
    if (kept_.is_point(index))
      throw std::invalid_argument("'" + names_[index] + "' is a point: it has no orientation");
  }

  /// Lets `change_body` change a body. If it throws, nothing has changed.
  template <class Change>
  void change(BodyIndex index, const Change& change_body) {
    RigidBody<Real> body = kept_.body(index);
    change_body(body);
    kept_.set_body(index, body);
  }

  /// Notes a first velocity or spin: it changes what the scene calls for.
  void note_motion(BodyIndex index) {
    History& history = histories_[index];
    if (history.has_moved && history.has_turned) return;
    const RigidBody<Real> state = kept_.body(index);
    if (!history.has_moved && state.centre.velocity != Vec3<Real>::Zero()) {
      history.has_moved = true;
      call_for("'" + names_[index] + "' got its first velocity");
    }
    if (!history.has_turned && state.top.angular_momentum_body != Vec3<Real>::Zero()) {
      history.has_turned = true;
      call_for("'" + names_[index] + "' got its first spin");
    }
  }

  template <class Effect>
  EffectHandle append_effect(Effect effect, bool everyone, const std::vector<BodyHandle>& bodies) {
    if constexpr (requires { effect.check(); }) effect.check();
    if constexpr (requires { effect.prepare(time_step_); }) effect.prepare(time_step_);
    auto erased = Keeping::erased(effect);
    const std::string name = erased->name();
    const std::size_t stride = erased->traits().joins_two ? 2 : 1;
    std::unordered_set<BodyIndex> meant_for;
    if (!everyone && (bodies.empty() || bodies.size() % stride != 0))
      throw std::invalid_argument("'" + name + "' was given " + std::to_string(bodies.size()) +
                                  " bodies; it needs " +
                                  (stride == 2 ? "pairs of them" : "at least one"));
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      const BodyIndex index = slots_.index_of(bodies[i]);
      const bool needs =
          i % stride == 0 ? erased->traits().needs_top : erased->traits().needs_second_top;
      if (needs && kept_.is_point(index))
        throw std::invalid_argument("'" + name + "' needs an orientation, and '" + names_[index] +
                                    "' is a point");
      if (stride == 2 && i % 2 == 1 && bodies[i] == bodies[i - 1])
        throw std::invalid_argument("'" + name + "' joins '" + names_[index] + "' to itself");
      if (stride == 1 && !meant_for.insert(index).second)
        throw std::invalid_argument("'" + name + "' was given '" + names_[index] + "' twice");
    }
    effects_.push_back({{++last_effect_}, std::move(erased), everyone, bodies});
    call_for("'" + name + "' came");
    return {last_effect_};
  }

  void call_for(std::string cause) {
    stale_ = true;
    causes_.push_back(std::move(cause));
  }

  void make_plan() {
    Plan old = std::move(planned_.plan);
    Bodies<Real> bodies = kept_.bodies();
    planned_ =
        tumble::make_plan(bodies, histories_, in_order<Real, Keeping>(effects_, tumbling_), slots_);
    warn_of_springs(bodies);
    for (BodyIndex body = 0; body < body_count(); ++body) {  // sums that nobody clears any more
      if (!planned_.facts[body].is_pushed) clear_force(bodies.centres[body]);
      if (!planned_.facts[body].is_torqued && !is_point(bodies, body))
        clear_torque(bodies.tops[bodies.top_of[body]]);
    }
    kept_.set_bodies(std::move(bodies));
    kept_.plan_changed(planned_);
    std::string why;
    for (std::size_t i = 0; i < std::min<std::size_t>(causes_.size(), 3); ++i)
      why.append(i ? ", " : "").append(causes_[i]);
    if (causes_.size() > 3)
      why.append(" and ").append(std::to_string(causes_.size() - 3)).append(" more");
    causes_.clear();
    if (!old.rows.empty())  // the first plan is no news
      for (std::string& sentence : news_between(old, planned_.plan, ticks_, why))
        news_.push_back(std::move(sentence));
    stale_ = false;
  }

  void warn_of_springs(const Bodies<Real>& bodies) {
    const SpringLimit<Real> limit = spring_limit(bodies, effects_, slots_);
    if (time_step_ <= limit.time_step) return;
    const Entry<Real>& entry = effects_[limit.entry];
    planned_.plan.warnings.push_back(
        "'" + entry.effect->name() + "' on '" +
        name_of(entry.targets.empty() ? handle_at(0) : entry.targets[0]) +
        "' may gain energy without bound: the time step is " + text_of(time_step_) +
        " s, and only up to " + text_of(limit.time_step) + " s can this be excluded");
  }

  void visit_one_by_one(const Entry<Real>& entry, const std::vector<Facts>& facts,
                        Bodies<Real>& bodies, const Moment<Real>& moment) {
    const AnyEffect<Real>& effect = *entry.effect;
    const std::vector<BodyIndex> targets = targets_of(entry, slots_, bodies.centres.size());
    if (effect.traits().joins_two) {
      for (std::size_t i = 0; i < targets.size(); i += 2)
        if (effect.why_skipped(facts[targets[i]], facts[targets[i + 1]]).empty())
          effect.act(bodies, {false, {targets[i], targets[i + 1]}}, moment);
    } else {
      for (const BodyIndex body : targets)
        if (effect.why_skipped(facts[body]).empty())
          effect.act(bodies, {false, {effect.traits().visits_tops ? bodies.top_of[body] : body}},
                     moment);
    }
  }

  [[noreturn]] void stop(const Stopped<Real>& stopped) {
    throw failure<Real>(names_[stopped.index], stopped, planned_.passes, kept_.bodies(), ticks_,
                        time_step_);
  }

  StepLength step_;
  Real time_step_;
  std::string turning_method_;
  std::shared_ptr<const AnyEffect<Real>> tumbling_;
  std::int64_t ticks_ = 0;

  Keeping kept_;
  std::vector<History> histories_;  // like names_, in the order of the bodies
  std::vector<std::string> names_;
  std::unordered_map<std::string, BodyHandle> handles_;
  Slots slots_;

  std::vector<Entry<Real>> effects_;
  std::uint64_t last_effect_ = 0;

  bool stale_ = true;
  std::vector<std::string> causes_;
  std::vector<std::string> news_;
  Planned<Real> planned_;
};

using Worldf = World<float>;
using Worldd = World<double>;

}  // namespace tumble
