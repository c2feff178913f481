/// @file
/// A world: bodies, the effects that a scene calls for, and a step that does what they need.
///
/// What works on one stands in other headers: energy.hpp and ledger.hpp for its energy, drawing.hpp
/// for what is drawn between two steps, snapshot_file.hpp for a file, in_packs.hpp for many bodies.
#pragma once

#include <cstdio>
#include <functional>
#include <tumble/change_log.hpp>
#include <tumble/check_body.hpp>
#include <tumble/checkpoints.hpp>
#include <tumble/failure.hpp>
#include <tumble/one_by_one.hpp>
#include <tumble/other_runs.hpp>
#include <tumble/plan.hpp>
#include <tumble/step_clock.hpp>
#include <tumble/step_limits.hpp>

namespace tumble {

/// A scene's bodies and effects, with a fixed time step. Every function that could change the plan
/// tells the planner, so that the plan stays right. A copy of a world is another world in the same
/// state, and knows the handles of the first. So it is a way back even after bodies and effects
/// have come and gone: `world = copy` brings back those that went, with their names and handles,
/// and takes away those that have come since. A handle that was given out since may then be given
/// out once more.
///
/// `Backend` keeps the bodies in arrays and steps them, and changes no bit of how they move.
///
/// Every function that is given a handle, but for contains(), throws std::out_of_range if that is
/// stale, empty or another world's. It finds a body at once, however many there are, and looks for
/// an effect among all of the scene. An effect that changes the world inside a step meets
/// std::logic_error, and so does a `watch` of step(): changes come between steps.
template <class Real, class Backend = OneByOne<Real>>
class World {
 public:
  /// A world without bodies, whose steps last `step`, by default 1/60 s, and whose bodies turn by
  /// `rule` where their moments differ, by default Splitting. In a step of 0 s no force, kick or
  /// drift moves anything; what effects write by themselves they still write.
  /// @throws std::invalid_argument if the step is negative or longer than an hour.
  template <TurningRule<Real> Rule = Splitting>
  explicit World(const StepLength& step = {}, const Rule& rule = {})
      : time_{.step = step},
        time_step_(time_step_of<Real>(step)),
        planner_(motions_of<Real, Backend>(rule)) {
    require_step_length(step, 0);
  }

  // --- The step ---------------------------------------------------------------------------------

  /// One step. `watch` is called when all warnings are told, and before anything moves; it may look
  /// at the world, and not change it.
  /// If it throws, the world is as it was before the step. What push_at() gave is kept too, and
  /// acts in the next step that can be taken; restore() drops it. What an effect throws comes
  /// through.
  /// @throws SimulationError if a number would become infinite or NaN.
  void step(const std::function<void()>& watch = {}) {
    require_between_steps("another step can't be taken");
    if (change_log_.is_pending()) report_changes();
    const InsideStep inside(inside_);
    if (watch) watch();
    const std::optional<BodyIndex> diverged = backend_.step(step_plan(), step_time());
    if (diverged) throw_failure(*diverged);
    ++time_.ticks;
    planner_.end_inputs(named_bodies());
  }

  // --- Bodies -----------------------------------------------------------------------------------

  /// Adds a point, or a body: the `body` of what make_rigid_body() returns, or make_static_body().
  /// Here each number is checked by itself, and not whether a body can have such moments. Its
  /// orientation is normalised, and forces that were gathered in it are dropped: see push_at().
  /// @throws std::invalid_argument if the name is empty or taken, if a number is not finite, if an
  /// inverse mass or moment is negative, if the orientation is not nearly of norm 1, as
  /// checked_orientation() has it, or if there is angular momentum about a locked axis.
  BodyHandle add(const std::string& name, const Particle<Real>& point) {
    registry_.require_free(name);
    return append_body(name, point, nullptr);
  }
  BodyHandle add(const std::string& name, const RigidBody<Real>& body) {
    registry_.require_free(name);
    return append_body(name, body.centre, &body.top);
  }
  /// The same without a name, for many of a kind: a sentence calls it "body 7", after its slot.
  /// @throws std::invalid_argument as above.
  BodyHandle add(const Particle<Real>& point) { return append_body({}, point, nullptr); }
  BodyHandle add(const RigidBody<Real>& body) { return append_body({}, body.centre, &body.top); }

