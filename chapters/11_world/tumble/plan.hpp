/// @file
/// What a plan says: a table with a line for each effect, and a reason in each line.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <tumble/effect.hpp>
#include <utility>
#include <vector>

namespace tumble {

/// The name of a phase.
inline std::string_view name_of(Phase phase) {
  constexpr std::array<std::string_view, 5> names = {"force", "kick", "impulse", "damping",
                                                     "drift"};
  return names[static_cast<std::size_t>(phase)];
}

/// One line of a plan.
//! [plan_row]
struct PlanRow {
  std::string effect;
  Phase phase = Phase::force;
  std::size_t visited = 0;  ///< bodies that the effect visits in each step; for joins: pairs
  std::size_t of = 0;       ///< bodies that it was meant for
  std::string reads, writes, reason;
};
//! [plan_row]

/// What each step will do, in this order, and nothing else.
struct Plan {
  std::vector<PlanRow> rows;
  std::vector<std::string> warnings;  ///< what may go wrong, such as a step too long for a spring
};

/// Counts why bodies are skipped, and makes the sentence of a row of it.
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

  /// "every body calls for it", or the reasons of the others with their counts.
  std::string sentence(std::string_view noun) const {
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

/// What is different between two plans, a sentence for each effect that visits more bodies now or
/// fewer; `tick` and `why` say when that came and what called for it.
inline std::vector<std::string> news_between(const Plan& old, const Plan& now, std::int64_t tick,
                                             const std::string& why) {
  std::vector<std::string> news;
  for (const PlanRow& row : now.rows) {
    const auto before = std::find_if(old.rows.begin(), old.rows.end(), [&](const PlanRow& other) {
      return other.effect == row.effect;
    });
    const std::size_t visited = before == old.rows.end() ? 0 : before->visited;
    if (visited != row.visited)
      news.push_back("step " + std::to_string(tick) + ": " + row.effect + " visits " +
                     std::to_string(row.visited) + " of " + std::to_string(row.of) + ", before " +
                     std::to_string(visited) + " (" + why + ")");
  }
  return news;
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
  Row::size_type column = 0;
  std::array<std::size_t, 6> widths{};
  for (const Row& row : table)
    for (column = 0; column < row.size(); ++column)
      widths[column] = std::max(widths[column], row[column].size());
  std::string text;
  for (const Row& row : table) {
    std::string line;
    for (column = 0; column < row.size(); ++column) {
      line += row[column];
      if (column + 1 < row.size()) line.append(widths[column] + 2 - row[column].size(), ' ');
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text.append(line).append("\n");
  }
  for (const std::string& warning : plan.warnings) text.append("warning: ").append(warning) += '\n';
  return text;
}

}  // namespace tumble
