/// @file
/// A turning rule of whatever type, run on a group of tops.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <tumble/index_set.hpp>
#include <tumble/turning_methods.hpp>

namespace tumble {

/// A TurningRule, so that a world can be given one while it runs.
template <class Real>
class AnyRule {
 public:
  virtual ~AnyRule() = default;
  const std::string& name() const { return name_; }
  /// The power of the time step with which the rule's error falls, if it says.
  std::optional<int> order() const { return order_; }
  /// True if it says that a step back undoes a step forth.
  bool is_symmetric() const { return is_symmetric_; }
  virtual void turn(std::vector<Top<Real>>& tops, const IndexSet& group, Real time_step) const = 0;

 protected:
  template <class Rule>
  explicit AnyRule(const Rule&) : name_(Rule::name) {
    if constexpr (requires { Rule::order; }) order_ = Rule::order;
    if constexpr (requires { Rule::is_symmetric; }) is_symmetric_ = Rule::is_symmetric;
  }

 private:
  std::string name_;
  std::optional<int> order_;
  bool is_symmetric_ = false;
};

/// @cond the base class says what it does
template <class Real, class Rule>
class RuleOf : public AnyRule<Real> {
 public:
  explicit RuleOf(const Rule& rule) : AnyRule<Real>(rule), rule_(rule) {}
  void turn(std::vector<Top<Real>>& tops, const IndexSet& group, Real time_step) const override {
    for_each_of(group, tops, [&](Top<Real>& top) { rule_(top, time_step); });
  }
  const Rule& rule() const { return rule_; }

 private:
  Rule rule_;
};
/// @endcond

}  // namespace tumble
