#include <support/checks.hpp>
#include <support/locked_motions.hpp>

using namespace tumble;
using namespace tumble::support;

TEST_CASE_TEMPLATE(
    "Locked about one axis or two, each rung errs by what it does in long double, and rounds", Real,
    EVERY_PRECISION) {
  const int steps = 64;
  for (std::size_t n = 0; n < torque_ladder<Real, Motor<Real>>.size(); ++n) {
    CAPTURE(std::string(torque_ladder<Real, Motor<Real>>[n].name));
    for (const auto& locked : lockings) {
      const auto problem = motored<Real>(locked);
      const auto witness = motored<Wide>(locked);
      const Wide own =
          apart(after(witness, torque_ladder<Wide, Motor<Wide>>[n], steps), end_of(witness));
      const auto end = after(problem, torque_ladder<Real, Motor<Real>>[n], steps);
      CHECK(apart(exactly(end), end_of(problem)) <= own + rounding_of<Real>(steps));
    }
    for (const int free : {0, 1, 2}) {
      const auto problem = pendulum<Real>(free);
      const auto witness = pendulum<Wide>(free);
      const Wide own = apart(after(witness, torque_ladder<Wide, PendulumWeight<Wide>>[n], steps),
                             end_of(witness, free));
      const auto end = after(problem, torque_ladder<Real, PendulumWeight<Real>>[n], steps);
      CHECK(apart(exactly(end), end_of(problem, free)) <= own + rounding_of<Real>(steps));
    }
  }
}
