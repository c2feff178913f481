#include <course/checks.hpp>
#include <course/rules.hpp>
#include <tumble/ladder.hpp>

using namespace tumble;
using namespace tumble::course;

namespace {

const TumblingProblem &A = tumbling_problems[0], &B = tumbling_problems[1],
                      &C = tumbling_problems[2], &D = tumbling_problems[3];

/// The angle from the exact orientation after 2 s of problem A.
template <class Real>
long double angle_error(const TurningRung<Real>& rung, int steps) {
  Top<Real> top = top_of<Real>(A);
  const auto exact = FreeTop(exactly(top)).orientation(2);
  for (int n = 0; n < steps; ++n) rung.turn(top, Real(2) / Real(steps));
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
    const int order = rung.claims.order;
    if (order == 0) {
      CHECK(angle_error(rung, 1000) > 0.1);
      continue;
    }
    // Steps so short that the next term of the error is small, so long that no digits are lost.
    const int steps = order <= 2 ? 2000 : order <= 5 ? 160 : order == 6 ? 40 : order == 8 ? 20 : 10;
    const long double ratio = angle_error(rung, steps) / angle_error(rung, 2 * steps);
    // The next term is smaller by one power of the step or, for the symmetric rungs, by two.
    CHECK(std::abs(static_cast<double>(std::log2(ratio)) - order) <= 0.1);
  }
}
//! [orders]

