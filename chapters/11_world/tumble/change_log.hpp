/// @file
/// What has changed the plan, in sentences.
#pragma once

#include <deque>
#include <tumble/plan.hpp>

namespace tumble {

/// Notes why a plan may have changed, and says what in it has. It keeps the last hundred
/// sentences.
class ChangeLog {
 public:
  static constexpr std::size_t most = 100;

  /// Something happened that may change the plan.
  void note(const std::string& cause) {
    if (causes_.size() < 3) causes_.push_back(cause);
    ++cause_count_;
  }
  bool is_pending() const { return cause_count_ > 0; }

  /// A sentence for each effect that visits more bodies now than at the last call, or fewer.
  template <class Real>
  void tell(const Work<Real>& work, std::size_t bodies, std::int64_t tick) {
    std::vector<Count> now = counts_of(work, bodies);
    if (!counts_.empty())  // the first plan is no news
      for (const Count& count : now) {
        const auto before = std::lower_bound(
            counts_.begin(), counts_.end(), count.number,
            [](const Count& other, std::uint64_t number) { return other.number < number; });
        const bool was_there = before != counts_.end() && before->number == count.number;
        const std::size_t visited = was_there ? before->visited : 0;
        if (visited != count.visited)
          sentences_.push_back("step " + std::to_string(tick) + ": " + name_of(count, work) +
                               " visits " + std::to_string(count.visited) + " of " +
                               std::to_string(count.of) + ", before " + std::to_string(visited) +
                               " (" + why() + ")");
        if (sentences_.size() > most) sentences_.pop_front();
      }
    counts_ = std::move(now);
    causes_.clear();
    cause_count_ = 0;
  }

  std::vector<std::string> sentences() const { return {sentences_.begin(), sentences_.end()}; }

 private:
  struct Count {
    std::uint64_t number;  ///< of the effect; of a motion less than any
    std::size_t visited, of;
  };

  template <class Real>
  static std::vector<Count> counts_of(const Work<Real>& work, std::size_t bodies) {
    std::vector<Count> counts = {{0, work.pushed.size(), bodies},
                                 {1, work.torqued.size(), bodies},
                                 {2, work.movers.size(), bodies},
                                 {3, work.steady.size(), bodies},
                                 {4, work.tumbling.size(), bodies}};
    for (const Entry<Real>& entry : work.effects)
      counts.push_back({first_number + entry.handle.number, entry.visits.size(),
                        entry.everyone
                            ? bodies
                            : entry.targets.size() / (entry.effect->traits().joins_two() ? 2 : 1)});
    return counts;
  }

  template <class Real>
  static std::string name_of(const Count& count, const Work<Real>& work) {
    constexpr std::array<std::string_view, 4> motions = {kick_motion.name, kick_of_spin.name,
                                                         drift_motion.name, steady_turning.name};
    if (count.number < motions.size()) return std::string(motions[count.number]);
    if (count.number < first_number) return "tumbling: " + work.rule->name();
    for (const Entry<Real>& entry : work.effects)
      if (first_number + entry.handle.number == count.number) return entry.effect->name();
    return {};
  }

  /// "'a' came, 'b' came, 'c' came and 4 more"
  std::string why() const {
    std::string text;
    for (const std::string& cause : causes_) text.append(text.empty() ? "" : ", ").append(cause);
    if (cause_count_ > causes_.size())
      text.append(" and ").append(std::to_string(cause_count_ - causes_.size())).append(" more");
    return text;
  }

  static constexpr std::uint64_t first_number = 5;
  std::vector<std::string> causes_;  // the first three
  std::size_t cause_count_ = 0;
  std::vector<Count> counts_;  // in the order of their numbers
  std::deque<std::string> sentences_;
};

}  // namespace tumble
