/// @file
/// Keeps the groups of a step right while the scene changes.
#pragma once

#include <algorithm>
#include <tumble/facts.hpp>
#include <tumble/work.hpp>
#include <utility>

namespace tumble {

/// Keeps facts and groups. Each change touches the groups of the bodies that it concerns, and no
/// others. `roster` says which body has which place, and what it is, see NamedBodies.
//! [planner]
template <class Real>
class Planner {
 public:
  const Work<Real>& work() const { return work_; }
  const std::vector<Facts>& facts() const { return facts_; }
  /// What of the facts is the bodies' own, without the effects.
  const std::vector<Facts>& alone() const { return alone_; }
  void turn_by(std::shared_ptr<const AnyRule<Real>> rule) {
    work_.rule = std::move(rule);
    ++work_.version;
  }

  /// A body was appended.
  template <class Roster>
  void add_body(const Roster& roster) {
    alone_.emplace_back();
    facts_.emplace_back();
    own_.emplace_back();
    refresh(static_cast<BodyIndex>(facts_.size() - 1), roster);
  }

  /// A body is other than it was.
  template <class Roster>
  void change_body(BodyIndex body, const Roster& roster) {
    refresh(body, roster);
    for (const std::uint64_t number : own_[body]) join(entry_of(number), roster);
  }

  /// A body is about to go: its own effects go, and the last body and the last top get its places.
  template <class Roster>
  void forget_body(BodyHandle handle, const Roster& roster) {
    release(handle, roster);
    const BodyIndex body = roster.index_of(handle), top = roster.top_of(body);
    const auto last = static_cast<BodyIndex>(facts_.size() - 1);
    for_each_entry_of(last, [&](Entry<Real>& entry) {
      if (entry.effect->traits().visits_tops()) return;
      entry.visits.group.replace_by_last(body, last);
      list_phase(entry);
    });
    for (Group* group : {&work_.pushed, &work_.movers}) group->replace_by_last(body, last);
    if (top != no_index) {
      const BodyIndex last_top = roster.last_top();
      for_each_entry_of(roster.body_of(last_top), [&](Entry<Real>& entry) {
        if (!entry.effect->traits().visits_tops()) return;
        entry.visits.group.replace_by_last(top, last_top);
        list_phase(entry);
      });
      for (Group* group : {&work_.torqued, &work_.steady, &work_.tumbling})
        group->replace_by_last(top, last_top);
    }
    replace_by_last(alone_, body);
    replace_by_last(facts_, body);
    replace_by_last(own_, body);
  }

  /// It has gone: the body in its place has the pairs that it had.
  template <class Roster>
  void join_again(BodyIndex body, const Roster& roster) {
    ++work_.version;
    if (body < own_.size())
      for (const std::uint64_t number : own_[body]) join(entry_of(number), roster);
  }

  /// An effect came.
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
    Entry<Real>& entry = entry_of(number);
    entry.effect = std::move(effect);
    entry.visits = {};
    list_phases();
    meet(number, roster);
  }

  /// The effect goes.
  template <class Roster>
  void remove_effect(std::uint64_t number, const Roster& roster) {
    const auto found = find(number);
    const bool everyone = found->everyone;
    const std::vector<BodyHandle> targets = std::move(found->targets);
    work_.effects.erase(found);
    std::erase(everyone_, number);
    list_phases();
    for (const BodyHandle target : targets) disown(roster.index_of(target), number);
    refresh_targets(everyone, targets, roster);
  }

  /// True if an effect that is meant for this body can limit the step.
  bool holds_spring(BodyIndex body) {
    bool found = false;
    for_each_entry_of(body, [&](const Entry<Real>& entry) { found |= is_spring(*entry.effect); });
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
  //! [planner]

 private:
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

  template <class Roster>
  void meet(std::uint64_t number, const Roster& roster) {
    join(entry_of(number), roster);
    const Entry<Real>& entry = entry_of(number);
    refresh_targets(entry.everyone, entry.targets, roster);
  }
  template <class Roster>
  void refresh_targets(bool everyone, const std::vector<BodyHandle>& targets,
                       const Roster& roster) {
    if (everyone)
      for (BodyIndex body = 0; body < facts_.size(); ++body) refresh(body, roster);
    for (const BodyHandle target : targets) refresh(roster.index_of(target), roster);
  }

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

  /// Finds what is known of a body, and puts it into the groups that it belongs to.
  //! [refresh]
  template <class Roster>
  void refresh(BodyIndex body, const Roster& roster) {
    const BodyIndex top = roster.top_of(body);
    alone_[body] = roster.facts_of(body, alone_[body]);
    const Facts facts = facts_[body] = facts_under<Real>(alone_[body], [&](const auto& ask) {
      for_each_entry_of(body, [&](Entry<Real>& entry) { ask(*entry.effect); });
    });
    for_each_entry_of(body, [&](Entry<Real>& entry) {
      const EffectTraits<Real>& traits = entry.effect->traits();
      if (traits.joins_two() && !traits.finds_pairs) return;
      const BodyIndex member = traits.visits_tops() ? top : body;
      if (member == no_index) return;
      entry.visits.group.set(member, entry.effect->why_skipped(facts).empty());
      list_phase(entry);
    });
    work_.pushed.set(body, kick_motion.why_skipped(facts).empty());
    work_.movers.set(body, drift_motion.why_skipped(facts).empty());
    if (top != no_index) {
      work_.torqued.set(top, kick_of_spin.why_skipped(facts).empty());
      work_.steady.set(top, steady_turning.why_skipped(facts).empty());
      work_.tumbling.set(top, tumbling_motion.why_skipped(facts).empty());
    }
    ++work_.version;
  }
  //! [refresh]

  /// The pairs that an effect on two visits: those of which it can change something.
  template <class Roster>
  void join(Entry<Real>& entry, const Roster& roster) {
    const EffectTraits<Real>& traits = entry.effect->traits();
    if (!traits.joins_two() || traits.finds_pairs) return;
    entry.visits.pairs.clear();
    if (entry.effect->why_skipped(Facts{}).empty())
      for (std::size_t i = 0; i < entry.targets.size(); i += 2) {
        const BodyPair pair{roster.index_of(entry.targets[i]),
                            roster.index_of(entry.targets[i + 1])};
        if (why_unwritable(traits.writes, roster.facts_of(pair.first, {})).empty() ||
            why_unwritable(traits.writes, roster.facts_of(pair.second, {})).empty())
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
  void list_phases() {
    for (auto& list : work_.in_phase) list.clear();
    for (const Entry<Real>& entry : work_.effects) list_phase(entry);
    ++work_.version;
  }

  Work<Real> work_;
  std::vector<Facts> alone_, facts_;
  std::vector<std::vector<std::uint64_t>> own_;  // effects meant for a body, once for each pair
  std::vector<std::uint64_t> everyone_;          // effects meant for all
};

}  // namespace tumble