TEST_CASE_TEMPLATE("The portions of every row sum to a whole step and read the same backwards",
                   Real, EVERY_PRECISION) {
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

TEST_CASE("A tableau's weights sum to 1, and the looks of each row to its node") {
  const auto check = [](const auto& rule) {
    long double sum = 0;
    for (const long double weight : rule.weights) sum += weight;
    CHECK(std::abs(sum - 1) <= 1e-17L);  // what 18 digits of a dozen weights under 6 leave
    for (std::size_t look = 0; look < rule.nodes.size(); ++look) {
      long double node = 0;
      for (const long double weight : rule.looks[look]) node += weight;
      CHECK(std::abs(node - rule.nodes[look]) <= 1e-16L);  // here they go up to 43
    }
  };
  check(Kutta::rule);
  check(DormandPrinceFifth::rule);
  check(DormandPrinceEighth::rule);
}

//! [published]
TEST_CASE("The rungs do to the problems A to D what is published of them") {
  const auto run = [](const char* name, const TumblingProblem& problem) {
    return watched<double>(problem, turning_rung<double>(name).turn);
  };
  const Motion linear = run("linearly implicit", A);
  CHECK(about(linear.energy_error, 0.21));
  CHECK(about(linear.momentum_error, 0.10));
  CHECK(about(linear.angle, 1.98));
  CHECK(std::abs(run("linearly implicit", B).energy_ratio - 0.999) <= 0.0005);
  CHECK(std::abs(run("linearly implicit", C).energy_ratio - 0.489) <= 0.0005);
  CHECK(about(run("linearly implicit", D).energy_error, 0.031));
  CHECK(about(run("augmented second order", A).energy_error, 1.8e-3));
  CHECK(about(run("augmented second order", A).angle, 4e-4));
  CHECK(std::abs(run("augmented second order", C).energy_ratio - 0.857) <= 0.0005);
  CHECK(about(run("augmented second order", C).angle, 0.027));
  const Motion classical = run("Runge-Kutta", A);
  CHECK(about(classical.energy_error, 2e-8));
  CHECK(about(classical.momentum_error, 1.9e-8));
  CHECK(about(classical.angle, 4.4e-8));
  CHECK(std::abs(run("Runge-Kutta", C).energy_ratio - 0.965) <= 0.0005);
  CHECK(about(run("Runge-Kutta", C).angle, 0.35));
  CHECK(run("Runge-Kutta", D).diverged > 0);
}
//! [published]

//! [claims]
TEST_CASE_TEMPLATE("Each rung keeps what it claims to keep, and loses what it does not", Real,
                   EVERY_PRECISION) {
  const Real step = Real(1) / 4;
  const int steps = 40;
  // Forty roundings a step at most, of which a random walk leaves few; and a loss is worth showing
  // from ten times as much on.
  const double rounding = 40 * steps * unit_roundoff<Real>;
  for (const TurningRung<Real>& rung : turning_ladder<Real>) {
    CAPTURE(std::string(rung.name));
    const Top<Real> start = top_of<Real>(A);
    const Motion motion = watched(start, rung.turn, steps, 0, step);
    if (rung.claims.energy) CHECK(motion.energy_error <= rounding);
    if (rung.claims.momentum) CHECK(motion.momentum_error <= rounding);
    // In float the highest orders lose nothing that can be seen.
    if (rung.claims.order > 2) continue;
    if (!rung.claims.energy) CHECK(motion.energy_error > 10 * rounding);
    if (!rung.claims.momentum)
      CHECK((motion.momentum_error > 10 * rounding || motion.diverged > 0));
  }
}
//! [claims]

//! [reverses]
TEST_CASE_TEMPLATE("The rungs that claim it retrace their steps, and the others lose their way",
                   Real, EVERY_PRECISION) {
  const Real step = Real(1) / 4;
  const int steps = 20;
  for (const TurningRung<Real>& rung : turning_ladder<Real>) {
    CAPTURE(std::string(rung.name));
    const Top<Real> start = top_of<Real>(A);
    Top<Real> top = start;
    for (int n = 0; n < steps; ++n) rung.turn(top, step);
    top.angular_momentum_body = -top.angular_momentum_body;
    for (int n = 0; n < steps; ++n) rung.turn(top, step);
    const Real off = angle_between(top.orientation, start.orientation);
    // 40 steps of 40 roundings each, which the motion itself spreads by a few times over 10 s.
    const Real rounding = 10 * 40 * 40 * unit_roundoff<Real>;
    if (rung.claims.reverses)
      CHECK(off <= rounding);
    else if (rung.claims.order <= (std::is_same_v<Real, float> ? 2 : 4))
      CHECK((off > 10 * rounding || !(off == off)));
  }
}
//! [reverses]

TEST_CASE_TEMPLATE("The rungs that claim it stay finite at a hundred radians a step", Real,
                   EVERY_PRECISION) {
  for (const TumblingProblem* problem : {&A, &C})
    for (const TurningRung<Real>& rung : turning_ladder<Real>) {
      if (!rung.claims.bounded) continue;
      CAPTURE(std::string(rung.name));
      Top<Real> top = top_of<Real>(*problem);
      // No more than the most that the energy allows, which is reached about the largest moment.
      const Real most = std::sqrt(2 * kinetic_energy(top) / top.inverse_moments.minCoeff());
      const Real step = 100 / angular_velocity_body(top).norm();
      for (int n = 0; n < 1000; ++n) rung.turn(top, step);
      CHECK(top.angular_momentum_body.norm() <= most * (1 + 1000 * 40 * unit_roundoff<Real>));
      CHECK(std::abs(norm(top.orientation) - 1) <= 10 * unit_roundoff<Real>);
    }
}

//! [symmetric]
TEST_CASE_TEMPLATE("A symmetric top is turned exactly by every row, however long the step", Real,
                   EVERY_PRECISION) {
  Top<Real> start{.inverse_moments = {1, 1, Real(0.25)}};
  start.angular_momentum_body = {Real(0.5), -1, 2};
  for (const TurningRung<Real>& rung : turning_ladder<Real>) {
    if (rung.name.find("splitting") != 0 || rung.name == "splitting by axes") continue;
    CAPTURE(std::string(rung.name));
    Top<Real> top = start;
    rung.turn(top, 3);
    const auto exact = FreeTop(exactly(start));
    // 110 turns and a long one, of three roundings each, at angles of up to 7 rad.
    const long double bound = 3 * 111 * 7 * unit_roundoff<Real>;
    CHECK(angle_between(exact.orientation(3), exactly(top).orientation) <= bound);
    CHECK((exactly(top).angular_momentum_body - exact.angular_momentum_body(3)).norm() <=
          bound * start.angular_momentum_body.norm());
  }
}
//! [symmetric]

TEST_CASE_TEMPLATE("Taken in the portions of Verlet, the splitting is chapter 8's, to the bit",
                   Real, EVERY_PRECISION) {
  Top<Real> by_row = top_of<Real>(A), by_rule = by_row;
  for (int n = 0; n < 100; ++n) {
    turn_by_row<Verlet>(by_row, Real(1) / 60);
    turn_by_splitting(by_rule, Real(1) / 60);
    REQUIRE(same_bits(by_row.angular_momentum_body, by_rule.angular_momentum_body));
    REQUIRE(same_bits(by_row.orientation.imaginary, by_rule.orientation.imaginary));
  }
}

//! [brakes]
TEST_CASE_TEMPLATE("The linearly implicit rule loses half of d I d with every change d of omega",
                   Real, EVERY_PRECISION) {
  Top<Real> top = top_of<Real>(A);
  for (int n = 0; n < 100; ++n) {
    const Vec3<Real> before = angular_velocity_body(top);
    const Real energy = kinetic_energy(top);
    turn_linearly_implicitly(top, Real(1) / 8);
    const Vec3<Real> change = angular_velocity_body(top) - before;
    const Real lost = change.cwiseProduct(change).dot(moments_of(top)) / 2;
    CHECK(lost > 0);
    CHECK(std::abs(energy - lost - kinetic_energy(top)) <= 60 * unit_roundoff<Real> * energy);
  }
}
//! [brakes]

TEST_CASE_TEMPLATE("The midpoint rules solve the equations that define them", Real,
                   EVERY_PRECISION) {
  for (const TumblingProblem* problem : {&A, &B, &C}) {
    const Top<Real> start = top_of<Real>(*problem);
    const Real step = Real(1) / 60;
    const Real size = start.angular_momentum_body.norm();
    const Real bound = 60 * unit_roundoff<Real> * size;
    Top<Real> top = start;
    turn_by_implicit_midpoint(top, step);
    const Vec3<Real> sum = start.angular_momentum_body + top.angular_momentum_body;
    const Vec3<Real> M = sum / 2, w = start.inverse_moments.cwiseProduct(M);
    const Vec3<Real> change = top.angular_momentum_body - start.angular_momentum_body;
    CHECK(distance(change, step * M.cross(w)) <= bound);

    top = start;
    turn_by_lie_midpoint(top, step);
    // Half of the turn that was made, seen from the start, leads to the M that makes it.
    const Vec3<Real> turn = rotation_vector_of(conjugate(start.orientation) * top.orientation);
    const Quaternion<Real> half = quaternion_of_rotation_vector<Real>(turn / 2);
    const Vec3<Real> middle = rotate_back(half, start.angular_momentum_body);
    const Vec3<Real> made = step * start.inverse_moments.cwiseProduct(middle);
    CHECK(distance(turn, made) <= 60 * unit_roundoff<Real> * std::max(Real(1), turn.norm()));
  }
}

TEST_CASE("The rate of a turn is right up to the fourth power of the turn") {
  // The turn by v, then by h w, is the turn by v + h v' and no other.
  const Vec3<long double> axis = {0.3L, -0.5L, 0.7L}, w = {0.4L, 0.9L, -0.2L};
  const auto error = [&](long double scale) {
    const long double h = 1e-6L;
    const Vec3<long double> v = scale * axis, after = h * w, before = -h * w;
    const auto turned = [&](const Vec3<long double>& by) -> Vec3<long double> {
      return rotation_vector_of(quaternion_of_rotation_vector(v) *
                                quaternion_of_rotation_vector(by));
    };
    const Vec3<long double> rate = (turned(after) - turned(before)) / (2 * h);
    return (rate - rate_of_turn<long double>(v, w)).norm();
  };
  const long double ratio = error(0.5L) / error(0.25L);
  CHECK(ratio > 15.5L);
  CHECK(ratio < 16.5L);
}

TEST_CASE_TEMPLATE("A top at rest stays at rest on every rung, and a step of no time does nothing",
                   Real, EVERY_PRECISION) {
  for (const TurningRung<Real>& rung : turning_ladder<Real>) {
    CAPTURE(std::string(rung.name));
    Top<Real> top{.inverse_moments = Vec3<Real>(1, Real(0.5), 3)};
    rung.turn(top, Real(1) / 60);
    CHECK(top.orientation.real == 1);
    CHECK(same_bits(top.angular_momentum_body, Vec3<Real>::Zero()));
    const Top<Real> before = top_of<Real>(A);
    top = before;
    rung.turn(top, Real(0));
    CHECK(distance(top.angular_momentum_body, before.angular_momentum_body) <=
          4 * unit_roundoff<Real> * 4);
    CHECK(angle_between(top.orientation, before.orientation) <= 4 * unit_roundoff<Real>);
  }
}

TEST_CASE("A rung that does not exist is refused, and those that do are named") {
  CHECK(turning_rung<double>("Lie midpoint").name == "Lie midpoint");
  const std::string complaint = complaint_of([] { turning_rung<double>("leapfrog"); });
  CHECK(complaint.find("no rung is called 'leapfrog'; they are: steady; explicit; ") == 0);
  CHECK(complaint.find("; splitting, Sofroniou-Spaletta") != std::string::npos);
}
