#include <support/checks.hpp>
#include <support/contest.hpp>
#include <support/exact_motion.hpp>
#include <support/problems.hpp>
#include <tumble/adaptive_ladder.hpp>
#include <vector>

using namespace tumble;
using namespace tumble::support;

namespace {

/// Errors of integrations, and how many steps an integration took.
struct Seen {
  double error = 0, steps = 0;
};

/// A rung's order by the errors of `seen` at a fineness of 1, 2, 4, …, from `first` on for as long
/// as the error is above what roundings make of it: 0 if that is less than a doubling.
///
/// Where steps are chosen, their number and the places of the ends are not quite in proportion, so
/// that the error at one end may be lucky; `seen` therefore takes several ends together.
template <class See>
double order_of(const See& seen, int first, double rounding_of_a_step) {
  Seen coarse, fine;
  for (int fineness = first; fineness <= 1024; fineness *= 2) {
    const Seen now = seen(fineness);
    // Errors of steps add up like a random walk, five deviations long, and a motion of some radians
    // spreads them by ten.
    if (!(now.error > 10 * 5 * rounding_of_a_step * std::sqrt(now.steps))) break;
    if (coarse.steps == 0) coarse = now;
    fine = now;
  }
  if (!(fine.steps > 1.8 * coarse.steps)) return 0;
  return std::log(coarse.error / fine.error) / std::log(fine.steps / coarse.steps);
}

/// The root mean square of the errors after several times, of integrations from the start to each.
template <class Error>
Seen over_several_ends(double seconds, const Error& error) {
  constexpr int ends = 8;
  Seen all;
  for (int n = 0; n < ends; ++n) {
    const Seen one = error(seconds * (1 + n / double(ends)));
    all.error += one.error * one.error / ends;
    all.steps += one.steps / ends;
  }
  all.error = std::sqrt(all.error);
  return all;
}

/// Forty roundings a stage, of which a stage of the eighth order has a dozen, as a random walk.
template <class Real>
const double rounding_of_a_step = std::sqrt(40 * 12 / 3.0) * double(unit_roundoff<Real>);

template <class Real>
double mean_order_of(const FreeTopRung<Real>& rung, int first) {
  const Top<Real> start = free_problems<Real>()[0].start;
  const exact::FreeTop<long double> exact(exactly(start));
  // The pair 8(5,3) combines two estimates. Which of them counts changes with the tolerance, and
  // with it the pattern of the steps, so that the mean step alone does not tell the error.
  const double coarsest = rung.given == Given::angle ? 1 : 0.1;
  return order_of(
      [&](int fineness) {
        const auto given = static_cast<Real>(coarsest * std::pow(fineness, -rung.power));
        return over_several_ends(5, [&](double seconds) {
          Top<Real> top = start;
          const StepCounts counts = rung.integrate(top, Real(seconds), given);
          return Seen{
              double(angle_between(exact.at(Real(seconds)).orientation, exactly(top).orientation)),
              double(counts.steps)};
        });
      },
      first, rounding_of_a_step<Real>);
}

/// Takes a stepper along as it chooses, and then two others at the same moments, with each of its
/// steps divided into two and into four. Their errors show the order, since the steps are in
/// proportion to each other.
template <class Stepper, class Error>
double order_in_proportion(const Stepper& start, long double seconds, const Error& error) {
  Stepper chosen = start;
  std::vector<long double> steps;
  const long double first = chosen.first_step(seconds);
  integrate_adaptively(chosen, seconds, first,
                       [&](long double, long double h) { steps.push_back(h); });
  const auto divided = [&](int parts) {
    Stepper stepper = start;
    for (const long double h : steps)
      for (int n = 0; n < parts; ++n) stepper.attempt(h / parts), stepper.accept();
    return error(stepper);
  };
  return static_cast<double>(std::log2(divided(2) / divided(4)));
}

/// How far a problem's body is off in the end, by a stepper that has taken it there.
template <class Body, class Forces>
auto error_in(const Problem<Body, Forces>& problem) {
  return [truth = truth_of(problem)]<class Stepper>(const Stepper& stepper) -> long double {
    if constexpr (!requires(const Body& body) { body.orientation; })
      return (stepper.body().position - truth.position).norm();
    else
      return angle_between(stepper.body().orientation, truth.orientation);
  };
}

}  // namespace