  /// Removes a body. Effects for some bodies no longer visit it, and pairs with it are dissolved;
  /// an effect that has no body left goes too.
  void remove(BodyHandle body) {
    require_between_steps("a body can't be removed");
    const BodyIndex index = registry_.index_of(body);
    change_log_.note({"'", name_of(body), "' was removed"});
    limit_changed_ |= planner_.is_limiting(index);
    checkpoints_.forget_all();
    planner_.forget_body(body, named_bodies());
    backend_.take_out(index);
    registry_.take_out(body);
    planner_.list_pairs_again(index, named_bodies());
  }

  /// False once the body was removed, and of a handle that is empty or another world's.
  bool contains(BodyHandle body) const { return registry_.contains(body); }
  /// How many bodies there are, points too.
  std::size_t body_count() const { return registry_.size(); }
  /// How many of them are not points.
  std::size_t top_count() const { return named_bodies().top_count(); }
  /// The body with that name, looked up in a hash table.
  /// @throws std::invalid_argument if no body has that name.
  BodyHandle find(const std::string& name) const { return registry_.find(name); }
  /// Its name, or "body 7" of one without.
  std::string name_of(BodyHandle body) const { return registry_.name_of(registry_.index_of(body)); }
  /// All bodies, in the order of the arrays; each call makes the list anew.
  std::vector<BodyHandle> handles() const {
    std::vector<BodyHandle> handles;
    for (BodyIndex index = 0; index < registry_.size(); ++index)
      handles.push_back(registry_.handle_at(index));
    return handles;
  }
  /// The body with that place in the arrays.
  /// @throws std::out_of_range if there are not so many.
  BodyHandle handle_at(BodyIndex index) const {
    if (index >= registry_.size())
      throw std::out_of_range(joined({"there is no body at place ", std::to_string(index), " of ",
                                      std::to_string(registry_.size())}));
    return registry_.handle_at(index);
  }
  /// The place of a body in the arrays. It may change when another body is removed.
  BodyIndex index_of(BodyHandle body) const { return registry_.index_of(body); }
  /// Whether it has no orientation.
  bool is_point(BodyHandle body) const { return named_bodies().is_point(registry_.index_of(body)); }
  /// All of them. Of a World a reference, const Bodies<Real>&, to its own arrays, which go on with
  /// it and hold as long as it does; of ManyBodies a copy, Bodies<Real>, that each call makes anew.
  decltype(auto) bodies() const { return backend_.bodies(); }

  /// Puts another body in the place of one that is not a point, or another point in the place of a
  /// point: with another mass, say. It keeps its name and its effects. A top holds L and not ω:
  /// with other moments it turns at another rate, unless set_angular_velocity() sets the old one
  /// again.
  /// @throws std::invalid_argument if one is a point and the other is not, or if add() would not
  /// take the other.
  void replace(BodyHandle body, const RigidBody<Real>& by) {
    require_between_steps("a body can't be replaced");
    check_body(name_of(body), by.centre);
    check_body(name_of(body), by.top);
    require_kind(body, false);
    RigidBody<Real> kept = by;
    kept.top.orientation = renormalized(by.top.orientation);
    put_in_place(body, kept);
  }
  void replace(BodyHandle body, const Particle<Real>& by) {
    require_between_steps("a body can't be replaced");
    check_body(name_of(body), by);
    require_kind(body, true);
    put_in_place(body, {.centre = by, .top = {}});
  }

  // --- Where a body is, and how it moves --------------------------------------------------------

