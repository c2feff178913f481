/// @file
/// Keeps the plan of a step right while the scene changes.
#pragma once

#include <algorithm>
#include <tumble/body_store.hpp>
#include <tumble/motions.hpp>
#include <utility>

namespace tumble {

/// Keeps what is known of each body, and from that whom each effect and each motion visits. A
/// change touches the sets of the bodies that it concerns, and no others.
template <class Real>
class Planner {
 public:
  /// `motions`: see motions_of().
  explicit Planner(std::vector<EffectInstance<Real>> motions) {
    plan_.motions = std::move(motions);
  }

  const StepPlan<Real>& step_plan() const { return plan_; }
  const std::vector<BodyFlags>& flags() const { return flags_; }
  /// What of the flags is the bodies' own, without the effects.
  const std::vector<BodyFlags>& own_flags() const { return own_flags_; }

  /// `tumbling` is a Tumbling by another rule.
  void turn_by(std::shared_ptr<const AnyEffect<Real>> tumbling) {
    plan_.motions[tumbling_index].effect = std::move(tumbling);
    ++plan_.version;
  }
  /// Another motion of each step.
  void add_motion(EffectInstance<Real> motion, const NamedBodies<Real>& bodies) {
    plan_.motions.push_back(std::move(motion));
    refresh_targets(true, {}, bodies);
  }
  void step_by(Scheme scheme) {
    plan_.scheme = scheme;
    plan_.substeps = substeps_of<Real>(scheme);
    ++plan_.version;
  }

  /// A body was appended.
  void add_body(const NamedBodies<Real>& bodies) {
    own_flags_.emplace_back();
    flags_.emplace_back();
    effects_of_.emplace_back();
    refresh(static_cast<BodyIndex>(flags_.size() - 1), bodies);
  }

  /// A body has changed.
  void change_body(BodyIndex body, const NamedBodies<Real>& bodies) {
    refresh(body, bodies);
    for (const std::uint64_t number : effects_of_[body]) list_pairs(instance_of(number), bodies);
  }

  /// A body is about to go: its own effects and pushes go, and the last body and the last top get
  /// its places.
  void forget_body(BodyHandle handle, const NamedBodies<Real>& bodies) {
    leave_effects(handle, bodies);
    const BodyIndex body = bodies.index_of(handle), top = bodies.top_of(body);
    const auto last = static_cast<BodyIndex>(flags_.size() - 1);
    for_each_instance_of(last, [&](EffectInstance<Real>& instance) {
      if (instance.effect->traits().visits_tops()) return;
      instance.members.indices.replace_by_last(body, last);
      list_phase(instance);
    });
    plan_.moving.replace_by_last(body, last);
    if (top != no_index) {
      const BodyIndex last_top = static_cast<BodyIndex>(bodies.top_count() - 1);
      for_each_instance_of(bodies.body_of(last_top), [&](EffectInstance<Real>& instance) {
        if (!instance.effect->traits().visits_tops()) return;
        instance.members.indices.replace_by_last(top, last_top);
        list_phase(instance);
      });
      plan_.turning.replace_by_last(top, last_top);
    }
    std::erase_if(plan_.inputs, [&](const Input<Real>& input) { return input.body == body; });
    for (Input<Real>& input : plan_.inputs)
      if (input.body == last) input.body = body;
    swap_and_pop(own_flags_, body);
    swap_and_pop(flags_, body);
    swap_and_pop(effects_of_, body);
  }

  /// The body has gone: the pairs of the one that got its place are found again.
  void list_pairs_again(BodyIndex body, const NamedBodies<Real>& bodies) {
    ++plan_.version;
    if (body < effects_of_.size())
      for (const std::uint64_t number : effects_of_[body]) list_pairs(instance_of(number), bodies);
  }

  /// An effect was added.
  void add_effect(EffectInstance<Real> instance, const NamedBodies<Real>& bodies) {
    const std::uint64_t number = instance.handle.number;
    if (instance.everyone) effects_for_all_.push_back(number);
    for (const BodyHandle target : instance.targets)
      effects_of_[bodies.index_of(target)].push_back(number);
    plan_.effects.push_back(std::move(instance));
    plan_effect(number, bodies);
  }

