/// @file
/// Two worlds, one stepped by its plan and one exhaustively, until they part.
#pragma once

#include <support/complaint_of_step.hpp>
#include <support/exhaustive.hpp>
#include <support/record.hpp>

#include "options.hpp"

namespace tumble::simulate {

struct Comparison {
  ExitCode code;  ///< all_simulated if they never part, else step_failed
  std::string said;
};

/// Takes so many steps, or those until one can't be taken.
template <class Real, class Backend>
Comparison compared(World<Real, Backend>& planned, World<Real, Backend>& exhaustive,
                    std::int64_t steps) {
  std::string said;
  for (std::int64_t step = 1; step <= steps && said.empty(); ++step) {
    const std::string complaint = support::complaint_of_step([&] { planned.step(); });
    const std::string other = support::complaint_of_step([&] { exhaustive.step_exhaustively(); });
    const auto difference = support::first_difference(planned.bodies(), exhaustive.bodies());
    std::string where;
    if (other != complaint)
      where = "by plan it ends with \"" + complaint + "\", and without with \"" + other + "\"";
    else if (!difference.what.empty())
      where = "'" + planned.name_of(planned.handle_at(difference.body)) + "' differs in its " +
              difference.what;
    if (!where.empty())
      return {step_failed, "they part in step " + std::to_string(planned.ticks()) + ", at " +
                               support::number("%.6g s: ", static_cast<double>(planned.time())) +
                               where + "\n"};
    if (!complaint.empty()) said += complaint + "\n";
  }
  return {all_simulated, said + std::to_string(planned.ticks()) +
                             " steps by plan, and as many with nothing known of any body: every "
                             "number of every motion is the same\n"};
}

}  // namespace tumble::simulate