  /// The body as it is now; a point has a top that is locked about every axis. The orientation is
  /// that of its principal axes: drawn_pose() has that of the model.
  RigidBody<Real> body(BodyHandle body) const { return backend_.body(registry_.index_of(body)); }
  /// Where its centre of mass is (m), in world axes. This and the three after it read one body
  /// alone, in ManyBodies too, so that a loop over all needs no copy of them.
  Vec3<Real> position(BodyHandle body) const { return this->body(body).centre.position; }
  /// How fast its centre of mass moves (m/s), in world axes.
  Vec3<Real> velocity(BodyHandle body) const { return this->body(body).centre.velocity; }
  /// How its principal axes stand, from body to world axes: drawn_pose() has those of the model.
  /// @throws std::invalid_argument if the body is a point.
  Quaternion<Real> orientation(BodyHandle body) const {
    require_top(body);
    return this->body(body).top.orientation;
  }
  /// How fast it turns, and about which axis (rad/s), in world axes.
  /// @throws std::invalid_argument if the body is a point.
  Vec3<Real> angular_velocity(BodyHandle body) const {
    require_top(body);
    return angular_velocity_world(this->body(body).top);
  }

  /// Puts the centre of mass there.
  /// @throws std::invalid_argument if a component is not finite.
  void set_position(BodyHandle body, const Vec3<Same<Real>>& position) {
    require_finite(name_of(body) + ": position", position, "m");
    change_state(body, [&](RigidBody<Real>& changed) { changed.centre.position = position; });
  }

  /// Sets the velocity of the centre of mass. What no force can move keeps it, and so moves on.
  /// @throws std::invalid_argument if a component is not finite.
  void set_velocity(BodyHandle body, const Vec3<Same<Real>>& velocity) {
    require_finite(name_of(body) + ": velocity", velocity, "m/s");
    change_state(body, [&](RigidBody<Real>& changed) { changed.centre.velocity = velocity; });
  }

  /// Turns the body axes, which are the principal axes, so. For a model to stand in the pose M give
  /// the orientation of composed(M, inverse(model_in_body)).
  /// @throws std::invalid_argument if the body is a point, or as checked_orientation(), which also
  /// normalises it.
  void set_orientation(BodyHandle body, const Quaternion<Real>& orientation) {
    require_top(body);
    const Quaternion<Real> q = checked_orientation(orientation, name_of(body) + ": orientation");
    change_state(body, [&](RigidBody<Real>& changed) { changed.top.orientation = q; });
  }

  /// Sets the angular velocity.
  /// @throws std::invalid_argument if the body is a point, if the angular velocity or the angular
  /// momentum that belongs to it is not finite, or if it would turn about a locked axis.
  void set_angular_velocity(BodyHandle body, const Vec3<Same<Real>>& angular_velocity) {
    require_top(body);
    change_state(body, [&](RigidBody<Real>& changed) {
      set_checked_angular_velocity(name_of(body), changed.top, angular_velocity);
    });
  }

  // --- Pushes and blows -------------------------------------------------------------------------

  /// A blow of `impulse` N s at `point` m, world axes, between two steps.
  /// @throws std::invalid_argument if the body's velocity or angular momentum would not be finite.
  void apply_impulse_at(BodyHandle body, const Vec3<Same<Real>>& impulse,
                        const Vec3<Same<Real>>& point) {
    change_state(body, [&](RigidBody<Real>& changed) {
      tumble::apply_impulse_at(changed, impulse, point);
      require_finite(name_of(body) + ": velocity after the blow", changed.centre.velocity, "m/s");
      require_finite(name_of(body) + ": angular momentum after the blow",
                     changed.top.angular_momentum_body, "kg m^2/s");
    });
  }

  /// A force (N) at `point` (m), both in world axes, in the next step alone, such as a player's
  /// push. The forces of several calls add up. The arm is that of now, wherever the body is put
  /// before the step. It does not move what no force can move.
  /// @throws std::invalid_argument if a component is not finite.
  void push_at(BodyHandle body, const Vec3<Same<Real>>& force, const Vec3<Same<Real>>& point) {
    require_finite(name_of(body) + ": point of the force", point, "m");
    const Vec3<Real> centre = backend_.body(registry_.index_of(body)).centre.position;
    push(body, {force, torque_about<Real>(centre, point, force)});
  }

  /// The same of a force at the centre of mass, of a torque about it, or of both. A torque does not
  /// turn a point.
  /// @throws std::invalid_argument if a component is not finite.
  void push(BodyHandle body, const Push<Real>& push) {
    require_between_steps("a push for the next step can't be given");
    require_finite(name_of(body) + ": force", push.force, "N");
    require_finite(name_of(body) + ": torque", push.torque, "N m");
    planner_.add_input(registry_.index_of(body), push, named_bodies());
  }

