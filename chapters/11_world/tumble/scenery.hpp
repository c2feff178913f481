/// @file
/// What is in a world: its bodies and its effects, and how one changes them while it runs.
#pragma once

#include <tumble/named_bodies.hpp>
#include <tumble/news.hpp>
#include <tumble/planner.hpp>
#include <unordered_set>

namespace tumble {

/// Bodies and effects. Everything that could change the plan goes through here, so the plan is always
/// right. It is the part of a World that knows no time.
template <class Real, class Keeping>
class Scenery {
 public:
  // --- Bodies -----------------------------------------------------------------------------------

  /// Adds a point, or a body, which should come from make_rigid_body() or make_static_body().
  /// @throws std::invalid_argument if the name is empty or taken, or a number is not finite.
  BodyHandle add(const std::string& name, const Particle<Real>& point) {
    return came(name, bodies_.append(name, point, nullptr));
  }
  BodyHandle add(const std::string& name, const RigidBody<Real>& body) {
    return came(name, bodies_.append(name, body.centre, &body.top));
  }

  /// Takes a body out, and the effects that are fixed to it.
  void remove(BodyHandle body) {
    const BodyIndex index = bodies_.index_of(body);
    news_.note("'" + name_of(body) + "' was removed");
    springs_changed_ |= planner_.holds_spring(index);
    planner_.forget_body(body, bodies_);
    bodies_.remove(body);
    planner_.join_again(index, bodies_);
  }

  bool contains(BodyHandle body) const { return bodies_.contains(body); }
  std::size_t body_count() const { return bodies_.size(); }
  std::size_t top_count() const { return bodies_.top_count(); }
  /// @throws std::invalid_argument if no body is called so.
  BodyHandle find(const std::string& name) const { return bodies_.find(name); }
  const std::string& name_of(BodyHandle body) const {
    return bodies_.name_of(bodies_.index_of(body));
  }
  /// The body with that place in the arrays, and the place of a body.
  BodyHandle handle_at(BodyIndex index) const { return bodies_.handle_at(index); }
  BodyIndex index_of(BodyHandle body) const { return bodies_.index_of(body); }
  bool is_point(BodyHandle body) const { return bodies_.is_point(bodies_.index_of(body)); }

  /// The body as it is now; a point has a top that is locked about every axis.
  RigidBody<Real> body(BodyHandle body) const { return bodies_.body(bodies_.index_of(body)); }
  /// All of them: a reference to them, or, from a Keeping that has them in another form, a copy.
  decltype(auto) bodies() const { return bodies_.kept().bodies(); }
  /// How the bodies are kept, to say on how many threads they are stepped.
  Keeping& keeping() { return bodies_.kept(); }

  // --- Changes while it runs --------------------------------------------------------------------

  /// Puts another body in the place of one that is not a point: with another mass, say. It keeps
  /// its name and its effects.
  void replace(BodyHandle body, const RigidBody<Real>& by) {
    check_body(name_of(body), by.centre);
    check_body(name_of(body), by.top);
    require_top(body);
    news_.note("'" + name_of(body) + "' was replaced");
    springs_changed_ |= planner_.holds_spring(bodies_.index_of(body));
    bodies_.set(bodies_.index_of(body), by);
    planner_.change_body(bodies_.index_of(body), bodies_);
  }

  void set_position(BodyHandle body, const Vec3<Same<Real>>& position) {
    require_finite(name_of(body) + ": position", position, "m");
    change_state(body, [&](RigidBody<Real>& changed) { changed.centre.position = position; });
  }

  void set_velocity(BodyHandle body, const Vec3<Same<Real>>& velocity) {
    require_finite(name_of(body) + ": velocity", velocity, "m/s");
    change_state(body, [&](RigidBody<Real>& changed) { changed.centre.velocity = velocity; });
  }

  void set_orientation(BodyHandle body, const Quaternion<Real>& orientation) {
    require_top(body);
    const Quaternion<Real> q = checked_orientation(orientation, name_of(body) + ": orientation");
    change_state(body, [&](RigidBody<Real>& changed) { changed.top.orientation = q; });
  }

