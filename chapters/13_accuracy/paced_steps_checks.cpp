#include <support/checks.hpp>
#include <support/contest.hpp>
#include <support/exact_motion.hpp>
#include <tumble/paced_steps.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

using Wide = long double;

/// A heavy top that hardly spins: it swings like a pendulum, slow at the ends and fast in between.
template <class Real>
Problem<Top<Real>, Weight<Real>> slow_top() {
  return heavy_top<Real>("slow heavy top", 0.5);
}

template <class Real>
double energy_error(const Top<Real>& top, const Problem<Top<Real>, Weight<Real>>& problem) {
  const auto energy = [&](const Top<Real>& of) {
    return problem.evaluate_forces.kept(exactly(of)).energy;
  };
  return std::abs(static_cast<double>(energy(top) / energy(problem.start) - 1));
}

}  // namespace

TEST_CASE_TEMPLATE(
    "On a symmetric heavy top the energy stays bounded with steps that follow the pace "
    "symmetrically, and drifts with steps chosen at their start",
    Real, EVERY_PRECISION) {
  const auto problem = slow_top<Real>();
  const Real angle = Real(0.1), least = 1;
  const int steps = 20'000;
  PacedSteps<Verlet, Weight<Real>, Real> paced(problem.start, problem.evaluate_forces, 0, angle,
                                               least);
  Top<Real> chosen = problem.start;
  problem.evaluate_forces(chosen, 0);
  // The worst of the first and of the second half of the integration.
  std::array<double, 2> symmetric{}, plain{};
  Real shortest = 1, longest = 0;
  for (int n = 0; n < steps; ++n) {
    shortest = std::min(shortest, paced.next());
    longest = std::max(longest, paced.next());
    paced.step();
    const Real pace = std::sqrt(angular_velocity_body(chosen).squaredNorm() + least * least);
    step_by_row<Verlet>(chosen, problem.evaluate_forces, Real(0), angle / pace);
    const std::size_t half = n < steps / 2 ? 0 : 1;
    symmetric[half] = std::max(symmetric[half], energy_error(paced.top(), problem));
    plain[half] = std::max(plain[half], energy_error(chosen, problem));
  }
  CHECK(longest > 2 * shortest);  // or nothing would have been chosen
  // A rounding of each of forty operations a step, as a random walk of five deviations; an energy
  // that swings between bounds has shown them in a thousand swings, but for a tenth.
  const double rounding = 5 * std::sqrt(40.0 * steps) * unit_roundoff<Real>;
  CHECK(symmetric[1] <= 1.1 * symmetric[0] + rounding);
  // Twice as far in twice the time, less what it swings in both cases.
  CHECK(plain[1] >= 2 * (plain[0] - symmetric[0]));
  CHECK(plain[1] > 5 * symmetric[1]);
}

TEST_CASE_TEMPLATE("Steps that follow the pace are retraced when the top is turned around", Real,
                   EVERY_PRECISION) {
  const auto check = [](const auto& start, const auto& evaluate_forces, Real least) {
    using Forces = std::decay_t<decltype(evaluate_forces)>;
    PacedSteps<Suzuki, Forces, Real> paced(start, evaluate_forces, 0, Real(0.25), least);
    const int steps = 40;
    for (int n = 0; n < steps; ++n) paced.step();
    CHECK(angle_between(paced.top().orientation, start.orientation) > Real(0.1));
    paced.turn_around();
    for (int n = 0; n < steps; ++n) paced.step();
    // 80 steps of five parts, of 40 roundings each, which the motion spreads by ten.
    CHECK(angle_between(paced.top().orientation, start.orientation) <=
          10 * 80 * 5 * 40 * unit_roundoff<Real>);
    CHECK(std::abs(paced.next() * paced.pace() - Real(0.25)) <= Real(0.25) * Real(0.25));
  };
  const auto heavy = slow_top<Real>();
  check(heavy.start, heavy.evaluate_forces, Real(1));
  const auto free = free_problems<Real>()[0];
  check(free.start, free.evaluate_forces, Real(0));
}

TEST_CASE("Paced, each row has its order against the exact motion of a heavy top") {
  auto problem = slow_top<Wide>();
  problem.seconds = 4;
  const auto truth = truth_of(problem);
  const auto order = [&]<class Row>(Row, Wide angle) {
    const auto error = [&](Wide of) {
      Top<Wide> top = problem.start;
      const StepCounts counts =
          integrate_paced<Row>(top, problem.evaluate_forces, 0.0L, problem.seconds, of, 1.0L);
      return std::pair(angle_between(top.orientation, truth.orientation), Wide(counts.steps));
    };
    const auto [coarse, few] = error(angle);
    const auto [fine, many] = error(angle / 4);
    return std::log(coarse / fine) / std::log(many / few);
  };
  CHECK(std::lround(order(Verlet(), 0.04L)) == 2);
  CHECK(std::lround(order(Suzuki(), 0.04L)) == 4);
  CHECK(std::lround(order(KahanLiSixth(), 0.1L)) == 6);
  CHECK(std::lround(order(KahanLiEighth(), 0.2L)) == 8);
}