  // --- Effects ----------------------------------------------------------------------------------

  /// Adds an effect for every body, including those that are added later. An effect is a value with
  /// one of the functions of forms.hpp, and with those members that it needs of the table on the
  /// page \ref effects.
  /// What the effect's check() throws comes through.
  template <class Effect>
  EffectHandle add(Effect effect) {
    static_assert(
        EffectOnOne<Effect, Real> || FindsPairs<Effect, Real>,
        "an effect for everyone has one of the functions for one body in forms.hpp, with "
        "the arguments and the result given there, and const. If a body was meant: it is a "
        "Particle or a RigidBody with this world's Real, such as "
        "make_rigid_body(...).body");
    return append_effect(prepared(effect), true, {});
  }

  /// Adds an effect for some bodies; for one that joins two, each first followed by its second.
  /// What its check() throws comes through.
  /// @throws std::invalid_argument if there are no bodies, if the effect joins two and their number
  /// is odd or a body would be joined to itself, if it is for one and a body is named twice, or if
  /// it needs an orientation and a body is a point.
  template <class Effect>
  EffectHandle add(Effect effect, const std::vector<BodyHandle>& bodies) {
    static_assert(EffectForSome<Effect, Real>,
                  "an effect for some bodies has one of the functions in forms.hpp, with the "
                  "arguments and the result given there, and const, and does not find its pairs "
                  "itself");
    return append_effect(prepared(effect), false, bodies);
  }

  /// False once the effect was removed, or the last of its bodies, and of another world's handle.
  bool contains(EffectHandle effect) const {
    return std::any_of(effects().begin(), effects().end(),
                       [&](const EffectInstance<Real>& one) { return one.handle == effect; });
  }

  /// Removes an effect, for all its bodies.
  void remove(EffectHandle effect) {
    require_between_steps("an effect can't be removed");
    const EffectInstance<Real>& instance = instance_of(effect);
    change_log_.note({"'", instance.effect->name(), "' was removed"});
    limit_changed_ |= instance.effect->traits().changes_limit();
    planner_.remove_effect(effect.number, named_bodies());
  }

  /// The effect, whose type the caller must know. The reference holds until the effect is removed
  /// or changed, or a step of another length is chosen. @throws std::invalid_argument if it is
  /// another.
  template <class Effect>
  const Effect& effect(EffectHandle handle) const {
    const EffectInstance<Real>& instance = instance_of(handle);
    const auto* found = dynamic_cast<const EffectOf<Real, Effect>*>(instance.effect.get());
    if (!found)
      throw std::invalid_argument(
          joined({"'", instance.effect->name(), "' is an effect of another type"}));
    return found->effect();
  }

  /// Puts another effect of the same type in its place, for the same bodies: take effect(), change
  /// the copy, and give it here. What its check() throws comes through.
  /// @throws std::invalid_argument if the type is another, or if
  /// it needs an orientation now and a body is a point.
  template <class Effect>
  void change(EffectHandle handle, Effect by) {
    require_between_steps("an effect can't be changed");
    (void)effect<Effect>(handle);
    auto erased = prepared(by);
    change_log_.note({"'", erased->name(), "' was changed"});
    for (std::size_t i = 0; const BodyHandle body : instance_of(handle).targets)
      require_top_for(*erased, body, i++);
    limit_changed_ |= erased->traits().changes_limit();
    planner_.replace_effect(handle.number, std::move(erased), named_bodies());
  }

  /// The effects of the scene, in the order in which they came, until one comes or goes.
  const std::vector<EffectInstance<Real>>& effects() const { return step_plan().effects; }

  // --- How it steps -----------------------------------------------------------------------------

  /// From now on the bodies whose moments differ turn by `rule`: one of turning_methods.hpp or of
  /// turning_rungs.hpp, or one of the user's own.
  template <TurningRule<Real> Rule>
  void turn_by(const Rule& rule) {
    require_between_steps("the method of turning can't be changed");
    change_log_.note({"another method of turning was chosen"});
    planner_.turn_by(Backend::erased(Tumbling<Rule>{.rule = rule}));
  }

