#include "plan_comparison.hpp"

#include <support/checks.hpp>
#include <tumble/scene/read_scene.hpp>

using namespace tumble;
using simulate::Comparison;

namespace {

/// A point that is drawn to the centre, at 4 m/s from such a place, and one at rest. A step lasts
/// 0.25 s.
World<double> comet(const std::string& x) {
  const std::string text = R"({"duration": 9, "step": {"per_second": 4}, "bodies": [
    {"name": "rock", "mass": 1},
    {"name": "comet", "mass": 1, "position": [)" +
                           x + R"(, 0, 0], "velocity": [-4, 0, 0]}],
    "effects": [{"kind": "point_gravity", "strength": 1e-200, "bodies": ["comet"]}]})";
  return read_scene_text<double, OneByOne<double>>(text, "comet.json", {},
                                                   turning_method_words<FirstTurningRules>())
      .world;
}

}  // namespace

TEST_CASE("Two worlds of which one isn't what its plan makes of it part, and where is told") {
  World<double> planned = comet("3"), exhaustive = comet("4");
  const Comparison other_place = simulate::compared(planned, exhaustive, 2);
  CHECK(other_place.code == simulate::step_failed);
  CHECK(other_place.said == "they part in step 1, at 0.25 s: 'comet' differs in its position\n");
  planned = comet("1"), exhaustive = comet("3");
  planned.step(), exhaustive.step();
  const Comparison other_end = simulate::compared(planned, exhaustive, 2);
  CHECK(other_end.code == simulate::step_failed);
  CHECK(other_end.said.starts_with(
      "they part in step 1, at 0.25 s: by plan it ends with \"'comet' at"));
  CHECK(other_end.said.ends_with("\", and without with \"\"\n"));
}
