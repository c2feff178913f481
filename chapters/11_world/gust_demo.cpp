// A predicate that leaves out the wrong body, and which of the two judges sees it.
#include <support/record.hpp>
#include <tumble/world.hpp>

using namespace tumble;

namespace {

//! [gust]
/// Air that moves at 3 m/s and takes along what it meets. Its predicate was copied from a drag.
struct Gust {
  static constexpr std::string_view name = "gust";
  std::string_view skip_reason(const BodyFlags& flags) const {
    return flags.moves ? "" : "at rest, where no air resists";
  }
  Vec3d force(const Particled& centre, double /*time*/) const {
    return 0.02 * (Vec3d(3, 0, 0) - centre.velocity);  // N
  }
};
//! [gust]

}  // namespace

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  //! [three_runs]
  World<double> by_plan(steps_per_second(60));
  const BodyHandle leaf = by_plan.add("leaf", make_particle<double>(0.01));  // kg
  by_plan.add(Gust{});
  World<double> by_reference = by_plan, exhaustively = by_plan;
  for (int n = 0; n < 60; ++n) {
    by_plan.step();
    by_reference.step_by_reference();
    exhaustively.step_exhaustively();
  }
  //! [three_runs]
  const auto tell = [&](const char* run, const World<double>& world) {
    std::printf("%-14s the leaf is at %.3g m\n", run, world.position(leaf).x());
  };
  tell("by plan:", by_plan);
  tell("by reference:", by_reference);
  tell("exhaustively:", exhaustively);
  support::expect(by_reference.position(leaf).x() == by_plan.position(leaf).x(),
                  "the reference run trusts the predicate");
  support::expect(exhaustively.position(leaf).x() > 1, "the exhaustive run does not");
}
