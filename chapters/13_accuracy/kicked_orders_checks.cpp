#include <support/exact_motion.hpp>
#include <support/orders.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

/// A push that swings, on a spring: x'' = −x + cos 2t.
struct SwungSpring {
  void operator()(Particle<Wide>& particle, Wide time) const {
    particle.force = -particle.position;
    particle.force.x() += std::cos(2 * time);
  }
};

void turn_around(Particle<Wide>& particle) {
  particle.velocity *= -1;
}
void turn_around(Top<Wide>& top) {
  top.angular_momentum_body *= -1;
}

/// There and back in as many steps, a rung that retraces them is off by roundings alone: 40 in each
/// of 35 stages at most, spread tenfold by the motion. Another rung is off by ten times as much.
template <class Body, class Forces, class Ladder>
void check_reversals(const Problem<Body, Forces>& problem, int steps, const Ladder& ladder) {
  const Wide rounding = 10 * 2 * steps * 35 * 40 * unit_roundoff<Wide>;
  for (const auto& rung : ladder) {
    CAPTURE(std::string(rung.name));
    auto back = problem;
    back.start = after(problem, rung, steps);
    turn_around(back.start);
    const Wide off = difference(after(back, rung, steps), problem.start);
    CAPTURE(static_cast<double>(off));
    // What is claimed of a free top is claimed here of none.
    CHECK(!(rung.claims.energy || rung.claims.momentum || rung.claims.bounded));
    if (rung.claims.reverses)
      CHECK(off <= rounding);
    else
      CHECK(off > 10 * rounding);
  }
}

}  // namespace

TEST_CASE("On an orbit each rung of the motion ladder has its order, against the exact orbit") {
  Problem<Particle<Wide>, Star<Wide>> problem = eccentric_orbit<Wide>();
  problem.start = make_particle<Wide>(1, {0.8L, 0, 0}, {0, std::sqrt(1.5L), 0});  // e = 0.2
  problem.seconds = 7;
  const auto truth = exactly_after(problem.evaluate_forces, problem.start, problem.seconds);
  check_orders(problem, truth, motion_ladder<Wide, Star<Wide>>);
}

TEST_CASE("Under a push that changes with time each rung of the motion ladder has its order") {
  const Problem<Particle<Wide>, SwungSpring> problem{
      "", make_particle<Wide>(1, {0.5L, 0, 0}, {0, 1, 0}), {}, 2};
  const Wide t = 2;
  Particle<Wide> truth = problem.start;
  truth.position = {Wide(5) / 6 * std::cos(t) - std::cos(2 * t) / 3, std::sin(t), 0};
  check_orders(problem, truth, motion_ladder<Wide, SwungSpring>);
}

TEST_CASE("On a throw through thick air each rung that knows of the air has its order") {
  // Explicit Euler and kick and drift know a drift in a straight line alone.
  // So thick that in one of the first, long steps it loses six sevenths of its speed.
  const Problem<Particle<Wide>, GravityInAir<Wide>> problem{
      "",
      make_particle<Wide>(1, {0, 0, 0}, {1, 0, 1}),
      {.weight = 1, .drag = 2, .drag_rate = 2},
      4};
  const auto truth = exactly_after(problem.evaluate_forces, problem.start, problem.seconds);
  using Air = GravityInAir<Wide>;
  std::vector<Rung<Particle<Wide>, Wide, Air>> rungs;
  for (const auto& rung : motion_ladder<Wide, Air>)
    if (rung.claims.order > 1) rungs.push_back(rung);
  CHECK(rungs.size() == 9);
  check_orders(problem, truth, rungs);
}

TEST_CASE("On a heavy top each rung of the torque ladder has its order, against the exact motion") {
  auto problem = heavy_top<Wide>("", 8);
  problem.seconds = 4;
  const auto truth = exactly_after(problem.evaluate_forces, problem.start, problem.seconds);
  check_orders(problem, truth, torque_ladder<Wide, Weight<Wide>>);
}

TEST_CASE("There and back, a rung is off by roundings alone if it claims to retrace its steps") {
  Problem<Particle<Wide>, Star<Wide>> orbit = eccentric_orbit<Wide>();
  orbit.start = make_particle<Wide>(1, {0.8L, 0, 0}, {0, std::sqrt(1.5L), 0});  // e = 0.2
  check_reversals(orbit, 80, motion_ladder<Wide, Star<Wide>>);
  check_reversals(heavy_top<Wide>("", 8), 80, torque_ladder<Wide, Weight<Wide>>);
}

TEST_CASE("On a driven top two ladders meet, and each rung has its order") {
  const auto problem = [] {
    auto driven = driven_top<Wide>();
    driven.seconds = 4;
    return driven;
  }();
  const auto& ladder = torque_ladder<Wide, Drive<Wide>>;
  const Top<Wide> by_splitting = after(problem, ladder.back(), 800);
  const Rung<Top<Wide>, Wide, Drive<Wide>> staged{
      "", {}, step_by_runge_kutta<DormandPrinceEighth, Top<Wide>, Drive<Wide>, Wide>};
  const Top<Wide> by_stages = after(problem, staged, 4000);
  CHECK(difference(by_splitting, by_stages) <= 1e-16L);
  check_orders(problem, by_splitting, ladder);
}

TEST_CASE(
    "With 64 steps and 128 Fehlberg's rule errs less than Dormand and Prince's on the slow heavy "
    "top and the driven one") {
  const auto compare = [](const auto& problem, const Top<Wide>& truth) {
    using Forces = std::decay_t<decltype(problem.evaluate_forces)>;
    const auto error_of = [&]<class Rule>(Rule, int steps) {
      const Rung<Top<Wide>, Wide, Forces> rung{
          "", {}, step_by_runge_kutta<Rule, Top<Wide>, Forces, Wide>};
      return difference(after(problem, rung, steps), truth);
    };
    for (const int steps : {64, 128})
      CHECK(error_of(FehlbergEighth(), steps) < error_of(DormandPrinceEighth(), steps));
  };
  const auto heavy = heavy_top<Wide>("", 3);
  compare(heavy, exactly_after(heavy.evaluate_forces, heavy.start, heavy.seconds));
  const auto driven = driven_top<Wide>();
  compare(driven, after(driven, torque_ladder<Wide, Drive<Wide>>.back(), 1000));
}
