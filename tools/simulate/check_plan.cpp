#include "check_plan.hpp"

#include <cstdio>
#include <support/scene_rules.hpp>
#include <tumble/scene/read_scene_file.hpp>

#include "plan_comparison.hpp"
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
  const Comparison comparison = compared(planned, exhaustive, steps);
  std::printf("%s", comparison.said.c_str());
  return comparison.code;
}

}  // namespace

ExitCode check_plan(const Options& options) {
  return options.is_float ? check<float>(options) : check<double>(options);
}

}  // namespace tumble::simulate
