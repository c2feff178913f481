/// @file
/// A turning rule of whatever type, run on a group of tops.
#pragma once

#include <memory>
#include <string>
#include <tumble/group.hpp>
#include <tumble/turning_methods.hpp>

namespace tumble {

/// A TurningRule, so that a world can be given one while it runs.
template <class Real>
class AnyRule {
 public:
  virtual ~AnyRule() = default;
  const std::string& name() const { return name_; }
  virtual void turn(std::vector<Top<Real>>& tops, const Group& group, Real time_step) const = 0;

 protected:
  explicit AnyRule(std::string_view name) : name_(name) {}

 private:
  std::string name_;
};

/// @cond the base class says what it does
template <class Real, class Rule>
class RuleOf : public AnyRule<Real> {
 public:
  explicit RuleOf(const Rule& rule) : AnyRule<Real>(Rule::name), rule_(rule) {}
  void turn(std::vector<Top<Real>>& tops, const Group& group, Real time_step) const override {
    for_each_of(group, tops, [&](Top<Real>& top) { rule_(top, time_step); });
  }
  const Rule& rule() const { return rule_; }

 private:
  Rule rule_;
};
/// @endcond

}  // namespace tumble
