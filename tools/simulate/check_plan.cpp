#include "check_plan.hpp"

#include <cstdio>
#include <support/complaint_of_step.hpp>
#include <support/exhaustive.hpp>
#include <support/scene_rules.hpp>
#include <tumble/scene/read_scene_file.hpp>

#include "steps_until.hpp"

namespace tumble::simulate {
namespace {

template <class Real>
ExitCode check(const Options& options) {
  Scene<Real> scene =
      read_scene_file<Real, OneByOne<Real>, support::SceneRules>(options.scene, options.changes);
  const std::int64_t steps = steps_until(scene, options.until);
  World<Real>& planned = scene.world;
  planned.on_warning([](const std::string&) {});
  support::settle(planned);
  World<Real> exhaustive = planned;
  std::printf("%s", table_of(planned.plan()).c_str());
  const auto parted = [&](const std::string& where) {
    std::printf("they part in step %lld, at %.6g s: %s\n", static_cast<long long>(planned.ticks()),
                static_cast<double>(planned.time()), where.c_str());
    return step_failed;
  };
  for (std::int64_t step = 1; step <= steps; ++step) {
    const std::string complaint = support::complaint_of_step([&] { planned.step(); });
    const std::string other = support::complaint_of_step([&] { exhaustive.step_exhaustively(); });
    if (other != complaint)
      return parted("by plan it ends with \"" + complaint + "\", and without with \"" + other +
                    "\"");
    const auto difference = support::first_difference(planned.bodies(), exhaustive.bodies());
    if (!difference.what.empty())
      return parted("'" + planned.name_of(planned.handle_at(difference.body)) +
                    "' differs in its " + difference.what);
    if (!complaint.empty()) {
      std::printf("%s\n", complaint.c_str());
      break;
    }
  }
  std::printf(
      "%lld steps by plan, and as many with nothing known of any body: every number of every "
      "motion is the same\n",
      static_cast<long long>(planned.ticks()));
  return all_simulated;
}

}  // namespace

ExitCode check_plan(const Options& options) {
  return options.is_float ? check<float>(options) : check<double>(options);
}

}  // namespace tumble::simulate