TEST_CASE("Under a torque that changes with time paced steps keep the clock, whenever they begin") {
  const auto problem = driven_top<Wide>();
  for (const Wide begin : {0.0L, 3.0L, -1.0L}) {
    Top<Wide> staged = problem.start;
    problem.evaluate_forces(staged, begin);
    for (int n = 0; n < 400; ++n)
      step_by_runge_kutta<DormandPrinceEighth>(staged, problem.evaluate_forces,
                                               begin + Wide(n) / 100, 0.01L);
    const auto error = [&](Wide angle) {
      Top<Wide> paced = problem.start;
      integrate_paced<KahanLiEighth>(paced, problem.evaluate_forces, begin, 4, angle, 1);
      return angle_between(paced.orientation, staged.orientation);
    };
    const Wide fine = error(0.1L);
    CAPTURE(static_cast<double>(fine));
    CHECK(std::lround(std::log2(error(0.2L) / fine)) == 8);

    PacedSteps<Verlet, Drive<Wide>, Wide> steps(problem.start, problem.evaluate_forces, begin, 0.1L,
                                                1);
    Wide now = begin;
    for (int n = 0; n < 20; ++n) {
      now += steps.next();
      steps.step();
    }
    CHECK(std::abs(steps.time() - now) <= 20 * 10 * unit_roundoff<Wide>);
  }
}

TEST_CASE_TEMPLATE("The pace that is carried along stays true to the pace of the top", Real,
                   EVERY_PRECISION) {
  // One step is off by the third power of its angle, and a symmetric rule does not add that up;
  // what is left is of the second power, times a change of the rate by some of itself for each
  // radian.
  const auto problem = slow_top<Real>();
  for (const Real angle : {Real(0.1), Real(0.05)}) {
    PacedSteps<Verlet, Weight<Real>, Real> paced(problem.start, problem.evaluate_forces, 0, angle,
                                                 1);
    Real worst = 0;
    for (int n = 0; n < 2000; ++n) {
      paced.step();
      const Real pace = std::sqrt(angular_velocity_body(paced.top()).squaredNorm() + 1);
      worst = std::max(worst, std::abs(paced.pace() / pace - 1));
    }
    CHECK(worst <= angle * angle);
  }
}

TEST_CASE(
    "A paced integration ends where it is told to, and what it can't be asked for is refused") {
  const auto problem = slow_top<double>();
  const auto carried = [&](double seconds, double angle, double least = 1) {
    Topd top = problem.start;
    const StepCounts counts =
        integrate_paced<Verlet>(top, problem.evaluate_forces, 0.0, seconds, angle, least);
    return std::pair(top, counts.steps);
  };
  CHECK(carried(0, 0.1).second == 0);
  CHECK(
      same_bits(carried(0, 0.1).first.orientation.imaginary, problem.start.orientation.imaginary));
  CHECK(carried(1e-3, 0.1).second == 1);
  // Steps of a hundredth of a radian, an error far below a hundredth: it lands at that moment.
  const auto truth = exactly_after(problem.evaluate_forces, problem.start, 7);
  CHECK(angle_between(carried(7, 0.01).first.orientation, truth.orientation) < 1e-3);
  CHECK(complaint_of([&] { carried(-1, 0.1); }) == "time is -1 s; it must be 0 or more");
  CHECK(complaint_of([&] { carried(1, 0); }) == "angle is 0 rad a step; it must be greater than 0");
  CHECK(complaint_of([&] { carried(1, NAN); }) == "angle is nan rad a step; it must be finite");
  CHECK(complaint_of([&] { carried(1, INFINITY); }) ==
        "angle is inf rad a step; it must be finite");
  CHECK(complaint_of([&] { carried(1, 0.1, -1); }) ==
        "least pace is -1 rad/s; it must be 0 or more");
  // Spun up as 1/(1 s - t), beyond all bounds: in the end no clock shows the steps.
  const auto wind_up = [](Topd& top, double time) {
    top.torque = {0, 1 / ((1 - time) * (1 - time)), 0};
  };
  Topd wound{.angular_momentum_body = {0, 1, 0}, .inverse_moments = {1, 1, 1}};
  CHECK_THROWS_WITH_AS(integrate_paced<Verlet>(wound, wind_up, 0.0, 2, 0.125, 0),
                       doctest::Contains("s after the start; the top turns too fast for the clock"),
                       StepError);
  Topd still{.inverse_moments = {1, 2, 3}};
  const auto nothing = [](Topd& top, double) { top.torque.setZero(); };
  CHECK(integrate_paced<Verlet>(still, nothing, 0.0, 5, 0.125, 0.5).steps == 20);
  CHECK(still.orientation.real == 1);
  CHECK_THROWS_WITH_AS(integrate_paced<Verlet>(still, nothing, 0.0, 5, 0.125, 0),
                       doctest::Contains("the pace ρ is 0 1/s at 0 s"), StepError);
}

