#include <course/checks.hpp>
#include <course/rules.hpp>
#include <tumble/ladder.hpp>

using namespace tumble;
using namespace tumble::course;

namespace {

const TumblingProblem &A = tumbling_problems[0], &B = tumbling_problems[1],
                      &C = tumbling_problems[2], &D = tumbling_problems[3];

template <class Real>
const TurningRung<Real>& rung_called(std::string_view name) {
  const auto& ladder = turning_ladder<Real>;
  const auto found = std::find_if(ladder.begin(), ladder.end(),
                                  [&](const auto& rung) { return rung.name == name; });
  REQUIRE_MESSAGE(found != ladder.end(), "no rung is called " << std::string(name));
  return *found;
}

/// The angle from the exact orientation after `seconds` of problem A.
template <class Real>
long double angle_error(const TurningRung<Real>& rung, int seconds, int steps) {
  Top<Real> top = top_of<Real>(A);
  const auto exact = FreeTop(exactly(top)).orientation(seconds);
  for (int n = 0; n < steps; ++n) rung.turn(top, static_cast<Real>(seconds) / Real(steps));
  return angle_between(exact, exactly(top).orientation);
}

bool about(double found, double published) {
  return std::abs(found - published) <= 0.06 * published;
}

}  // namespace

//! [orders]
TEST_CASE("Halving the time step divides each rung's error by two to the power of its order") {
  for (const auto& rung : turning_ladder<long double>) {
    CAPTURE(std::string(rung.name));
    if (rung.claims.order == 0) {
      CHECK(angle_error(rung, 2, 1000) > 0.1);
      continue;
    }
    // Steps so short that the next term is small, so long that nothing is lost in roundings.
    const int steps = rung.claims.order <= 2 ? 2000 : rung.claims.order <= 6 ? 100 : 40;
    const long double ratio = angle_error(rung, 2, steps) / angle_error(rung, 2, 2 * steps);
    const double order = static_cast<double>(std::log2(ratio));
    CHECK(std::abs(order - rung.claims.order) <= 0.1);
  }
}
//! [orders]

TEST_CASE_TEMPLATE("The portions of every row sum to a whole step", Real, EVERY_PRECISION) {
  const auto check = [](const auto& row) {
    long double kicks = 0, drifts = 0;
    for (const auto kick : row.kicks) kicks += kick;
    for (const auto drift : row.drifts) drifts += drift;
    const long double bound = 36 * unit_roundoff<Real>;  // 36 portions under 1, each rounded once
    CHECK(std::abs(kicks - 1) <= bound);
    CHECK(std::abs(drifts - 1) <= bound);
    CHECK(std::equal(row.kicks.begin(), row.kicks.end(), row.kicks.rbegin()));
    CHECK(std::equal(row.drifts.begin(), row.drifts.end(), row.drifts.rbegin()));
  };
  check(portions<Verlet, Real>);
  check(portions<Suzuki, Real>);
  check(portions<Yoshida, Real>);
  check(portions<KahanLiSixth, Real>);
  check(portions<KahanLiEighth, Real>);
  check(portions<SofroniouSpaletta, Real>);
  check(portions<BlanesMoanFourth, Real>);
  check(portions<BlanesMoanSixth, Real>);
  check(portions<BlanesMoanNystrom, Real>);
}

TEST_CASE("The rungs do to the problems A to D what is published of them") {
  const auto run = [](const char* name, const TumblingProblem& problem) {
    return watched<double>(problem, rung_called<double>(name).turn);
  };
  const Motion linear = run("linearly implicit", A);
  CHECK(about(linear.energy_error, 0.21));
  CHECK(about(linear.momentum_error, 0.10));
  CHECK(about(linear.angle, 1.98));
  CHECK(about(run("linearly implicit", B).energy_ratio, 0.999));
  CHECK(about(run("linearly implicit", C).energy_ratio, 0.489));
  CHECK(about(run("linearly implicit", C).angle, 1.93));
  CHECK(about(run("linearly implicit", D).energy_error, 0.031));
  CHECK(about(run("augmented second order", A).energy_error, 1.8e-3));
  CHECK(about(run("augmented second order", C).energy_ratio, 0.857));
  MESSAGE(run("implicit midpoint", A).energy_error
          << " " << run("implicit midpoint", A).momentum_error << " "
          << run("implicit midpoint", A).angle);
  MESSAGE(run("implicit midpoint", C).energy_error
          << " " << run("implicit midpoint", C).momentum_error << " "
          << run("implicit midpoint", C).angle);
  MESSAGE(run("implicit midpoint", D).energy_error
          << " " << run("implicit midpoint", D).momentum_error << " "
          << run("implicit midpoint", D).angle);
  MESSAGE(run("Lie midpoint", A).energy_error << " " << run("Lie midpoint", A).momentum_error << " "
                                              << run("Lie midpoint", A).angle);
  MESSAGE(run("Lie midpoint", C).energy_error << " " << run("Lie midpoint", C).momentum_error << " "
                                              << run("Lie midpoint", C).angle);
  MESSAGE(run("Lie midpoint", D).energy_error << " " << run("Lie midpoint", D).momentum_error << " "
                                              << run("Lie midpoint", D).angle);
  MESSAGE(run("augmented second order", A).angle << " " << run("augmented second order", C).angle
                                                 << " "
                                                 << run("augmented second order", D).energy_error);
  MESSAGE(run("Runge-Kutta", A).energy_error << " " << run("Runge-Kutta", A).momentum_error << " "
                                             << run("Runge-Kutta", A).angle);
  MESSAGE(run("Runge-Kutta", C).energy_ratio << " " << run("Runge-Kutta", C).angle << " "
                                             << run("Runge-Kutta", D).diverged);
  for (const auto& rung : turning_ladder<double>) {
    const Motion a = watched<double>(A, rung.turn), c = watched<double>(C, rung.turn),
                 d = watched<double>(D, rung.turn);
    MESSAGE(std::string(rung.name)
            << ": A " << a.energy_error << " " << a.momentum_error << " " << a.angle << "; C "
            << c.energy_error << " " << c.momentum_error << " " << c.angle << "; D "
            << d.energy_error << " " << d.momentum_error << " " << d.angle);
  }
}
