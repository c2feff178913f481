/// @file
/// What is in a world: its bodies and its effects.
#pragma once

#include <tumble/scene_bodies.hpp>
#include <unordered_set>

namespace tumble {

/// Bodies and effects: the part of a World that has no time. What else can be done with its bodies,
/// see SceneBodies.
template <class Real, class Keeping>
class Scenery : public SceneBodies<Real, Keeping> {
  using Base = SceneBodies<Real, Keeping>;

 public:
  using Base::add, Base::remove, Base::is_point, Base::name_of;

  // --- Effects ----------------------------------------------------------------------------------

  /// Adds an effect for every body, including those that are added later.
  template <class Effect>
  EffectHandle add(Effect effect) {
    static_assert(EffectOnOne<Effect, Real> || FindsPairs<Effect, Real>,
                  "an effect for everyone has one of the functions for one body in forms.hpp, with "
                  "the arguments and the result given there, and const");
    return append_effect(prepared(effect), true, {});
  }

  /// Adds an effect for some bodies; for one that joins two, each first followed by its second.
  template <class Effect>
  EffectHandle add(Effect effect, const std::vector<BodyHandle>& bodies) {
    static_assert(EffectForSome<Effect, Real>,
                  "an effect for some bodies has one of the functions in forms.hpp, with the "
                  "arguments and the result given there, and const, and does not find its pairs "
                  "itself");
    return append_effect(prepared(effect), false, bodies);
  }

  void remove(EffectHandle effect) {
    const Entry<Real>& entry = entry_of(effect);
    change_log_.note("'" + entry.effect->name() + "' was removed");
    limit_changed_ |= entry.effect->traits().changes_limit();
    planner_.remove_effect(effect.number, bodies_);
  }

  /// The effect, whose type the caller must know. @throws std::invalid_argument if it is another.
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
    change_log_.note("'" + erased->name() + "' was changed");
    for (std::size_t i = 0; const BodyHandle body : entry_of(handle).targets)
      require_top_for(*erased, body, i++);
    limit_changed_ |= erased->traits().changes_limit();
    planner_.replace_effect(handle.number, std::move(erased), bodies_);
  }

  /// From now on the bodies whose moments differ turn by `rule`: one of turning_methods.hpp, or one
  /// of the user's own.
  template <TurningRule<Real> Rule>
  void turn_by(const Rule& rule) {
    change_log_.note("another method of turning was chosen");
    planner_.turn_by(Keeping::erased_rule(rule));
  }

  /// From now on all bodies are stepped by `scheme`.
  void step_by(Scheme scheme) {
    change_log_.note("the scheme " + std::string(tumble::name_of(scheme)) + " was chosen");
    limit_changed_ = true;
    planner_.step_by(scheme);
  }

  /// The effects of the scene, in the order in which they came.
  const std::vector<Entry<Real>>& effects() const { return planner_.work().effects; }
  /// The name of the rule by which bodies turn whose moments differ.
  const std::string& turning_method() const { return planner_.work().rule->name(); }
  Scheme scheme() const { return planner_.work().scheme; }

 protected:
  using Base::Base;
  using Base::planner_, Base::bodies_, Base::change_log_, Base::limit_changed_, Base::time_step_;

 private:
  const Entry<Real>& entry_of(EffectHandle handle) const {
    for (const Entry<Real>& entry : effects())
      if (entry.handle == handle) return entry;
    throw std::out_of_range("stale handle: effect " + std::to_string(handle.number) +
                            " has been removed or never was in this world");
  }

  template <class Effect>
  std::shared_ptr<const AnyEffect<Real>> prepared(Effect& effect) const {
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

  EffectHandle append_effect(std::shared_ptr<const AnyEffect<Real>> erased, bool everyone,
                             const std::vector<BodyHandle>& bodies) {
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
    change_log_.note("'" + name + "' came");
    limit_changed_ |= erased->traits().changes_limit();
    const EffectHandle handle{++last_effect_, bodies_.family()};
    planner_.add_effect({handle, std::move(erased), everyone, bodies, {}}, bodies_);
    return handle;
  }

  std::uint64_t last_effect_ = 0;
};

}  // namespace tumble