  /// Sets the angular velocity, rad/s, world axes.
  void set_angular_velocity(BodyHandle body, const Vec3<Same<Real>>& angular_velocity) {
    require_top(body);
    change_state(body, [&](RigidBody<Real>& changed) {
      set_checked_angular_velocity(name_of(body), changed.top, angular_velocity);
    });
  }

  /// A blow of `impulse` N s at `point` m, world axes, between two steps.
  void apply_impulse_at(BodyHandle body, const Vec3<Same<Real>>& impulse,
                        const Vec3<Same<Real>>& point) {
    change_state(body, [&](RigidBody<Real>& changed) {
      tumble::apply_impulse_at(changed, impulse, point);
      require_finite(name_of(body) + ": velocity after the blow", changed.centre.velocity, "m/s");
      require_finite(name_of(body) + ": angular momentum after the blow",
                     changed.top.angular_momentum_body, "kg m^2/s");
    });
  }

  /// A force (N) at `point` (m), both in world axes, in the next step alone: what a player's hand
  /// does. Those of several calls add up.
  void push_at(BodyHandle body, const Vec3<Same<Real>>& force, const Vec3<Same<Real>>& point) {
    require_finite(name_of(body) + ": force", force, "N");
    require_finite(name_of(body) + ": point of the force", point, "m");
    const Vec3<Real> centre = bodies_.body(bodies_.index_of(body)).centre.position;
    planner_.add_input(bodies_.index_of(body), {force, torque_about<Real>(centre, point, force)},
                       bodies_);
  }

  // --- Effects ----------------------------------------------------------------------------------

  /// Adds an effect for every body, those to come too.
  template <class Effect>
  EffectHandle add(const Effect& effect) {
    static_assert(EffectOnOne<Effect, Real> || FindsPairs<Effect, Real>,
                  "an effect for everyone has one of the functions in effect.hpp");
    return append_effect(effect, true, {});
  }

  /// Adds an effect for some bodies; for one that joins two, each first followed by its second.
  template <class Effect>
  EffectHandle add(const Effect& effect, const std::vector<BodyHandle>& bodies) {
    static_assert(EffectOnOne<Effect, Real> || EffectOnTwo<Effect, Real>,
                  "an effect has one of the functions in effect.hpp");
    return append_effect(effect, false, bodies);
  }

  void remove(EffectHandle effect) {
    const Entry<Real>& entry = entry_of(effect);
    news_.note("'" + entry.effect->name() + "' was removed");
    springs_changed_ |= is_spring(*entry.effect);
    planner_.remove_effect(effect.number, bodies_);
  }

  /// The effect, of which one must know the type. @throws std::invalid_argument if it is another.
  template <class Effect>
  const Effect& effect(EffectHandle handle) const {
    const Entry<Real>& entry = entry_of(handle);
    const auto* found = dynamic_cast<const EffectOf<Real, Effect>*>(entry.effect.get());
    if (!found)
      throw std::invalid_argument("'" + entry.effect->name() + "' is an effect of another type");
    return found->effect();
  }

  /// Puts another effect of the same type in its place, for the same bodies.
  template <class Effect>
  void change(EffectHandle handle, Effect by) {
    (void)effect<Effect>(handle);
    auto erased = prepared(by);
    news_.note("'" + erased->name() + "' was changed");
    for (std::size_t i = 0; const BodyHandle body : entry_of(handle).targets)
      require_top_for(*erased, body, i++);
    springs_changed_ |= is_spring(*erased);
    planner_.replace_effect(handle.number, std::move(erased), bodies_);
  }

  /// From now on the bodies whose moments differ turn by `rule`: one of turning_methods.hpp, or of
  /// the user's own.
  template <TurningRule<Real> Rule>
  void turn_by(const Rule& rule) {
    news_.note("another method of turning was chosen");
    planner_.turn_by(Keeping::erased_rule(rule));
  }

  /// The effects of the scene, in the order in which they came.
  const std::vector<Entry<Real>>& effects() const { return planner_.work().effects; }
  /// The name of the rule by which bodies turn whose moments differ.
  const std::string& turning_method() const { return planner_.work().rule->name(); }

