#include <exercise/judge.hpp>
#include <tumble/drag.hpp>
#include <tumble/particle.hpp>

using namespace tumble;
using namespace tumble::exercise;

namespace {

const double g = 9.81, mass = 0.005;

double terminal_speed() {
  return parameter("terminal_speed");
}
double coefficient() {
  return mass * g / (terminal_speed() * terminal_speed());
}

template <class Real>
Vec3<Real> slowed(const Vec3<Real>& velocity, const Vec3<Real>& wind, double time) {
  return ask<Vec3<Real>>("slowed", velocity, wind, Real(mass), Real(coefficient()), Real(time));
}

template <class Real>
constexpr double few_roundings = 32 * unit_roundoff<Real>;

/// Where a shot is after `time`, by many short steps of second order: half a kick by the chapter's
/// force, a drift, and half a kick with the velocity that this has made.
Vec3d reference(const Vec3d& velocity, const Vec3d& wind, double time) {
  const int steps = 20000;
  const double h = time / steps;
  const auto acceleration = [&](const Vec3d& v) {
    return Vec3d(Vec3d(0, 0, -g) + quadratic_drag(coefficient(), v, wind) / mass);
  };
  Vec3d x(0, 0, 2), v = velocity;
  for (int n = 0; n < steps; ++n) {
    const Vec3d middle = v + h / 2 * acceleration(v);
    x += h * middle;
    v += h * acceleration(middle);
  }
  return x;
}

template <class Real>
Vec3d flown(const Vec3d& velocity, const Vec3d& wind, double time, int steps) {
  const auto shuttle = make_particle<Real>(Real(mass), {0, 0, 2}, velocity.cast<Real>());
  return ask<Particle<Real>>("flown", shuttle, Vec3<Real>(wind.cast<Real>()), Real(coefficient()),
                             Real(time / steps), steps)
      .position.template cast<double>();
}

}  // namespace

EXERCISE_CHECK("At its terminal speed the drag of chapter 9 bears the shuttlecock's weight") {
  for (const auto& [kg, v] : {std::pair(mass, terminal_speed()), {0.018, 9.0}}) {
    const double weight = kg * g;
    const Real c = ask<Real>("coefficient_of", Real(kg), Real(v));
    const Vec3d drag = quadratic_drag(double(c), Vec3d(0, 0, -v), Vec3d(0, 0, 0));
    Found("the drag on " + shown(kg) + " kg at " + shown(v) + " m/s downward, with your c of " +
              shown(c) + " kg/m",
          "N", drag.z())
        .mistake(weight * v,
                 "that bears too much. Drag grows with the square of the speed: divide by it twice")
        .mistake(g, "the mass is missing: a weight is m g")
        .mistake(2 * weight, "twice the weight. The half of ½ ρ C A is inside c already")
        .mistake(weight / 2, "half the weight. The half of ½ ρ C A is inside c already")
        .mistake(weight / g, "where is gravity?")
        .must_be(weight, few_roundings<Real> * weight);
  }
}

EXERCISE_CHECK("Drag alone leaves v0 / (1 + c v0 t / m), however the time is cut") {
  const Vec3<Real> start(80, 0, 60), still = Vec3<Real>::Zero();
  const double time = 0.5, z = coefficient() / mass * 100 * time;
  for (const int pieces : {1, 4, 16}) {
    Vec3<Real> velocity = start;
    for (int n = 0; n < pieces; ++n) velocity = slowed<Real>(velocity, still, time / pieces);
    double stepped = 100;
    for (int n = 0; n < pieces; ++n)
      stepped -= coefficient() / mass * stepped * stepped * time / pieces;
    const auto along = [&](double speed) { return Vec3<Real>(start * Real(speed / 100)); };
    Found("what drag leaves of (80, 0, 60) m/s after 0.5 s in " + counted(pieces, "piece"), "m/s",
          velocity)
        .mistake(
            along(stepped),
            "that is the drag as a force, which turns the shuttle round. Integrate u' = -(c/m) "
            "u² over the whole time")
        .mistake(along(100 * std::exp(-z)),
                 "that fades as e^(-t), as damping does. The rate itself falls with the speed: "
                 "integrate u'/u²")
        .mistake(along(100 / (1 + z * mass)), "the mass of the shuttle is missing")
        .mistake(start, "it was not slowed at all")
        .must_be(along(100 / (1 + z)), pieces * few_roundings<Real> * 100);
  }
}

