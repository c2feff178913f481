/// @file
/// Keeps the groups of a step right while the scene changes.
#pragma once

#include <algorithm>
#include <tumble/body_store.hpp>
#include <tumble/work.hpp>
#include <utility>

namespace tumble {

/// Keeps flags and groups. Each change touches the groups of the bodies that it concerns, and no
/// others.
template <class Real>
class Planner {
 public:
  const Work<Real>& work() const { return work_; }
  const std::vector<BodyFlags>& flags() const { return flags_; }
  /// What of the flags is the bodies' own, without the effects.
  const std::vector<BodyFlags>& alone() const { return alone_; }

  void turn_by(std::shared_ptr<const AnyRule<Real>> rule) {
    work_.rule = std::move(rule);
    ++work_.version;
  }
  void step_by(Scheme scheme) {
    work_.scheme = scheme;
    work_.substeps = substeps_of<Real>(scheme);
    ++work_.version;
  }

  /// A body was appended.
  void add_body(const NamedBodies<Real>& bodies) {
    alone_.emplace_back();
    flags_.emplace_back();
    own_.emplace_back();
    refresh(static_cast<BodyIndex>(flags_.size() - 1), bodies);
  }

  /// A body has changed.
  void change_body(BodyIndex body, const NamedBodies<Real>& bodies) {
    refresh(body, bodies);
    for (const std::uint64_t number : own_[body]) join(entry_of(number), bodies);
  }

  /// A body is about to go: its own effects and pushes go, and the last body and the last top get
  /// its places.
  void forget_body(BodyHandle handle, const NamedBodies<Real>& bodies) {
    release(handle, bodies);
    const BodyIndex body = bodies.index_of(handle), top = bodies.top_of(body);
    const auto last = static_cast<BodyIndex>(flags_.size() - 1);
    for_each_entry_of(last, [&](Entry<Real>& entry) {
      if (entry.effect->traits().visits_tops()) return;
      entry.visits.group.replace_by_last(body, last);
      list_phase(entry);
    });
    for (IndexSet* group : {&work_.pushed, &work_.movers}) group->replace_by_last(body, last);
    if (top != no_index) {
      const BodyIndex last_top = static_cast<BodyIndex>(bodies.top_count() - 1);
      for_each_entry_of(bodies.body_of(last_top), [&](Entry<Real>& entry) {
        if (!entry.effect->traits().visits_tops()) return;
        entry.visits.group.replace_by_last(top, last_top);
        list_phase(entry);
      });
      for (IndexSet* group : {&work_.torqued, &work_.steady, &work_.tumbling})
        group->replace_by_last(top, last_top);
    }
    std::erase_if(work_.inputs, [&](const Input<Real>& input) { return input.body == body; });
    for (Input<Real>& input : work_.inputs)
      if (input.body == last) input.body = body;
    replace_by_last(alone_, body);
    replace_by_last(flags_, body);
    replace_by_last(own_, body);
  }

  /// The body has gone: the pairs of the one that got its place are found again.
  void join_again(BodyIndex body, const NamedBodies<Real>& bodies) {
    ++work_.version;
    if (body < own_.size())
      for (const std::uint64_t number : own_[body]) join(entry_of(number), bodies);
  }

  /// An effect was added.
  void add_effect(Entry<Real> entry, const NamedBodies<Real>& bodies) {
    const std::uint64_t number = entry.handle.number;
    if (entry.everyone) everyone_.push_back(number);
    for (const BodyHandle target : entry.targets) own_[bodies.index_of(target)].push_back(number);
    work_.effects.push_back(std::move(entry));
    meet(number, bodies);
  }

  /// The effect becomes another one, for the same bodies.
  void replace_effect(std::uint64_t number, std::shared_ptr<const AnyEffect<Real>> effect,
                      const NamedBodies<Real>& bodies) {
    entry_of(number).effect = std::move(effect);
    meet(number, bodies);
  }

