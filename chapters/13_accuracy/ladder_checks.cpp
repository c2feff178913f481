#include <support/checks.hpp>
#include <support/rules.hpp>
#include <tumble/ladder.hpp>
#include <vector>

using namespace tumble;
using namespace tumble::support;

namespace {

const TumblingProblem &A = tumbling_problems[0], &B = tumbling_problems[1],
                      &C = tumbling_problems[2], &D = tumbling_problems[3];

/// The angle from the exact orientation after 2 s of problem A.
template <class Real>
long double angle_error(const TurningRung<Real>& rung, int steps) {
  Top<Real> top = top_of<Real>(A);
  const auto exact = exact::FreeTop<long double>(exactly(top)).at(2).orientation;
  for (int n = 0; n < steps; ++n) rung.turn(top, Real(2) / Real(steps));
  return angle_between(exact, exactly(top).orientation);
}

}  // namespace

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

TEST_CASE("Every row of fourth order and above steps backwards, in its kicks and in its drifts") {
  const auto backwards = [](const auto& portions) {
    return *std::min_element(portions.begin(), portions.end()) < 0;
  };
  const auto check = [&](const auto& row) {
    CHECK(backwards(row.kicks));
    CHECK(backwards(row.drifts));
  };
  CHECK_FALSE(backwards(Verlet::row.kicks));
  check(Suzuki::row);
  check(Yoshida::row);
  check(KahanLiSixth::row);
  check(KahanLiEighth::row);
  check(SofroniouSpaletta::row);
  check(BlanesMoanFourth::row);
  check(BlanesMoanSixth::row);
  check(BlanesMoanNystrom::row);
}

TEST_CASE("A tableau's weights sum to 1, and the coefficients of each row to its node") {
  const auto check = [](const auto& rule) {
    long double sum = 0;
    for (const long double weight : rule.weights) sum += weight;
    CHECK(std::abs(sum - 1) <= 1e-17L);  // what 18 digits of a dozen weights under 6 leave
    for (std::size_t stage = 0; stage < rule.nodes.size(); ++stage) {
      long double node = 0;
      for (const long double weight : rule.coefficients[stage]) node += weight;
      CHECK(std::abs(node - rule.nodes[stage]) <= 1e-16L);  // here they go up to 43
    }
  };
  check(Kutta::rule);
  check(DormandPrinceFifth::rule);
  check(DormandPrinceEighth::rule);
  check(FehlbergEighth::rule);
}

TEST_CASE(
    "At a radian a step the linearly implicit, the augmented and Runge and Kutta's rule get the "
    "energy wrong, and the splitting does not") {
  const auto run = [](const char* name, const TumblingProblem& problem) {
    return watched<double>(problem, turning_rung<double>(name).turn);
  };
  // The rod turns by a radian a step.
  for (const char* name : {"linearly implicit", "augmented second order", "Runge-Kutta"})
    CHECK(run(name, C).energy_error > 0.03);
  CHECK(run("splitting", C).energy_error < 1e-4);
  // On the ordinary body, at 0.04 rad, the order tells.
  CHECK(run("linearly implicit", A).energy_error > 0.1);
  CHECK(run("augmented second order", A).energy_error < 1e-2);
  CHECK(run("Runge-Kutta", A).energy_error < 1e-6);
  // The linearly implicit rule brakes, wherever it is put; the needle throws out those that
  // evaluate rates.
  for (const TumblingProblem* problem : {&A, &B, &C, &D})
    CHECK(run("linearly implicit", *problem).energy_ratio < 1);
  CHECK(run("Runge-Kutta", D).diverged > 0);
}

TEST_CASE("All that the augmented rule leaves out in third order is how the rate's rate changes") {
  // Of the true rotation vector, h ω + ½h² ω̇ + h³/12 ω̇ × ω + h³/6 ω̈ + O(h⁴), it has all but the
  // last. Seen from the body ω̈ is I⁻¹(N × ω + L × ω̇) with N = L × ω; in the world ω × ω̇ comes
  // on top. The term of h⁴ falls out between two steps, and that of h⁵ is h² times as large, up to
  // the size of the rates.
  const Top<long double> start = top_of<long double>(A);
  const Vec3<long double> w = angular_velocity_body(start), L = start.angular_momentum_body;
  const auto divided = [&](const Vec3<long double>& v) {
    return Vec3<long double>(start.inverse_moments.cwiseProduct(v));
  };
  const Vec3<long double> N = L.cross(w), rate = divided(N);
  const Vec3<long double> second = divided(N.cross(w) + L.cross(rate)) + w.cross(rate);
  const auto vector_to = [&](const Quaternion<long double>& q) {
    return Vec3<long double>(rotation_vector_of<long double>(conjugate(start.orientation) * q));
  };
  const auto left_out = [&](long double h) {
    Top<long double> top = start;
    turn_by_augmented_rule(top, h);
    return Vec3<long double>((vector_to(exact::FreeTop<long double>(start).at(h).orientation) -
                              vector_to(top.orientation)) /
                             (h * h * h));
  };
  const long double h = 1e-3L;
  CHECK(distance<long double>(2 * left_out(h / 2) - left_out(h), second / 6) <=
        100 * h * h * second.norm());
}