  /// The effect becomes another one, for the same bodies.
  void replace_effect(std::uint64_t number, std::shared_ptr<const AnyEffect<Real>> effect,
                      const NamedBodies<Real>& bodies) {
    instance_of(number).effect = std::move(effect);
    plan_effect(number, bodies);
  }

  /// The effect is removed.
  void remove_effect(std::uint64_t number, const NamedBodies<Real>& bodies) {
    const auto found = find(number);
    const bool everyone = found->everyone;
    const std::vector<BodyHandle> targets = std::move(found->targets);
    const auto place = static_cast<std::size_t>(found - plan_.effects.begin());
    for (auto& list : plan_.in_phase) {
      std::erase(list, place);
      for (std::size_t& later : list) later -= later > place;
    }
    plan_.effects.erase(found);
    std::erase(effects_for_all_, number);
    ++plan_.version;
    for (const BodyHandle target : targets) disown(bodies.index_of(target), number);
    refresh_targets(everyone, targets, bodies);
  }

  /// A body goes back to another time, and what was known of its motion then is known again.
  void restore_flags(BodyIndex body, bool moved, bool turned, const NamedBodies<Real>& bodies) {
    if (own_flags_[body].moves == moved && own_flags_[body].turns == turned) return;
    own_flags_[body].moves = moved;
    own_flags_[body].turns = turned;
    refresh(body, bodies);
  }

  /// The motion of a body is changed from outside.
  void touch(BodyIndex body) { touched_.insert(body); }
  void clear_touched() { touched_ = {}; }
  /// Bodies whose motion or flags have changed since clear_touched().
  const IndexSet& touched() const { return touched_; }

  /// True if an effect that is meant for this body can limit the step.
  bool is_limiting(BodyIndex body) {
    bool found = false;
    for_each_instance_of(body, [&](const EffectInstance<Real>& instance) {
      found |= instance.effect->traits().has_response;
    });
    return found;
  }

  /// A push for the next step alone.
  void add_input(BodyIndex body, const Push<Real>& push, const NamedBodies<Real>& bodies) {
    plan_.inputs.push_back({body, push});
    note(own_flags_[body], quantity::force | quantity::torque);
    refresh(body, bodies);
  }
  /// The step was taken, with its inputs.
  void end_inputs(const NamedBodies<Real>& bodies) {
    for (const Input<Real>& input : std::exchange(plan_.inputs, {})) {
      own_flags_[input.body].is_pushed = own_flags_[input.body].is_torqued = false;
      refresh(input.body, bodies);
    }
  }

 private:
  /// Finds what is known of a body, and puts it into the sets of those that visit it.
  //! [refresh]
  void refresh(BodyIndex body, const NamedBodies<Real>& bodies) {
    touched_.insert(body);
    const BodyIndex top = bodies.top_of(body);
    own_flags_[body] = bodies.flags_of(body, own_flags_[body]);
    // The step's own motions raise no flag: each visits only bodies whose flag is already up.
    const BodyFlags flags = flags_[body] =
        flags_under<Real>(own_flags_[body], [&](const auto& ask) {
          for_each_instance_of(
              body, [&](EffectInstance<Real>& instance) { ask(*instance.effect); },
              own_motion_count);
        });
    for_each_instance_of(body, [&](EffectInstance<Real>& instance) {
      const EffectTraits<Real>& traits = instance.effect->traits();
      if (traits.joins_two() && !traits.finds_pairs) return;
      const BodyIndex member = traits.visits_tops() ? top : body;
      if (member == no_index) return;
      instance.members.indices.set(member, instance.effect->skip_reason(flags).empty());
      list_phase(instance);
    });
    plan_.moving.set(body, flags.moves);
    if (top != no_index) plan_.turning.set(top, flags.turns);
    ++plan_.version;
  }
  //! [refresh]

  /// The pairs that an effect on two visits: those of which it can change something.
  void list_pairs(EffectInstance<Real>& instance, const NamedBodies<Real>& bodies) {
    const EffectTraits<Real>& traits = instance.effect->traits();
    if (!traits.joins_two() || traits.finds_pairs) return;
    instance.members.pairs.clear();
    if (instance.effect->skip_reason(BodyFlags{}).empty())
      for (std::size_t i = 0; i < instance.targets.size(); i += 2) {
        const BodyPair pair{bodies.index_of(instance.targets[i]),
                            bodies.index_of(instance.targets[i + 1])};
        if (unwritable_reason(traits.writes, bodies.flags_of(pair.first, {})).empty() ||
            unwritable_reason(traits.writes, bodies.flags_of(pair.second, {})).empty())
          instance.members.pairs.push_back(pair);
      }
    list_phase(instance);
  }