  /// What the steps go through, and what is known of each body.
  const Work<Real>& work() const { return planner_.work(); }
  const std::vector<Facts>& facts() const { return planner_.facts(); }

 protected:
  explicit Scenery(Real time_step) : time_step_(time_step) {}

  Real time_step_;
  NamedBodies<Real, Keeping> bodies_;
  Planner<Real> planner_;
  News news_;
  bool springs_changed_ = false;

 private:
  BodyHandle came(const std::string& name, BodyHandle body) {
    news_.note("'" + name + "' came");
    planner_.add_body(bodies_);
    springs_changed_ |= planner_.holds_spring(bodies_.index_of(body));
    return note_motion(body);
  }

  void require_top(BodyHandle body) const {
    if (is_point(body))
      throw std::invalid_argument("'" + name_of(body) + "' is a point: it has no orientation");
  }

  /// Lets `change` change a body. If it throws, nothing has changed.
  template <class Change>
  void change_state(BodyHandle body, const Change& change) {
    const BodyIndex index = bodies_.index_of(body);
    RigidBody<Real> changed = bodies_.body(index);
    change(changed);
    bodies_.set(index, changed);
    note_motion(body);
  }

  /// A first velocity or spin changes what the scene calls for.
  BodyHandle note_motion(BodyHandle body) {
    const BodyIndex index = bodies_.index_of(body);
    const Facts before = planner_.alone()[index], now = bodies_.facts_of(index, before);
    if (now.moves != before.moves) news_.note("'" + name_of(body) + "' got its first velocity");
    if (now.turns != before.turns) news_.note("'" + name_of(body) + "' got its first spin");
    if (now != before) planner_.change_body(index, bodies_);
    return body;
  }

  const Entry<Real>& entry_of(EffectHandle handle) const {
    for (const Entry<Real>& entry : effects())
      if (entry.handle == handle) return entry;
    throw std::out_of_range("stale handle: effect " + std::to_string(handle.number) +
                            " has been removed or never was in this world");
  }

  template <class Effect>
  auto prepared(Effect& effect) const {
    if constexpr (requires { effect.check(); }) effect.check();
    if constexpr (requires { effect.prepare(time_step_); }) effect.prepare(time_step_);
    return Keeping::erased(effect);
  }

  void require_top_for(const AnyEffect<Real>& effect, BodyHandle body, std::size_t place) const {
    const bool is_second = effect.traits().joins_two() && place % 2 == 1;
    const bool needs = is_second ? effect.traits().needs_second_top : effect.traits().needs_top;
    if (needs && is_point(body))
      throw std::invalid_argument("'" + effect.name() + "' needs an orientation, and '" +
                                  name_of(body) + "' is a point");
  }

  template <class Effect>
  EffectHandle append_effect(Effect effect, bool everyone, const std::vector<BodyHandle>& bodies) {
    auto erased = prepared(effect);
    const std::string name = erased->name();
    const std::size_t stride = erased->traits().joins_two() ? 2 : 1;
    std::unordered_set<BodyIndex> meant_for;
    if (!everyone && (bodies.empty() || bodies.size() % stride != 0))
      throw std::invalid_argument("'" + name + "' was given " + std::to_string(bodies.size()) +
                                  " bodies; it needs " +
                                  (stride == 2 ? "pairs of them" : "at least one"));
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      require_top_for(*erased, bodies[i], i);
      if (stride == 2 && i % 2 == 1 && bodies[i] == bodies[i - 1])
        throw std::invalid_argument("'" + name + "' joins '" + name_of(bodies[i]) + "' to itself");
      if (stride == 1 && !meant_for.insert(bodies_.index_of(bodies[i])).second)
        throw std::invalid_argument("'" + name + "' was given '" + name_of(bodies[i]) + "' twice");
    }
    news_.note("'" + name + "' came");
    springs_changed_ |= is_spring(*erased);
    const EffectHandle handle{++last_effect_, bodies_.family()};
    planner_.add_effect({handle, std::move(erased), everyone, bodies, {}}, bodies_);
    return handle;
  }

  std::uint64_t last_effect_ = 0;
};

}  // namespace tumble