TEST_CASE_TEMPLATE(
    "Of a free top's rungs that choose their steps, each of one estimate has the order that it "
    "claims",
    Real, EVERY_PRECISION) {
  int shown = 0;
  for (const FreeTopRung<Real>& rung : free_top_rungs<Real>) {
    CAPTURE(std::string(rung.name));
    if (rung.power == 7) continue;  // in proportion alone, see below
    const double order = mean_order_of(rung, rung.given == Given::angle ? 2 : 8);
    CAPTURE(order);
    if (order == 0) continue;  // rounding hides it
    ++shown;
    CHECK(std::lround(order) == rung.claims.order);
  }
  // In double each of these shows it. In float steps so short that the order shows leave an error
  // above rounding to a low order alone.
  CHECK(shown >= (std::is_same_v<Real, float> ? 1 : 5));
}

TEST_CASE("Where an integration's steps are divided in proportion, each pair shows its order") {
  using Wide = long double;
  const auto check = [](const auto& stepper, const auto& problem, int order) {
    CAPTURE(problem.name);
    const double shown = order_in_proportion(stepper, problem.seconds, error_in(problem));
    CAPTURE(shown);
    CHECK(std::lround(shown) == order);
  };
  const auto free = free_problems<Wide>()[0];
  const auto orbit = eccentric_orbit<Wide>();
  const auto heavy = heavy_top<Wide>("heavy top", 3);
  const auto check_pair = [&]<class Pair>(Pair, int order, Wide tolerance) {
    CAPTURE(order);
    check(EmbeddedSteps<Pair, Top<Wide>, NoTorque<Wide>, Wide>(free.start, free.evaluate_forces, 0,
                                                               tolerance),
          free, order);
    check(ReducedSteps<Pair, FreeTurn<Wide>, Wide>(FreeTurn<Wide>(free.start), 0, tolerance), free,
          order);
    check(EmbeddedSteps<Pair, Particle<Wide>, Star<Wide>, Wide>(orbit.start, orbit.evaluate_forces,
                                                                0, {tolerance, tolerance}),
          orbit, order);
    check(EmbeddedSteps<Pair, Top<Wide>, Weight<Wide>, Wide>(heavy.start, heavy.evaluate_forces, 0,
                                                             tolerance),
          heavy, order);
    using Axis = AxisTurn<Weight<Wide>, Wide>;
    check(ReducedSteps<Pair, Axis, Wide>(Axis(heavy.start, heavy.evaluate_forces), 0, tolerance),
          heavy, order);
  };
  check_pair(DormandPrince54(), 5, 1e-6L);
  check_pair(DormandPrince853(), 8, 1e-7L);
  check(NystromSteps<DormandPrinceNystrom86, Star<Wide>, Wide>(orbit.start, orbit.evaluate_forces,
                                                               0, {1e-7L, 1e-7L}),
        orbit, 8);
}

TEST_CASE_TEMPLATE(
    "Each rung that chooses its steps keeps what it claims to keep and loses what it does not",
    Real, EVERY_PRECISION) {
  const Top<Real> start = free_problems<Real>()[0].start;
  const Vec3<long double> L = angular_momentum_world(exactly(start));
  for (const FreeTopRung<Real>& rung : free_top_rungs<Real>) {
    CAPTURE(std::string(rung.name));
    const Real given = rung.given == Given::angle ? Real(1) : Real(0.1);
    Top<Real> top = start;
    const StepCounts counts = rung.integrate(top, 10, given);
    // Forty roundings a stage, of which a step has no more than 17; a loss is worth showing from
    // ten times as much on. Suzuki's five and Kahan and Li's seventeen steps count as one.
    const double kept = 40 * 17 * double(counts.steps + 1) * unit_roundoff<Real>;
    const double off = double((angular_momentum_world(exactly(top)) - L).norm() / L.norm());
    CHECK(rung.claims.momentum == (off <= kept));
    // No rung claims the energy, or that it retraces its steps. In float the eighth order of a
    // splitting loses nothing that can be seen.
    CHECK(!rung.claims.energy);
    CHECK(!rung.claims.reverses);
    CHECK(!rung.claims.bounded);
    if (std::is_same_v<Real, float> && rung.given == Given::angle && rung.claims.order > 2)
      continue;
    const double rounding = 40 * double(counts.steps + 1) * unit_roundoff<Real>;
    CHECK(std::abs(double(kinetic_energy(exactly(top)) / kinetic_energy(exactly(start))) - 1) >
          rounding);
    top.angular_momentum_body *= -1;
    rung.integrate(top, 10, given);
    CHECK(double(angle_between(exactly(top).orientation, exactly(start).orientation)) > rounding);
  }
}