EXERCISE_CHECK("What moves with the wind keeps its velocity, and what rests is blown along") {
  const Vec3<Real> wind(4, -3, 0);
  using Vector = Vec3<Real>;
  Found("after a second in a wind of (4, -3, 0) m/s, the velocity of a leaf that moves with it",
        "m/s", slowed<Real>(wind, wind, 1))
      .mistake(Vector::Zero(),
               "right as seen from the air: it does not move through it. Seen from the ground it "
               "has the wind's velocity; add it again")
      .mistake(Vector(wind / Real(1 + coefficient() / mass * 5)),
               "it was braked, though it does not move through the air. Where is the wind?")
      .must_be(wind, few_roundings<Real> * 5);
  const double left = 1 / (1 + coefficient() / mass * 5);
  Found("after a second in a wind of (4, -3, 0) m/s, the velocity of a leaf that was at rest",
        "m/s", slowed<Real>(Vector::Zero(), wind, 1))
      .mistake(Vector(-wind * Real(left)),
               "right as seen from the air. Seen from the ground, the wind is added to it")
      .mistake(Vector::Zero(), "the wind does nothing to it")
      .mistake(Vector(wind * Real(left)), "what fades is the motion through the air, wind and all")
      .must_be(Vector(wind * Real(1 - left)), few_roundings<Real> * 5);
}

EXERCISE_CHECK("It flies where ever shorter steps say, and half the step is half the error") {
  const Vec3d up = Vec3d::UnitZ(), at_first = 2 * up, none = Vec3d::Zero();
  const double blink = 1.0 / 64, fallen = blink * blink * g;
  // The air takes the part c h (h g) / m of it, less than a thousandth.
  Found("from rest 2 m up in still air, the place after a step of 1/64 s", "m",
        flown<Real>(none, none, blink, 1))
      .mistake(at_first - fallen * Vec3d::UnitY(), "it fell along y. Here z points up")
      .mistake(at_first + fallen * up, "it fell upward. z points up, so gravity's kick is negative")
      .mistake(at_first - fallen * mass * up,
               "gravity's kick was multiplied by the mass. It is -h g, without a mass")
      .mistake(at_first - fallen / mass * up,
               "gravity's kick was divided by the mass. It is -h g, without a mass")
      .mistake(at_first,
               "it has not moved, as with the old velocity. The drift comes last, with the new one")
      .must_be(at_first - fallen * up,
               fallen * fallen * coefficient() / mass + few_roundings<Real> * 2);
  const double time = 1.5;
  const Vec3d shot(24, 3, 20), wind(-2, 1, 0);
  const Vec3d truth = reference(shot, wind, time);
  const Vec3d coarse = flown<Real>(shot, wind, time, 75), fine = flown<Real>(shot, wind, time, 150);
  const double error = (coarse - truth).norm(), error_of_half = (fine - truth).norm();
  const Vec3d fall(0, 0, -g * time * time / 2);
  require((fine - (Vec3d(0, 0, 2) + shot * time + fall)).norm() > 1,
          "it flies on the parabola of chapter 1. Where is the air?");
  // The kick of a step, h g, and what the drag makes of h, h c v²/m at v = 31 m/s, each for the
  // time of the flight, bound the error of the longer step; it is a few centimetres.
  require(error < 0.5,
          sentence("after 1.5 s in 75 steps the shuttle is at ", coarse,
                   " m; it must be within half a metre of ", truth,
                   " m. Is gravity's kick -h g, without a mass, and is the position moved with the "
                   "new velocity?"));
  // First order: half the step, half the error. The next order changes the ratio by some percent.
  require(error > 1.7 * error_of_half && error < 2.4 * error_of_half,
          sentence("with half the step the error went from ", error, " to ", error_of_half,
                   " m; it must halve"));
  // One long step, whose order shows: kicked, slowed, moved.
  const double h = 0.5;
  const auto left = [&](const Vec3d& v) {
    return Vec3d(wind + (v - wind) / (1 + coefficient() / mass * (v - wind).norm() * h));
  };
  const Vec3d start(0, 0, 2), kick(0, 0, -g * h);
  Found("the place after a single step of half a second", "m", flown<Real>(shot, wind, h, 1))
      .mistake(start + h * shot, "it was moved with the old velocity. The drift comes last")
      .mistake(start + h * (left(shot) + kick),
               "it was slowed first and kicked then. Gravity's kick comes before the drag")
      .must_be(start + h * left(shot + kick), few_roundings<Real> * 32);
}