  /// The effect is removed.
  void remove_effect(std::uint64_t number, const NamedBodies<Real>& bodies) {
    const auto found = find(number);
    const bool everyone = found->everyone;
    const std::vector<BodyHandle> targets = std::move(found->targets);
    const auto place = static_cast<std::size_t>(found - work_.effects.begin());
    for (auto& list : work_.in_phase) {
      std::erase(list, place);
      for (std::size_t& later : list) later -= later > place;
    }
    work_.effects.erase(found);
    std::erase(everyone_, number);
    ++work_.version;
    for (const BodyHandle target : targets) disown(bodies.index_of(target), number);
    refresh_targets(everyone, targets, bodies);
  }

  /// What was known of a body at another time is known again.
  void restore_flags(BodyIndex body, bool moved, bool turned, const NamedBodies<Real>& bodies) {
    if (alone_[body].moves == moved && alone_[body].turns == turned) return;
    alone_[body].moves = moved;
    alone_[body].turns = turned;
    refresh(body, bodies);
  }

  /// The motion of a body is changed from outside.
  void touch(BodyIndex body) { touched_.insert(body); }
  void touched_by_nobody() { touched_ = {}; }
  /// Whose motion or flags somebody has changed since then.
  const IndexSet& touched() const { return touched_; }

  /// True if an effect that is meant for this body can limit the step.
  bool is_limiting(BodyIndex body) {
    bool found = false;
    for_each_entry_of(
        body, [&](const Entry<Real>& entry) { found |= entry.effect->traits().has_response; });
    return found;
  }

  /// A push for the next step alone.
  void add_input(BodyIndex body, const Push<Real>& push, const NamedBodies<Real>& bodies) {
    work_.inputs.push_back({body, push});
    note(alone_[body], quantity::force | quantity::torque);
    refresh(body, bodies);
  }
  /// The step was taken, with its inputs.
  void end_inputs(const NamedBodies<Real>& bodies) {
    for (const Input<Real>& input : std::exchange(work_.inputs, {})) {
      alone_[input.body].is_pushed = alone_[input.body].is_torqued = false;
      refresh(input.body, bodies);
    }
  }

 private:
  /// Finds what is known of a body, and puts it into the groups that it belongs to.
  //! [refresh]
  void refresh(BodyIndex body, const NamedBodies<Real>& bodies) {
    touched_.insert(body);
    const BodyIndex top = bodies.top_of(body);
    alone_[body] = bodies.flags_of(body, alone_[body]);
    const BodyFlags flags = flags_[body] = flags_under<Real>(alone_[body], [&](const auto& ask) {
      for_each_entry_of(body, [&](Entry<Real>& entry) { ask(*entry.effect); });
    });
    for_each_entry_of(body, [&](Entry<Real>& entry) {
      const EffectTraits<Real>& traits = entry.effect->traits();
      if (traits.joins_two() && !traits.finds_pairs) return;
      const BodyIndex member = traits.visits_tops() ? top : body;
      if (member == no_index) return;
      entry.visits.group.set(member, entry.effect->skip_reason(flags).empty());
      list_phase(entry);
    });
    work_.pushed.set(body, kick_motion.skip_reason(flags).empty());
    work_.movers.set(body, drift_motion.skip_reason(flags).empty());
    if (top != no_index) {
      work_.torqued.set(top, kick_of_spin.skip_reason(flags).empty());
      work_.steady.set(top, steady_turning.skip_reason(flags).empty());
      work_.tumbling.set(top, tumbling_motion.skip_reason(flags).empty());
    }
    ++work_.version;
  }
  //! [refresh]