  /// From now on all bodies are stepped by `scheme`; until then by Scheme::semi_implicit_euler, of
  /// order 1: see \ref schemes. Drag, damping and blows leave a scheme a lower order: plan() says
  /// which, and why.
  void step_by(Scheme scheme) {
    require_between_steps("the scheme can't be changed");
    change_log_.note({"the scheme ", tumble::name_of(scheme), " was chosen"});
    limit_changed_ = true;
    planner_.step_by(scheme);
  }

  /// Adds a motion that every step makes, in each kick or each drift (its phase), after the step's
  /// own, for every body that its skip_reason() does not skip: see motions.hpp.
  template <class Motion>
  void add_motion(const Motion& motion) {
    static_assert(
        MovesInPlace<Motion, Particle<Real>, Real> || MovesInPlace<Motion, Top<Real>, Real>,
        "a motion is a function of a centre or a top and a time step, and says what it "
        "writes");
    static_assert(
        phase_of<Motion, Real>() == Phase::kick || phase_of<Motion, Real>() == Phase::drift,
        "a motion acts in the phase kick or drift");
    require_between_steps("a motion can't be added");
    change_log_.note({"'", motion.name, "' came"});
    planner_.add_motion({.effect = Backend::erased(motion)}, named_bodies());
  }

  /// The name of the rule by which bodies turn whose moments differ.
  std::string turning_method() const { return turning_method_of(step_plan()); }
  /// By which scheme all bodies are stepped.
  Scheme scheme() const { return step_plan().scheme; }
  /// From now on so many threads take part in each step, of ManyBodies alone; without a call, one.
  /// Where each has fewer bodies than InPacks::smallest_share, one does all.
  /// If it throws, as many as before take part.
  /// @throws std::invalid_argument if it is not from 1 to 1024.
  /// @throws std::system_error if the system has no more.
  void use_threads(int count) requires requires(Backend& backend) { backend.use_threads(count); }
  {
    require_between_steps("the number of threads can't be changed");
    backend_.use_threads(count);
  }

  // --- Time -------------------------------------------------------------------------------------

  /// How long a step lasts, as it was given.
  const StepLength& step_length() const { return time_.step; }
  /// The same in s, rounded.
  Real time_step() const { return time_step_; }
  /// How many steps there have been.
  std::int64_t ticks() const { return time_.ticks; }
  /// n h, s: with two roundings at most, beside that of h, however many steps there were. After
  /// set_step_length() it goes on from what it was.
  Real time() const { return step_time().time; }
  /// When the next step happens.
  StepTime<Real> step_time() const { return {time_.time(time_step_), time_step_}; }

  /// From now on each step lasts so long. Effects that prepare for a step do so anew, and the next
  /// step warns of what may go wrong. A StepClock has a step of its own: make a new one.
  /// @throws std::invalid_argument if the step is negative or longer than an hour.
  /// @throws std::logic_error if an effect asks for it inside a step.
  void set_step_length(const StepLength& step) {
    require_step_length(step, 0);
    require_between_steps("the time step can't be changed");
    const Real time_step = time_step_of<Real>(step);
    std::vector<std::pair<std::uint64_t, std::shared_ptr<const AnyEffect<Real>>>> prepared;
    for (const EffectInstance<Real>& instance : effects())
      if (auto effect = instance.effect->prepared(time_step))
        prepared.emplace_back(instance.handle.number, std::move(effect));
    change_log_.note({"a step of ", text_of(time_step), " s was chosen"});
    limit_changed_ = true;
    time_ = continued(time_, step);
    time_step_ = time_step;
    for (auto& [number, effect] : prepared)
      planner_.replace_effect(number, std::move(effect), named_bodies());
  }

  // --- Save and go back -------------------------------------------------------------------------

