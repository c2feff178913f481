/// @file
/// What a plan says: a table with a line for each effect, and a reason in each line.
#pragma once

#include <algorithm>
#include <tumble/accuracy.hpp>
#include <tumble/planner.hpp>
#include <tumble/step_order.hpp>

namespace tumble {

/// The name of a phase.
inline std::string_view name_of(Phase phase) {
  constexpr std::array<std::string_view, 6> names = {"force",   "kick", "impulse",
                                                     "damping", "turn", "drift"};
  return names[static_cast<std::size_t>(phase)];
}

/// One line of a plan.
struct PlanRow {
  std::string effect;          ///< its name
  Phase phase = Phase::force;  ///< in which part of a step it acts
  std::size_t visited = 0;     ///< bodies that the effect visits in each step; or pairs
  std::size_t of = 0;          ///< bodies, or pairs, that it was meant for
  std::string reads;           ///< the quantities that it looks at, "position, velocity"
  std::string writes;          ///< and those that it changes
  std::string reason;          ///< why it visits those bodies and no others
};

/// What each step does, in this order.
struct Plan {
  std::vector<PlanRow> rows;          ///< effects and motions in the order of a step
  Accuracy accuracy;                  ///< how the error falls with the step
  std::vector<std::string> warnings;  ///< what may go wrong, such as a step too long for a spring
  std::vector<std::string> unknown;   ///< which effects don't say how they limit the step
  /// The lines of those that visit somebody.
  std::size_t passes() const {
    return static_cast<std::size_t>(
        std::count_if(rows.begin(), rows.end(), [](const PlanRow& row) { return row.visited; }));
  }
};

namespace detail {

/// Counts why bodies are skipped, and makes a row's sentence of them.
class Reasons {
 public:
  void add(std::string_view reason) {
    const auto found = std::find_if(counts_.begin(), counts_.end(),
                                    [&](const auto& count) { return count.first == reason; });
    if (found == counts_.end())
      counts_.emplace_back(reason, 1);
    else
      ++found->second;
  }

  /// "every body calls for it", or the reasons of the others with their counts. `of`: how many
  /// there are.
  std::string sentence(std::string_view noun, std::size_t of) const {
    if (of == 0) return std::string("there is no ").append(noun);
    if (counts_.empty()) return std::string("every ").append(noun).append(" calls for it");
    std::string text;
    for (const auto& [reason, count] : counts_) {
      if (!text.empty()) text += "; ";
      text.append("not ").append(std::to_string(count)).append(": ").append(reason);
    }
    return text;
  }

 private:
  std::vector<std::pair<std::string_view, std::size_t>> counts_;
};

}  // namespace detail

/// The line of an effect, or of a motion.
template <class Real>
PlanRow row_of(const EffectInstance<Real>& instance, const Planner<Real>& planner,
               const NamedBodies<Real>& bodies) {
  const AnyEffect<Real>& effect = *instance.effect;
  const std::vector<BodyFlags>& flags = planner.flags();
  detail::Reasons reasons;
  const auto ask = [&](std::string_view why) {
    if (!why.empty()) reasons.add(why);
  };
  const bool in_pairs = effect.traits().joins_two() && !effect.traits().finds_pairs;
  const auto is_fixed = [&](BodyHandle body) {
    return !unwritable_reason(effect.traits().writes, flags[bodies.index_of(body)]).empty();
  };
  if (in_pairs)
    for (std::size_t i = 0; i < instance.targets.size(); i += 2)
      ask(is_fixed(instance.targets[i]) && is_fixed(instance.targets[i + 1])
              ? "nothing can move either of the two"
              : effect.skip_reason(BodyFlags{}));
  else if (instance.everyone)
    for (const BodyFlags& body : flags) ask(effect.skip_reason(body));
  else
    for (const BodyHandle body : instance.targets)
      ask(effect.skip_reason(flags[bodies.index_of(body)]));
  const std::size_t of = instance.meant_for(flags.size());
  return {effect.name(),
          effect.phase(),
          instance.members.size(),
          of,
          text_of(effect.traits().reads),
          text_of(effect.traits().writes),
          reasons.sentence(in_pairs ? "pair" : "body", of)};
}

/// The lines of all, in the order of a step with one kick. A rotor has one for all that it does.
template <class Real>
std::vector<PlanRow> rows_of(const Planner<Real>& planner, const NamedBodies<Real>& bodies) {
  const StepPlan<Real>& plan = planner.step_plan();
  std::vector<PlanRow> rows;
  for (const Pass<Real>& pass : all_passes(plan, substeps_of<Real>(Scheme::semi_implicit_euler))) {
    const bool is_again = pass.row.kind == PassKind::rotor && pass.row.act != RotorAct::join;
    if (pass.row.kind != PassKind::input && !is_again)
      rows.push_back(row_of(instance_of(pass, plan), planner, bodies));
  }
  return rows;
}

/// The plan as a table of text, like a database's EXPLAIN. Effects that nobody calls for are listed
/// below the others: they are no pass at all.
inline std::string table_of(const Plan& plan) {
  using Row = std::array<std::string, 6>;
  std::vector<Row> table = {{"effect", "phase", "bodies", "reads", "writes", "why"}};
  for (const bool runs : {true, false})
    for (const PlanRow& row : plan.rows)
      if ((row.visited > 0) == runs)
        table.push_back({row.effect, runs ? std::string(name_of(row.phase)) : "no pass",
                         std::to_string(row.visited) + " of " + std::to_string(row.of), row.reads,
                         row.writes, row.reason});
  std::array<std::size_t, 6> widths{};
  for (const Row& row : table)
    for (std::size_t column = 0; column < row.size(); ++column)
      widths[column] = std::max(widths[column], row[column].size());
  std::string text;
  for (const Row& row : table) {
    std::string line;
    for (std::size_t column = 0; column < row.size(); ++column) {
      line += row[column];
      if (column + 1 < row.size()) line.append(widths[column] + 2 - row[column].size(), ' ');
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text.append(line).append("\n");
  }
  text.append(text_of(plan.accuracy)).append("\n");
  for (const std::string& what : plan.unknown)
    text.append("limit of the step unknown: ").append(what) += '\n';
  for (const std::string& warning : plan.warnings) text.append("warning: ").append(warning) += '\n';
  return text;
}

}  // namespace tumble
