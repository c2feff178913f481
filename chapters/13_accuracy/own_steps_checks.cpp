#include <support/checks.hpp>
#include <support/exact_motion.hpp>
#include <support/own_steps.hpp>
#include <support/rules.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

using Wide = long double;

template <class Real>
Wide angle_error(const Top<Real>& top, const Top<Wide>& truth) {
  return angle_between(truth.orientation, exactly(top).orientation);
}

/// The error after ever smaller tolerances, each a hundredth of the one before, until roundings are
/// in sight: at each, the run must have lost no more than `amplified` times the tolerance allows.
template <class Real, class Error>
void check_tolerances(double seconds, double amplified, double rounding, const Error& error) {
  for (double tolerance = 1e-2; tolerance * seconds * amplified > rounding; tolerance /= 100) {
    CAPTURE(tolerance);
    CHECK(error(static_cast<Real>(tolerance)) <= amplified * tolerance * seconds);
  }
}

}  // namespace

TEST_CASE_TEMPLATE("A free top loses no more in a second than the tolerance, times what it spreads",
                   Real, EVERY_PRECISION) {
  for (const auto& problem : free_problems<Real>()) {
    CAPTURE(problem.name);
    const auto truth = truth_of(problem);
    // An error of l grows with the time, by as much as the spin differs between neighbours: |L|
    // times the largest difference of inverse moments, for as long as the run lasts. And near the
    // middle axis errors grow as the motion leaves it: the T-handle's by 100 from its start.
    const Vec3<Real>& i = problem.start.inverse_moments;
    const double spread =
        double(problem.start.angular_momentum_body.norm() * (i.maxCoeff() - i.minCoeff())) *
        problem.seconds * (problem.name == "T-handle" ? 100 : 1);
    const double rounding = 100 * (1 + spread) * (1 + problem.seconds) * unit_roundoff<Real>;
    const auto by = [&]<class Pair>(Pair) {
      check_tolerances<Real>(problem.seconds, 1 + spread, 100 * rounding, [&](Real tolerance) {
        Top<Real> top = problem.start;
        integrate_free_top<Pair>(top, Real(problem.seconds), tolerance);
        return double(angle_error(top, truth));
      });
    };
    by(DormandPrince54());
    by(DormandPrince853());
  }
}

TEST_CASE_TEMPLATE(
    "A free top that chooses its steps turns alike, to the bit, in units up to three quarters of "
    "the "
    "range of exponents away",
    Real, EVERY_PRECISION) {
  const auto problem = free_problems<Real>()[0];
  for (const int k : {-3 * std::numeric_limits<Real>::max_exponent / 4,
                      3 * std::numeric_limits<Real>::max_exponent / 4}) {
    const Real scale = std::ldexp(Real(1), k);
    Top<Real> mine = problem.start, other = problem.start;
    other.angular_momentum_body *= scale;
    other.inverse_moments /= scale;
    const StepCounts a = integrate_free_top<DormandPrince54>(mine, 10, Real(1e-3)),
                     b = integrate_free_top<DormandPrince54>(other, 10, Real(1e-3));
    CHECK(a.steps > 5);
    CHECK(a.steps == b.steps);
    CHECK(mine.orientation.real == other.orientation.real);
    CHECK(same_bits(mine.orientation.imaginary, other.orientation.imaginary));
    CHECK(same_bits(mine.angular_momentum_body, other.angular_momentum_body / scale));
  }
}

TEST_CASE("With a tolerance a hundred times smaller a pair needs as many more steps as it says") {
  // Steps are as long as tolerance^(1/power), for errors per second that fall as h^power.
  const auto problem = free_problems<double>()[0];
  const auto steps = [&]<class Pair>(Pair, double tolerance) {
    Topd top = problem.start;
    return double(integrate_free_top<Pair>(top, problem.seconds, tolerance).steps);
  };
  const double fifth = steps(DormandPrince54(), 1e-9) / steps(DormandPrince54(), 1e-7),
               eighth = steps(DormandPrince853(), 1e-11) / steps(DormandPrince853(), 1e-9);
  CHECK(std::abs(std::log(fifth) / std::log(100) - 1 / 4.0) < 0.02);
  CHECK(std::abs(std::log(eighth) / std::log(100) - 1 / 7.0) < 0.02);
}