  /// How all bodies move now, and the time: with restore() a step, or a thousand, can be taken
  /// back. Effects, masses, names and pushes for the next step are not in it. It knows how long a
  /// step was, so as to tell the time; restore() leaves the world the step that it has.
  /// \ref world_changes shows this and the other ways back.
  Snapshot<Real> save() const { return snapshot_of(named_bodies(), planner_, time_); }
  /// All bodies move as they did when the snapshot was saved, and the steps from there on have the
  /// same bits, unless the scene has been changed since, or a push for one step was to come then:
  /// such pushes are dropped. The first body moves as the first one did, and so on: a snapshot,
  /// which may come from a file, knows no names. Where a body has gone and another has come since,
  /// go back to a copy of the world instead.
  /// @throws std::invalid_argument if there are more bodies or tops than then, or fewer.
  void restore(const Snapshot<Real>& then) {
    require_between_steps("a snapshot can't be restored");
    tumble::restore(then, named_bodies(), backend_, planner_);
    checkpoints_.forget_all();
    time_ = continued<Real>(then, time_.step);
  }

  /// The same as save(), for each frame of a game that may have to go back: after the first
  /// checkpoint, and until a body comes or goes, it costs what can move and what was changed, and
  /// not what rests. It is for this world, or a copy of it.
  Checkpoint<Real> checkpoint() {
    require_between_steps("a checkpoint can't be made");
    return checkpoints_.make(time_, named_bodies(), planner_);
  }
  /// See restore() of a Snapshot; it costs what can move now, or could then, and what was changed.
  /// @throws std::invalid_argument if it is another world's, or if a body has come or gone since.
  void restore(const Checkpoint<Real>& then) {
    require_between_steps("a checkpoint can't be restored");
    checkpoints_.restore(then, named_bodies(), backend_, planner_);
    time_ = continued<Real>(then, time_.step);
  }

  // --- The plan ---------------------------------------------------------------------------------

  /// The plan as a table, computed when asked for and so never out of date: \ref plan reads it.
  Plan plan() const {
    return {rows_of(planner_, named_bodies()), accuracy_of(step_plan()), warnings(),
            unknown_limits(step_plan())};
  }
  /// What may go wrong as the bodies are now, such as a step too long for a spring.
  std::vector<std::string> warnings() const {
    return tumble::warnings(step_plan(), named_bodies(), step_time());
  }

  /// Up to which step no effect that has a response() can feed on itself, as the bodies are now;
  /// infinite if none has one that limits it. \ref step_limits derives it.
  StepLimit<Real> step_limit() const {
    return tumble::step_limit(step_plan(), named_bodies(), time());
  }

  /// What has changed the plan since the world began, a sentence each; the last hundred of them.
  std::vector<std::string> change_log() const {
    ChangeLog now = change_log_;
    if (now.is_pending()) now.tell(step_plan(), registry_.size(), ticks());
    return now.sentences();
  }

  /// From now on a warning is given to this function, and not to standard error; an empty function
  /// gives it back. It is called at the beginning of step(), once for each warning, in the first
  /// step and after changes of bodies, effects, scheme or step that could have led to one. What it
  /// throws comes through, before anything has moved. A copy of the world calls it too.
  void on_warning(std::function<void(const std::string&)> tell) { tell_ = std::move(tell); }

  // --- Inside: for checks and benches -----------------------------------------------------------

  /// What keeps and steps the bodies.
  Backend& backend() { return backend_; }
  const Backend& backend() const { return backend_; }
  /// What the steps go through.
  const StepPlan<Real>& step_plan() const { return planner_.step_plan(); }
  /// What is known of each body, in the order of the arrays.
  const std::vector<BodyFlags>& flags() const { return planner_.flags(); }

  /// The same step without members: each effect is asked about each body anew. See other_runs.hpp.
  void step_by_reference() {
    step_on_copy([&](Bodies<Real>& bodies) {
      tumble::step_by_reference(bodies, step_plan(), planner_.own_flags(), step_time(), registry_);
    });
  }

  /// The same step with nothing known of any body: see other_runs.hpp.
  void step_exhaustively() {
    step_on_copy([&](Bodies<Real>& bodies) {
      tumble::step_exhaustively(bodies, step_plan(), step_time(), registry_);
    });
  }

