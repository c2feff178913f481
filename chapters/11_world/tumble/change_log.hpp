/// @file
/// What has changed the plan, in sentences.
#pragma once

#include <deque>
#include <map>
#include <tumble/step_plan.hpp>

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

  /// A sentence for each effect or motion that visits more bodies now than at the last call, or
  /// fewer.
  template <class Real>
  void tell(const StepPlan<Real>& plan, std::size_t bodies, std::int64_t tick) {
    std::map<std::uint64_t, std::size_t> now;
    const auto count = [&](const EffectInstance<Real>& instance, std::uint64_t number) {
      const std::size_t visited = now[number] = instance.members.size();
      const auto found = visited_.find(number);
      const std::size_t before = found == visited_.end() ? 0 : found->second;
      if (visited_.empty() || visited == before) return;  // the first plan is no change
      const std::size_t of = instance.meant_for(bodies);
      sentences_.push_back("step " + std::to_string(tick) + ": " + instance.effect->name() +
                           " visits " + std::to_string(visited) + " of " + std::to_string(of) +
                           ", before " + std::to_string(before) + " (" + why() + ")");
      if (sentences_.size() > most) sentences_.pop_front();
    };
    for (std::size_t i = 0; i < plan.motions.size(); ++i) count(plan.motions[i], ~std::uint64_t{i});
    for (const EffectInstance<Real>& instance : plan.effects)
      count(instance, instance.handle.number);
    visited_ = std::move(now);
    causes_.clear();
    cause_count_ = 0;
  }

  std::vector<std::string> sentences() const { return {sentences_.begin(), sentences_.end()}; }

 private:
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
  std::map<std::uint64_t, std::size_t> visited_;  // how many, by effect and motion
  std::deque<std::string> sentences_;
};

}  // namespace tumble