  /// Puts the effect into the list of its phase if it visits somebody, else takes it out.
  void list_phase(const EffectInstance<Real>& instance) {
    const bool is_motion = instance.handle.number == 0;
    auto& list = (is_motion ? plan_.motions_in_phase
                            : plan_.in_phase)[static_cast<std::size_t>(instance.effect->phase())];
    const auto place =
        static_cast<std::size_t>(&instance - (is_motion ? plan_.motions : plan_.effects).data());
    const auto found = std::lower_bound(list.begin(), list.end(), place);
    const bool is_listed = found != list.end() && *found == place;
    if (is_listed == (instance.members.size() > 0)) return;
    if (is_listed)
      list.erase(found);
    else
      list.insert(found, place);
  }

  auto find(std::uint64_t number) {
    return std::lower_bound(plan_.effects.begin(), plan_.effects.end(), number,
                            [](const EffectInstance<Real>& instance, std::uint64_t n) {
                              return instance.handle.number < n;
                            });
  }
  EffectInstance<Real>& instance_of(std::uint64_t number) { return *find(number); }

  void disown(BodyIndex body, std::uint64_t number) {
    const auto found = std::find(effects_of_[body].begin(), effects_of_[body].end(), number);
    if (found != effects_of_[body].end()) effects_of_[body].erase(found);
  }

  /// The motions from `first` on, then the effects meant for the body.
  template <class Visit>
  void for_each_instance_of(BodyIndex body, const Visit& visit, std::size_t first = 0) {
    for (std::size_t i = first; i < plan_.motions.size(); ++i) visit(plan_.motions[i]);
    for (const std::uint64_t number : effects_for_all_) visit(instance_of(number));
    for (const std::uint64_t number : effects_of_[body]) visit(instance_of(number));
  }

  void plan_effect(std::uint64_t number, const NamedBodies<Real>& bodies) {
    list_pairs(instance_of(number), bodies);
    const EffectInstance<Real>& instance = instance_of(number);
    refresh_targets(instance.everyone, instance.targets, bodies);
  }
  void refresh_targets(bool everyone, const std::vector<BodyHandle>& targets,
                       const NamedBodies<Real>& bodies) {
    if (everyone)
      for (BodyIndex body = 0; body < flags_.size(); ++body) refresh(body, bodies);
    for (const BodyHandle target : targets) refresh(bodies.index_of(target), bodies);
  }

  /// Takes a body out of the effects that are meant for some.
  void leave_effects(BodyHandle body, const NamedBodies<Real>& bodies) {
    const BodyIndex index = bodies.index_of(body);
    while (!effects_of_[index].empty()) {
      const std::uint64_t number = effects_of_[index].back();
      EffectInstance<Real>& instance = instance_of(number);
      const std::ptrdiff_t stride = instance.effect->traits().joins_two() ? 2 : 1;
      std::vector<BodyHandle> kept, gone;
      for (auto first = instance.targets.begin(); first != instance.targets.end();
           first += stride) {
        auto& list = std::find(first, first + stride, body) == first + stride ? kept : gone;
        list.insert(list.end(), first, first + stride);
      }
      if (kept.empty()) {
        remove_effect(number, bodies);
        continue;
      }
      instance.targets = std::move(kept);
      instance.members.indices.erase(instance.effect->traits().visits_tops() ? bodies.top_of(index)
                                                                             : index);
      for (const BodyHandle target : gone) disown(bodies.index_of(target), number);
      list_pairs(instance, bodies);
      list_phase(instance);
      refresh_targets(false, gone, bodies);
    }
  }

  StepPlan<Real> plan_;
  IndexSet touched_;  // whose motion or flags somebody has changed since clear_touched()
  std::vector<BodyFlags> own_flags_, flags_;
  std::vector<std::vector<std::uint64_t>>
      effects_of_;                              // effects meant for a body, once for each pair
  std::vector<std::uint64_t> effects_for_all_;  // effects meant for all
};

}  // namespace tumble