 private:
  NamedBodies<Real> named_bodies() const { return {registry_, backend_}; }

  /// `top` is null for a point.
  BodyHandle append_body(const std::string& name, const Particle<Real>& centre,
                         const Top<Real>* top) {
    require_between_steps("a body can't be added");
    const std::string called = name.empty() ? "a body" : name;
    check_body(called, centre);
    if (top) check_body(called, *top);
    RigidBody<Real> appended{.centre = centre, .top = top ? *top : Top<Real>{}};
    appended.top.orientation = renormalized(appended.top.orientation);
    clear_forces(appended);
    backend_.append(appended.centre, top ? &appended.top : nullptr);
    const BodyHandle body = registry_.append(name);
    change_log_.note({"'", name_of(body), "' came"});
    checkpoints_.forget_all();
    planner_.add_body(named_bodies());
    limit_changed_ |= planner_.is_limiting(registry_.index_of(body));
    return note_motion(body);
  }

  void require_top(BodyHandle body) const {
    if (is_point(body))
      throw std::invalid_argument(
          joined({"'", name_of(body), "' is a point: it has no orientation"}));
  }

  /// Inside a step the backend goes through the arrays and the plan.
  void require_between_steps(const char* what) const {
    if (inside_.is_inside) throw std::logic_error(joined({what, " inside a step"}));
  }

  /// Lets `change` change a body. If it throws, nothing has changed.
  template <class Change>
  void change_state(BodyHandle body, const Change& change) {
    require_between_steps("a body can't be changed");
    const BodyIndex index = registry_.index_of(body);
    RigidBody<Real> changed = backend_.body(index);
    change(changed);
    clear_forces(changed);
    backend_.set_body(index, changed);
    planner_.touch(index);
    note_motion(body);
  }

  /// A first velocity or spin changes what the scene calls for.
  BodyHandle note_motion(BodyHandle body) {
    const BodyIndex index = registry_.index_of(body);
    const BodyFlags before = planner_.own_flags()[index],
                    now = named_bodies().flags_of(index, before);
    if (now.moves != before.moves)
      change_log_.note({"'", name_of(body), "' got its first velocity"});
    if (now.turns != before.turns) change_log_.note({"'", name_of(body), "' got its first spin"});
    if (now != before) planner_.change_body(index, named_bodies());
    return body;
  }

  const EffectInstance<Real>& instance_of(EffectHandle handle) const {
    for (const EffectInstance<Real>& instance : effects())
      if (instance.handle == handle) return instance;
    throw std::out_of_range(joined({"stale handle: effect ", std::to_string(handle.number),
                                    " has been removed or never was in this world"}));
  }

  template <class Effect>
  std::shared_ptr<const AnyEffect<Real>> prepared(Effect& effect) {
    if constexpr (has_response<Real, Effect>) find_warnings_ = &tumble::warnings<Real>;
    if constexpr (requires { effect.check(); }) effect.check();
    if constexpr (requires { effect.prepare(time_step_); }) effect.prepare(time_step_);
    return Backend::erased(effect);
  }

  void require_top_for(const AnyEffect<Real>& effect, BodyHandle body, std::size_t place) const {
    const bool is_second = effect.traits().joins_two() && place % 2 == 1;
    const bool needs = is_second ? effect.traits().needs_second_top : effect.traits().needs_top;
    if (needs && is_point(body))
      throw std::invalid_argument(joined(
          {"'", effect.name(), "' needs an orientation, and '", name_of(body), "' is a point"}));
  }