  /// The pairs that an effect on two visits: those of which it can change something.
  void join(Entry<Real>& entry, const NamedBodies<Real>& bodies) {
    const EffectTraits<Real>& traits = entry.effect->traits();
    if (!traits.joins_two() || traits.finds_pairs) return;
    entry.visits.pairs.clear();
    if (entry.effect->skip_reason(BodyFlags{}).empty())
      for (std::size_t i = 0; i < entry.targets.size(); i += 2) {
        const BodyPair pair{bodies.index_of(entry.targets[i]),
                            bodies.index_of(entry.targets[i + 1])};
        if (unwritable_reason(traits.writes, bodies.flags_of(pair.first, {})).empty() ||
            unwritable_reason(traits.writes, bodies.flags_of(pair.second, {})).empty())
          entry.visits.pairs.push_back(pair);
      }
    list_phase(entry);
  }

  /// Puts the effect into the list of its phase if it visits somebody, else takes it out.
  void list_phase(const Entry<Real>& entry) {
    auto& list = work_.in_phase[static_cast<std::size_t>(entry.effect->phase())];
    const auto place = static_cast<std::size_t>(&entry - work_.effects.data());
    const auto found = std::lower_bound(list.begin(), list.end(), place);
    const bool is_listed = found != list.end() && *found == place;
    if (is_listed == (entry.visits.size() > 0)) return;
    if (is_listed)
      list.erase(found);
    else
      list.insert(found, place);
  }

  auto find(std::uint64_t number) {
    return std::lower_bound(
        work_.effects.begin(), work_.effects.end(), number,
        [](const Entry<Real>& entry, std::uint64_t n) { return entry.handle.number < n; });
  }
  Entry<Real>& entry_of(std::uint64_t number) { return *find(number); }

  void disown(BodyIndex body, std::uint64_t number) {
    const auto found = std::find(own_[body].begin(), own_[body].end(), number);
    if (found != own_[body].end()) own_[body].erase(found);
  }

  template <class Visit>
  void for_each_entry_of(BodyIndex body, const Visit& visit) {
    for (const std::uint64_t number : everyone_) visit(entry_of(number));
    for (const std::uint64_t number : own_[body]) visit(entry_of(number));
  }

  void meet(std::uint64_t number, const NamedBodies<Real>& bodies) {
    join(entry_of(number), bodies);
    const Entry<Real>& entry = entry_of(number);
    refresh_targets(entry.everyone, entry.targets, bodies);
  }
  void refresh_targets(bool everyone, const std::vector<BodyHandle>& targets,
                       const NamedBodies<Real>& bodies) {
    if (everyone)
      for (BodyIndex body = 0; body < flags_.size(); ++body) refresh(body, bodies);
    for (const BodyHandle target : targets) refresh(bodies.index_of(target), bodies);
  }

  /// Takes a body out of the effects that are meant for some.
  void release(BodyHandle body, const NamedBodies<Real>& bodies) {
    const BodyIndex index = bodies.index_of(body);
    while (!own_[index].empty()) {
      const std::uint64_t number = own_[index].back();
      Entry<Real>& entry = entry_of(number);
      const std::ptrdiff_t stride = entry.effect->traits().joins_two() ? 2 : 1;
      std::vector<BodyHandle> kept, gone;
      for (auto first = entry.targets.begin(); first != entry.targets.end(); first += stride) {
        auto& list = std::find(first, first + stride, body) == first + stride ? kept : gone;
        list.insert(list.end(), first, first + stride);
      }
      if (kept.empty()) {
        remove_effect(number, bodies);
        continue;
      }
      entry.targets = std::move(kept);
      entry.visits.group.erase(entry.effect->traits().visits_tops() ? bodies.top_of(index) : index);
      for (const BodyHandle target : gone) disown(bodies.index_of(target), number);
      join(entry, bodies);
      list_phase(entry);
      refresh_targets(false, gone, bodies);
    }
  }

  Work<Real> work_;
  IndexSet touched_;  // whose motion or flags somebody has changed since touched_by_nobody()
  std::vector<BodyFlags> alone_, flags_;
  std::vector<std::vector<std::uint64_t>> own_;  // effects meant for a body, once for each pair
  std::vector<std::uint64_t> everyone_;          // effects meant for all
};

}  // namespace tumble