TEST_CASE_TEMPLATE("With L apart a free top keeps it in the world, whatever the tolerance", Real,
                   EVERY_PRECISION) {
  for (const auto& problem : free_problems<Real>())
    for (const Real tolerance : {Real(1e4), Real(10), Real(0.1), Real(1e-3)}) {
      CAPTURE(problem.name);
      CAPTURE(tolerance);
      Top<Real> top = problem.start;
      integrate_free_top<DormandPrince54>(top, Real(problem.seconds), tolerance);
      const Vec3<Wide> L = angular_momentum_world(exactly(problem.start)),
                       there = angular_momentum_world(exactly(top));
      // The three turns of top_at(), 20 roundings each, there and at the start.
      CHECK((there - L).norm() <= 2 * 60 * unit_roundoff<Real> * L.norm());
    }
}

TEST_CASE_TEMPLATE("A step of a free top by its few unknowns is one of the Runge-Kutta rule", Real,
                   EVERY_PRECISION) {
  // l by the rule on three numbers is L by the rule on seven, since no stage asks for the others.
  Top<Real> apart = top_of<Real>(tumbling_problems[0]), whole = apart;
  turn_by_momentum<DormandPrinceFifth>(apart, Real(1) / 8);
  turn_by_runge_kutta<DormandPrinceFifth>(whole, Real(1) / 8);
  const Vec3<Real> direction = whole.angular_momentum_body.normalized(),
                   mine = apart.angular_momentum_body.normalized();
  CHECK(distance(mine, direction) <= 40 * unit_roundoff<Real>);
}

TEST_CASE("With L apart a step of constant length has the order of its rule") {
  const auto order = [&]<class Rule>(Rule, int steps) {
    const auto error = [&](int count) {
      Top<Wide> top = top_of<Wide>(tumbling_problems[0]);
      const auto truth = exactly_after(NoTorque<Wide>(), top, Wide(2));
      for (int n = 0; n < count; ++n) turn_by_momentum<Rule>(top, 2.0L / count);
      return angle_error(top, truth);
    };
    return std::log2(error(steps) / error(2 * steps));
  };
  // The next term of the error is smaller by h times the rate of the motion, of which the fastest
  // spin that the energy allows is the bound: sqrt(2E/I) with 2E = 9.75 J and I = 1 kg m². Halving
  // h changes the ratio by half of that.
  const auto next = [](int steps) { return std::sqrt(9.75L) * 2 / steps / 2 / std::log(2.0L); };
  CHECK(std::abs(order(Kutta(), 100) - 4) <= next(100));
  CHECK(std::abs(order(DormandPrinceFifth(), 80) - 5) <= next(80));
  CHECK(std::abs(order(DormandPrinceEighth(), 20) - 8) <= next(20));
}

TEST_CASE_TEMPLATE(
    "A tolerance is an angle: inertia and torque times 2²⁰ or 2⁻²⁰ change no bit and no step", Real,
    EVERY_PRECISION) {
  for (const int k : {-20, 20}) {
    const Real scale = std::ldexp(Real(1), k);
    const auto problem = heavy_top<Real>("", 3);
    auto scaled = problem;
    scaled.start.angular_momentum_body *= scale;
    scaled.start.inverse_moments /= scale;
    scaled.evaluate_forces.weight_times_arm *= scale;
    Top<Real> mine = problem.start, other = scaled.start;
    const StepCounts a = integrate<DormandPrince853>(mine, problem.evaluate_forces, Real(0), 5,
                                                     Real(1e-3)),
                     b = integrate<DormandPrince853>(other, scaled.evaluate_forces, Real(0), 5,
                                                     Real(1e-3));
    CHECK(a.steps == b.steps);
    CHECK(mine.orientation.real == other.orientation.real);
    CHECK(same_bits(mine.orientation.imaginary, other.orientation.imaginary));
    const StepCounts c = integrate_axis<DormandPrince853>(mine, problem.evaluate_forces, Real(0), 5,
                                                          Real(1e-3)),
                     d = integrate_axis<DormandPrince853>(other, scaled.evaluate_forces, Real(0), 5,
                                                          Real(1e-3));
    CHECK(c.steps == d.steps);
    CHECK(same_bits(mine.orientation.imaginary, other.orientation.imaginary));
  }
}