  EffectHandle append_effect(std::shared_ptr<const AnyEffect<Real>> erased, bool everyone,
                             const std::vector<BodyHandle>& bodies) {
    require_between_steps("an effect can't be added");
    const std::string name = erased->name();
    const std::size_t stride = erased->traits().joins_two() ? 2 : 1;
    IndexSet meant_for;
    if (!everyone && (bodies.empty() || bodies.size() % stride != 0))
      throw std::invalid_argument(
          joined({"'", name, "' was given ", std::to_string(bodies.size()), " bodies; it needs ",
                  stride == 2 ? "pairs of them" : "at least one"}));
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      const BodyIndex body =
          registry_.index_of(bodies[i]);  // or it throws, and nothing has changed
      require_top_for(*erased, bodies[i], i);
      if (stride == 2 && i % 2 == 1 && bodies[i] == bodies[i - 1])
        throw std::invalid_argument(
            joined({"'", name, "' joins '", name_of(bodies[i]), "' to itself"}));
      if (stride == 2) continue;
      if (meant_for.contains(body))
        throw std::invalid_argument(
            joined({"'", name, "' was given '", name_of(bodies[i]), "' twice"}));
      meant_for.insert(body);
    }
    change_log_.note({"'", name, "' came"});
    limit_changed_ |= erased->traits().changes_limit();
    const EffectHandle handle{++last_effect_, registry_.family()};
    planner_.add_effect({handle, std::move(erased), everyone, bodies}, named_bodies());
    return handle;
  }

  /// Reports what has changed since the last step.
  void report_changes() {
    change_log_.tell(step_plan(), registry_.size(), ticks());
    if (!std::exchange(limit_changed_, false) || !find_warnings_) return;
    for (const std::string& warning : find_warnings_(step_plan(), named_bodies(), step_time()))
      if (tell_)
        tell_(warning);
      else
        std::fprintf(stderr, "warning: %s\n", warning.c_str());
  }

  template <class Step>
  void step_on_copy(const Step& step) {
    require_between_steps("another step can't be taken");
    const InsideStep inside(inside_);
    Bodies<Real> bodies = backend_.bodies();
    step(bodies);
    if (const std::optional<BodyIndex> diverged = first_diverged(bodies, step_plan()))
      throw_failure(*diverged);
    backend_.set_bodies(std::move(bodies));
    checkpoints_.forget_all();
    ++time_.ticks;
    planner_.end_inputs(named_bodies());
  }

  void require_kind(BodyHandle body, bool as_point) const {
    if (is_point(body) == as_point) return;
    throw std::invalid_argument(
        joined({"'", name_of(body), "' is ", as_point ? "no" : "a", " point: replace it by a ",
                as_point ? "RigidBody" : "Particle"}));
  }

  void put_in_place(BodyHandle body, RigidBody<Real> by) {
    change_log_.note({"'", name_of(body), "' was replaced"});
    limit_changed_ |= planner_.is_limiting(registry_.index_of(body));
    clear_forces(by);
    backend_.set_body(registry_.index_of(body), by);
    planner_.change_body(registry_.index_of(body), named_bodies());
  }

  [[noreturn]] void throw_failure(BodyIndex diverged) {
    throw failure<Real>(registry_.name_of(diverged), diverged, bodies(), step_plan(), ticks(),
                        step_time());
  }

  /// Whether the world is inside a step. A copy that is made then is not.
  struct Inside {
    Inside() = default;
    Inside(const Inside&) noexcept {}
    Inside& operator=(const Inside&) noexcept { return *this; }
    bool is_inside = false;
  };
  /// While one lives, the world is inside a step.
  struct InsideStep {
    explicit InsideStep(Inside& world) : flag(world.is_inside) { flag = true; }
    ~InsideStep() { flag = false; }
    InsideStep(const InsideStep&) = delete;
    InsideStep& operator=(const InsideStep&) = delete;
    bool& flag;
  };

  WorldTime<Real> time_;
  Real time_step_;
  Inside inside_;
  BodyRegistry registry_;
  Backend backend_;
  Planner<Real> planner_;
  std::uint64_t last_effect_ = 0;
  Checkpoints<Real> checkpoints_;
  ChangeLog change_log_;
  bool limit_changed_ = false;
  std::function<void(const std::string&)> tell_;
  /// warnings(), once there is an effect that can limit the step: a program without one is spared
  /// compiling them, a seventh of the time that a small world takes.
  decltype(&tumble::warnings<Real>) find_warnings_ = nullptr;
};

using Worldf = World<float>;
using Worldd = World<double>;

}  // namespace tumble

#ifdef TUMBLE_COMPILED_WORLDS  // inside the course alone
#include <support/compiled_worlds.hpp>
#endif
