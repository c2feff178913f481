/// @file
/// What has changed the plan, in sentences.
#pragma once

#include <map>
#include <tumble/step_plan.hpp>

namespace tumble {

/// Notes why a plan may have changed, and says what in it has. It keeps the last hundred
/// sentences.
class ChangeLog {
 public:
  static constexpr std::size_t most = 100;

  /// Something happened that may change the plan.
  void note(std::initializer_list<std::string_view> cause) {
    if (causes_.size() < 3) causes_.push_back(joined(cause));
    ++cause_count_;
  }
  /// Whether anything has changed that no sentence tells yet.
  bool is_pending() const { return cause_count_ > 0; }

  /// A sentence for each effect or motion that visits more bodies now than at the last call, or
  /// fewer.
  template <class Real>
  void tell(const StepPlan<Real>& plan, std::size_t bodies, std::int64_t tick) {
    std::map<std::uint64_t, std::size_t> now;
    const auto count = [&](const EffectInstance<Real>& instance, std::uint64_t key) {
      const auto then = visited_.find(key);
      const std::size_t before = then == visited_.end() ? 0 : then->second;
      const std::size_t visited = instance.members.size();
      now.emplace(key, visited);
      if (visited_.empty() || visited == before) return;  // the first plan is no change
      const std::size_t of = instance.meant_for(bodies);
      sentences_.push_back(joined({"step ", std::to_string(tick), ": ", instance.effect->name(),
                                   " visits ", std::to_string(visited), " of ", std::to_string(of),
                                   ", before ", std::to_string(before), " (", why(), ")"}));
      if (sentences_.size() > most) sentences_.erase(sentences_.begin());
    };
    for (std::size_t i = 0; i < plan.motions.size(); ++i) count(plan.motions[i], i);
    for (const EffectInstance<Real>& instance : plan.effects)
      count(instance, first_effect + instance.handle.number);
    visited_ = std::move(now);
    causes_.clear();
    cause_count_ = 0;
  }

  /// The latest of them, the oldest first.
  const std::vector<std::string>& sentences() const { return sentences_; }

 private:
  static constexpr std::uint64_t first_effect = std::uint64_t{1} << 32;

  /// "'a' came, 'b' came, 'c' came and 4 more"
  std::string why() const {
    std::string text;
    for (const std::string& cause : causes_) text.append(text.empty() ? "" : ", ").append(cause);
    if (cause_count_ > causes_.size())
      text.append(" and ").append(std::to_string(cause_count_ - causes_.size())).append(" more");
    return text;
  }

  std::vector<std::string> causes_;  // the first three
  std::size_t cause_count_ = 0;
  std::map<std::uint64_t, std::size_t> visited_;  // bodies or pairs, by motion or effect
  std::vector<std::string> sentences_;
};

}  // namespace tumble