TEST_CASE_TEMPLATE("A pair leaves L of a locked axis at 0, and the top carries on", Real,
                   EVERY_PRECISION) {
  for (int axis = 0; axis < 3; ++axis) {
    auto driven = driven_top<Real>();
    lock_axis(driven.start, axis);
    Top<Real> top = driven.start;
    integrate<DormandPrince54>(top, driven.evaluate_forces, Real(0), 4, Real(1e-4));
    CHECK(top.angular_momentum_body[axis] == 0);
    CHECK(top.angular_momentum_body.norm() > Real(0.1));
    Top<Real> free = driven.start;
    const StepCounts counts = integrate_free_top<DormandPrince54>(free, 4, Real(1e-4));
    CHECK(counts.steps == 1);  // with an axis locked a free top turns steadily
    CHECK(free.angular_momentum_body[axis] == 0);
  }
}

TEST_CASE_TEMPLATE("The axis of a heavy top moves as the exact solution says, and L along it stays",
                   Real, EVERY_PRECISION) {
  for (const double spin : {3, 20}) {
    CAPTURE(spin);
    const auto problem = heavy_top<Real>("", spin);
    const auto truth = truth_of(problem);
    Top<Real> top = problem.start;
    integrate_axis<DormandPrince853>(top, problem.evaluate_forces, Real(0), Real(problem.seconds),
                                     Real(1e-5));
    // 1e-5 rad a second for ten seconds, in which the nutation may spread it by ten; and in float
    // some 60 steps of 60 roundings, on an L of which the spin makes up to 20 rad/s.
    const double rounding = 60 * 60 * 20 * double(unit_roundoff<Real>);
    CHECK(double(angle_error(top, truth)) <= 10 * 10 * 1e-5 + rounding);
    CHECK(top.angular_momentum_body.z() == problem.start.angular_momentum_body.z());
  }
}

TEST_CASE("In steps of one length the axis of a heavy top has the order of the rule") {
  // Spun slowly, it passes nearly through its lowest place: n changes its side on the way.
  for (const double spin : {0.5, 3.0}) {
    CAPTURE(spin);
    auto problem = heavy_top<Wide>("", spin);
    problem.seconds = 3;
    const Top<Wide> truth = truth_of(problem);
    const auto error = [&]<class Rule>(Rule, long steps) {
      Top<Wide> top = problem.start;
      integrate_axis_evenly<Rule>(top, problem.evaluate_forces, 0.0L, problem.seconds, steps);
      CHECK(top.angular_momentum_body.z() == problem.start.angular_momentum_body.z());
      return angle_error(top, truth);
    };
    // The mean of three halvings, for at one length of a step the leading terms may cancel.
    const auto order = [&](auto rule) { return std::log2(error(rule, 16) / error(rule, 128)) / 3; };
    CHECK(order(Kutta()) > 3.5L);
    CHECK(order(DormandPrinceEighth()) > 7.5L);
    CHECK(order(FehlbergEighth()) > 7.5L);
  }
}

TEST_CASE("A top that spins faster needs no shorter steps where its axis is apart from its spin") {
  // |L|/I sets the pace, which the spin changes by the moment about the axis alone; the
  // quaternion's numbers turn with the spin.
  const auto steps = [&](auto carry_it, double inverse_about_axis) {
    auto problem = heavy_top<double>("", 0);
    problem.start.inverse_moments.z() = inverse_about_axis;
    problem.start.angular_momentum_body.z() = 1;
    Topd top = problem.start;
    return carry_it(top, problem.evaluate_forces).steps;
  };
  const auto apart = [](Topd& top, const Weight<double>& weight) {
    return integrate_axis<DormandPrince54>(top, weight, 0.0, 5, 1e-6);
  };
  const auto whole = [](Topd& top, const Weight<double>& weight) {
    return integrate<DormandPrince54>(top, weight, 0.0, 5, 1e-6);
  };
  CHECK(steps(apart, 100) == steps(apart, 5));
  CHECK(steps(whole, 100) > 5 * steps(whole, 5));
}