TEST_CASE_TEMPLATE(
    "Each rung keeps what it claims to keep, and up to second order loses what it does not", Real,
    EVERY_PRECISION) {
  const Real step = Real(1) / 4;
  const int steps = 40;
  // Forty roundings a step at most, of which a random walk leaves few; and a loss is worth showing
  // from ten times as much on.
  const double rounding = 40 * steps * unit_roundoff<Real>;
  for (const TurningRung<Real>& rung : turning_ladder<Real>) {
    CAPTURE(std::string(rung.name));
    const Top<Real> start = top_of<Real>(A);
    const support::Motion motion = watched(start, rung.turn, steps, 0, step);
    if (rung.claims.energy) CHECK(motion.energy_error <= rounding);
    if (rung.claims.momentum) CHECK(motion.momentum_error <= rounding);
    // In float the highest orders lose nothing that can be seen.
    if (rung.claims.order > 2) continue;
    if (!rung.claims.energy) CHECK(motion.energy_error > 10 * rounding);
    if (!rung.claims.momentum)
      CHECK((motion.momentum_error > 10 * rounding || motion.diverged > 0));
  }
}

TEST_CASE(
    "In long double every rung loses what it does not claim to keep, of the highest order too") {
  // Forty roundings a step, and a loss ten times as large; and L turned around, for 20 steps.
  const long double step = 1.0L / 4, rounding = 40 * 40 * unit_roundoff<long double>;
  for (const TurningRung<long double>& rung : turning_ladder<long double>) {
    CAPTURE(std::string(rung.name));
    const Top<long double> start = top_of<long double>(A);
    const support::Motion motion = watched(start, rung.turn, 40, 0, step);
    // What is seen of the energy is a ratio in double.
    const double seen = std::max(double(rounding), 2 * unit_roundoff<double>);
    if (!rung.claims.energy) CHECK((motion.energy_error > 10 * seen || motion.diverged > 0));
    if (!rung.claims.momentum) CHECK((motion.momentum_error > 10 * seen || motion.diverged > 0));
    if (rung.claims.reverses) continue;
    Top<long double> top = start;
    for (int n = 0; n < 20; ++n) rung.turn(top, step);
    top.angular_momentum_body *= -1;
    for (int n = 0; n < 20; ++n) rung.turn(top, step);
    const long double off = angle_between(top.orientation, start.orientation);
    CHECK((off > 100 * rounding || !(off == off)));
  }
}

TEST_CASE("On a spring Verlet's velocity is wrong by an even power of the step too") {
  // x'' = −x from x = 1, v = 0: −h + h³/4 where −sin h is −h + h³/6 − …, so odd; from x = 0, v = 1
  // it is 1 − h²/2 where cos h goes on with h⁴/24.
  const auto velocity_error = [](long double h, long double x, long double v) {
    Particle<long double> particle = make_particle<long double>(1, {x, 0, 0}, {v, 0, 0});
    const auto spring = [](Particle<long double>& p, long double) { p.force = -p.position; };
    spring(particle, 0);
    step_by_row<Verlet>(particle, spring, 0.0L, h);
    return particle.velocity.x() - (v * std::cos(h) - x * std::sin(h));
  };
  const long double h = 1e-3L;
  CHECK(std::abs(velocity_error(h, 1, 0) / (h * h * h / 12) - 1) < 1e-5L);
  CHECK(std::abs(velocity_error(h, 0, 1) / (-h * h * h * h / 24) - 1) < 1e-5L);
}

