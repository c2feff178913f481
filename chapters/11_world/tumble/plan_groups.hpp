/// @file
/// The groups of a step: who is in which.
#pragma once

#include <algorithm>
#include <tumble/body_flags.hpp>
#include <tumble/work.hpp>

namespace tumble {

/// Flags and groups, and how those of one body are found. Planner says when.
template <class Real>
class PlanGroups {
 public:
  const Work<Real>& work() const { return work_; }
  const std::vector<BodyFlags>& flags() const { return flags_; }
  /// What of the flags is the bodies' own, without the effects.
  const std::vector<BodyFlags>& alone() const { return alone_; }

 protected:
  /// Finds what is known of a body, and puts it into the groups that it belongs to.
  //! [refresh]
  template <class Roster>
  void refresh(BodyIndex body, const Roster& roster) {
    touched_.insert(body);
    const BodyIndex top = roster.top_of(body);
    alone_[body] = roster.flags_of(body, alone_[body]);
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
  template <class Roster>
  void join(Entry<Real>& entry, const Roster& roster) {
    const EffectTraits<Real>& traits = entry.effect->traits();
    if (!traits.joins_two() || traits.finds_pairs) return;
    entry.visits.pairs.clear();
    if (entry.effect->skip_reason(BodyFlags{}).empty())
      for (std::size_t i = 0; i < entry.targets.size(); i += 2) {
        const BodyPair pair{roster.index_of(entry.targets[i]),
                            roster.index_of(entry.targets[i + 1])};
        if (unwritable_reason(traits.writes, roster.flags_of(pair.first, {})).empty() ||
            unwritable_reason(traits.writes, roster.flags_of(pair.second, {})).empty())
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
      for (BodyIndex body = 0; body < flags_.size(); ++body) refresh(body, roster);
    for (const BodyHandle target : targets) refresh(roster.index_of(target), roster);
  }

  Work<Real> work_;
  IndexSet touched_;  // whose motion or flags somebody has changed since touched_by_nobody()
  std::vector<BodyFlags> alone_, flags_;
  std::vector<std::vector<std::uint64_t>> own_;  // effects meant for a body, once for each pair
  std::vector<std::uint64_t> everyone_;          // effects meant for all
};

}  // namespace tumble