TEST_CASE(
    "Where a top swings to and fro, a paced step is positive and of no more than twice its angle, "
    "or refused with the pace and the least pace") {
  const double angle = 0.1;
  // Let go at rest, it has no pace; with a little spin it has next to none, there and wherever it
  // turns back. M g l = 1 N m, sin 0.6 of which pulls, and 1/I = 2.
  for (const double spin : {0.0, 0.0625}) {
    CAPTURE(spin);
    const auto problem = heavy_top<double>("", spin);
    for (const double seconds : {0.5, 10.0}) {
      Topd top = problem.start;
      const std::string pace = "the pace ρ is " + text_of(spin) +
                               " 1/s at 0 s, where the angular velocity of " + text_of(spin) +
                               " rad/s changes by 1.129";
      CHECK_THROWS_WITH_AS(
          integrate_paced<Verlet>(top, problem.evaluate_forces, 0.0, seconds, angle, 0),
          doctest::Contains(pace.c_str()), StepError);
      CHECK_THROWS_WITH_AS(
          integrate_paced<Verlet>(top, problem.evaluate_forces, 0.0, seconds, angle, 0),
          doctest::Contains(" rad/s²: take a least pace greater than 0 rad/s, or a "
                            "smaller angle than 0.1 rad a step"),
          StepError);
      CHECK(same_bits(top.orientation.imaginary, problem.start.orientation.imaginary));
      CHECK(same_bits(top.angular_momentum_body, problem.start.angular_momentum_body));
    }
  }
  // The weight accelerates it by 2 rad/s² at most, and so much is enough:
  const auto swinging = heavy_top<double>("", 0);
  const double acceleration = 2, enough = std::sqrt(angle * acceleration);
  PacedSteps<Verlet, Weight<double>, double> paced(swinging.start, swinging.evaluate_forces, 0,
                                                   angle, enough);
  // What ρ loses in half a step is (angle/2) α |ω|/P² at most, which is P times
  // (angle α/least²)/(3 √3), largest where |ω| = least/√2; and ρ itself is P within angle².
  const double longest = angle / enough / (1 - 1 / (3 * std::sqrt(3.0)) - angle * angle);
  for (int n = 0; n < 5000; ++n) {
    const double before = paced.time();
    CHECK(paced.next() <= longest);
    paced.step();
    CHECK(paced.time() > before);
  }
  // Whatever angle and least pace, what is not refused is as long as it may be.
  int made = 0, refused = 0;
  for (const double of : {0.05, 0.1, 0.3, 1.0})
    for (const double part : {0.01, 0.3, 0.6, 0.9}) {
      CAPTURE(of);
      CAPTURE(part);
      const double least = part * std::sqrt(of * acceleration);
      PacedSteps<Verlet, Weight<double>, double> steps(swinging.start, swinging.evaluate_forces, 0,
                                                       of, least);
      try {
        for (int n = 0; n < 1000; ++n) {
          const double before = steps.time(),
                       pace = std::hypot(angular_velocity_body(steps.top()).norm(), least);
          steps.step();
          ++made;
          CHECK(steps.time() > before);
          CHECK(steps.time() - before <= 2 * of / pace + 2 * unit_roundoff<double> * steps.time());
        }
      } catch (const StepError&) {
        ++refused;
      }
    }
  CHECK(made >= 4000);
  CHECK(refused >= 4);
}

TEST_CASE("A paced step is refused where the pace that is carried has lost touch with the top") {
  // A brake that becomes eight times as strong while the top stops: of 1 kg m², from 4 rad/s.
  const auto brake = [](Topd& top, double time) { top.torque = {0, 0, time < 1 ? -8.0 : -64.0}; };
  const Topd spun{.angular_momentum_body = {0, 0, 4}, .inverse_moments = {1, 1, 1}};
  PacedSteps<Verlet, decltype(brake), double> steps(spun, brake, 0, 2, 0);
  CHECK(steps.next() == 1);  // ρ = 4 − 8/4: angle ω' = P² and ρ = P/2 are allowed
  steps.step();
  CHECK(steps.top().angular_momentum_body.z() == -32);
  CHECK(steps.pace() == 4);  // 2 + 64/32
  CHECK_THROWS_WITH_AS(steps.step(),
                       doctest::Contains("the pace ρ is 6 1/s at 1 s, where the angular velocity "
                                         "of 32 rad/s changes by 64 rad/s²"),
                       StepError);
  CHECK(steps.time() == 1);
}