TEST_CASE_TEMPLATE(
    "The rungs that claim it retrace their steps, and others of low order lose their way", Real,
    EVERY_PRECISION) {
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

TEST_CASE_TEMPLATE(
    "A symmetric top is turned by every row as exactly as rounding lets it, in long steps too",
    Real, EVERY_PRECISION) {
  Top<Real> start{.inverse_moments = {1, 1, Real(0.25)}};
  start.angular_momentum_body = {Real(0.5), -1, 2};
  for (const TurningRung<Real>& rung : turning_ladder<Real>) {
    if (rung.name.find("splitting") != 0 || rung.name == "splitting by axes") continue;
    CAPTURE(std::string(rung.name));
    const exact::FreeTop<long double> exact(exactly(start));
    for (const int step : {1, 3, 100}) {
      CAPTURE(step);
      const auto there = exact.at(step);
      Top<Real> top = start;
      rung.turn(top, Real(step));
      // The longest row's turns and the sphere's, of three roundings each, at angles of up to 7 rad
      // in 3 s.
      const auto turns = SofroniouSpaletta::row.kicks.size() + SofroniouSpaletta::row.drifts.size();
      const long double bound = 3 * Real(turns + 1) * Real(step) * 7 / 3 * unit_roundoff<Real>;
      CHECK(angle_between(there.orientation, exactly(top).orientation) <= bound);
      CHECK((exactly(top).angular_momentum_body - there.angular_momentum_body).norm() <=
            bound * start.angular_momentum_body.norm());
    }
  }
}

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

TEST_CASE_TEMPLATE("The midpoint rules solve the equations that define them", Real,
                   EVERY_PRECISION) {
  // Two radians a step take Newton's method more than three rounds from the old L.
  const Real long_step = 2 / angular_velocity_body(top_of<Real>(A)).norm();
  for (const auto& [problem, step] : {std::pair(&A, Real(1) / 60), std::pair(&B, Real(1) / 60),
                                      std::pair(&C, Real(1) / 60), std::pair(&A, long_step)}) {
    const Top<Real> start = top_of<Real>(*problem);
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

TEST_CASE_TEMPLATE(
    "A top at rest stays at rest on every rung, and a step of no time moves none but by rounding",
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

TEST_CASE_TEMPLATE("The rules of Runge and Kutta leave the quaternion unit", Real,
                   EVERY_PRECISION) {
  for (const char* name : {"Runge-Kutta", "Dormand-Prince 5", "Dormand-Prince 8"}) {
    CAPTURE(std::string(name));
    Top<Real> top = top_of<Real>(A);
    // Long steps, in which the quaternion leaves its sphere by far more than rounding.
    for (int n = 0; n < 20; ++n) {
      turning_rung<Real>(name).turn(top, Real(1) / 4);
      CHECK(std::abs(norm(top.orientation) - 1) <= 10 * unit_roundoff<Real>);
    }
  }
}

TEST_CASE(
    "The rows of fourth order and above meet the conditions of fourth order to all their digits") {
  // A kick and a drift that don't commute leave two errors of third order, [A, [A, B]] and
  // [B, [A, B]]. They vanish if Σ bᵢ cᵢ² = 1/3 and Σ_{i<j} bᵢ bⱼ (cⱼ − cᵢ) = 1/6, where kick i has
  // the portion bᵢ and cᵢ of the step's drifts lie before it: the motions under a force t² and
  // under the force −x, to h³. Rows that read the same backwards have no errors of fourth order.
  const auto unmet = [](const auto& row) {
    long double squares = 0, pairs = 0, before = 0;
    std::vector<std::pair<long double, long double>> kicks;
    for (std::size_t i = 0; i < row.kicks.size(); ++i) {
      const long double b = row.kicks[i];
      squares += b * before * before;
      for (const auto& [earlier, place] : kicks) pairs += earlier * b * (before - place);
      kicks.emplace_back(b, before);
      if (i < row.drifts.size()) before += row.drifts[i];
    }
    return std::max(std::abs(squares - 1.0L / 3), std::abs(pairs - 1.0L / 6));
  };
  CHECK(unmet(Verlet::row) > 0.01L);
  CHECK(unmet(Suzuki::row) <= 1e-18L);             // written to 20 digits
  CHECK(unmet(Yoshida::row) <= 1e-18L);            // to 30
  CHECK(unmet(KahanLiSixth::row) <= 1e-18L);       // to 26
  CHECK(unmet(KahanLiEighth::row) <= 1e-18L);      // to 26
  CHECK(unmet(SofroniouSpaletta::row) <= 1e-18L);  // to 26
  CHECK(unmet(BlanesMoanFourth::row) <= 1e-14L);   // to 15
  CHECK(unmet(BlanesMoanSixth::row) <= 1e-14L);
  CHECK(unmet(BlanesMoanNystrom::row) <= 1e-14L);
}

TEST_CASE(
    "The rules that keep the length of L and turn by no more than the spin says claim that a top "
    "stays finite, and four that add to L do not") {
  // Steady: L is not touched. |L| restored: it is scaled back. Both turn by |L|/I at most.
  for (const char* name : {"steady", "explicit, |L| restored", "momentum-carrying"})
    CHECK(turning_rung<double>(name).claims.bounded);
  // So does whatever turns L about one axis after another.
  for (const TurningRung<double>& rung : turning_ladder<double>)
    if (rung.name.find("splitting") == 0) CHECK(rung.claims.bounded);
  // Nothing bounds what adds to L.
  for (const char* name : {"explicit", "Runge-Kutta", "Dormand-Prince 5", "Dormand-Prince 8"})
    CHECK(!turning_rung<double>(name).claims.bounded);
}
