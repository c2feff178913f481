/// @file
/// Keeps the groups of a step right while the scene changes.
#pragma once

#include <tumble/plan_groups.hpp>
#include <utility>

namespace tumble {

/// Keeps flags and groups. Each change touches the groups of the bodies that it concerns, and no
/// others. `roster` says which body has which place, and what it is, see NamedBodies.
template <class Real>
class Planner : public PlanGroups<Real> {
  using Base = PlanGroups<Real>;
  using Base::entry_of, Base::for_each_entry_of, Base::join, Base::list_phase;
  using Base::find, Base::disown, Base::meet, Base::refresh, Base::refresh_targets;
  using Base::work_, Base::touched_, Base::alone_, Base::flags_, Base::own_, Base::everyone_;

 public:
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
  template <class Roster>
  void add_body(const Roster& roster) {
    alone_.emplace_back();
    flags_.emplace_back();
    own_.emplace_back();
    refresh(static_cast<BodyIndex>(flags_.size() - 1), roster);
  }

  /// A body has changed.
  template <class Roster>
  void change_body(BodyIndex body, const Roster& roster) {
    refresh(body, roster);
    for (const std::uint64_t number : own_[body]) join(entry_of(number), roster);
  }

  /// A body is about to go: its own effects and pushes go, and the last body and the last top get
  /// its places.
  template <class Roster>
  void forget_body(BodyHandle handle, const Roster& roster) {
    release(handle, roster);
    const BodyIndex body = roster.index_of(handle), top = roster.top_of(body);
    const auto last = static_cast<BodyIndex>(flags_.size() - 1);
    for_each_entry_of(last, [&](Entry<Real>& entry) {
      if (entry.effect->traits().visits_tops()) return;
      entry.visits.group.replace_by_last(body, last);
      list_phase(entry);
    });
    for (IndexSet* group : {&work_.pushed, &work_.movers}) group->replace_by_last(body, last);
    if (top != no_index) {
      const BodyIndex last_top = roster.last_top();
      for_each_entry_of(roster.body_of(last_top), [&](Entry<Real>& entry) {
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
  template <class Roster>
  void join_again(BodyIndex body, const Roster& roster) {
    ++work_.version;
    if (body < own_.size())
      for (const std::uint64_t number : own_[body]) join(entry_of(number), roster);
  }

  /// An effect was added.
  template <class Roster>
  void add_effect(Entry<Real> entry, const Roster& roster) {
    const std::uint64_t number = entry.handle.number;
    if (entry.everyone) everyone_.push_back(number);
    for (const BodyHandle target : entry.targets) own_[roster.index_of(target)].push_back(number);
    work_.effects.push_back(std::move(entry));
    meet(number, roster);
  }

  /// The effect becomes another one, for the same bodies.
  template <class Roster>
  void replace_effect(std::uint64_t number, std::shared_ptr<const AnyEffect<Real>> effect,
                      const Roster& roster) {
    entry_of(number).effect = std::move(effect);
    meet(number, roster);
  }

  /// The effect is removed.
  template <class Roster>
  void remove_effect(std::uint64_t number, const Roster& roster) {
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
    for (const BodyHandle target : targets) disown(roster.index_of(target), number);
    refresh_targets(everyone, targets, roster);
  }

  /// What was known of the bodies at another time is known again.
  template <class Roster>
  void restore_flags(const std::vector<bool>& moved, const std::vector<bool>& turned,
                     const Roster& roster) {
    for (BodyIndex body = 0; body < flags_.size(); ++body)
      restore_flags(body, moved[body], turned[body], roster);
  }

  /// The same for one body.
  template <class Roster>
  void restore_flags(BodyIndex body, bool moved, bool turned, const Roster& roster) {
    if (alone_[body].moves == moved && alone_[body].turns == turned) return;
    alone_[body].moves = moved;
    alone_[body].turns = turned;
    refresh(body, roster);
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
  template <class Roster>
  void add_input(BodyIndex body, const Push<Real>& push, const Roster& roster) {
    work_.inputs.push_back({body, push});
    note(alone_[body], quantity::force | quantity::torque);
    refresh(body, roster);
  }
  /// The step was taken, with its inputs.
  template <class Roster>
  void end_inputs(const Roster& roster) {
    for (const Input<Real>& input : std::exchange(work_.inputs, {})) {
      alone_[input.body].is_pushed = alone_[input.body].is_torqued = false;
      refresh(input.body, roster);
    }
  }

 private:
  /// Takes a body out of the effects that are meant for some.
  template <class Roster>
  void release(BodyHandle body, const Roster& roster) {
    const BodyIndex index = roster.index_of(body);
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
        remove_effect(number, roster);
        continue;
      }
      entry.targets = std::move(kept);
      entry.visits.group.erase(entry.effect->traits().visits_tops() ? roster.top_of(index) : index);
      for (const BodyHandle target : gone) disown(roster.index_of(target), number);
      join(entry, roster);
      list_phase(entry);
      refresh_targets(false, gone, roster);
    }
  }
};

}  // namespace tumble
