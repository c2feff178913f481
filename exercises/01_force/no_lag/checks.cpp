#include <exercise/judge.hpp>
#include <tumble/particle.hpp>

using namespace tumble;
using namespace tumble::exercise;

namespace {

/// A ball after `steps` steps of the student's function.
template <class Real>
Particle<Real> stepped(Particle<Real> ball, int steps, Real time_step) {
  for (int n = 0; n < steps; ++n) {
    const Vec3<Real> force = ball.force;
    ball = ask<Particle<Real>>("step_without_lag", ball, time_step);
    ball.force = force;  // a constant force, whether the step clears it or not
  }
  return ball;
}

template <class Real>
Particle<Real> thrown_ball() {
  Particle<Real> ball = make_particle(Real(2), Vec3<Real>(1, 2, 3), Vec3<Real>(4, 0, 10));
  ball.force = Vec3<Real>(0, 0, -8);  // 4 m/s² downward: numbers without rounding
  return ball;
}

}  // namespace

EXERCISE_CHECK("The velocity gains h F/m in a step") {
  const auto ball = stepped(thrown_ball<Real>(), 1, Real(0.5));
  using Vector = Vec3<Real>;
  Found("after half a second at -4 m/s², the velocity of a ball that left with (4, 0, 10) m/s",
        "m/s", ball.velocity)
      .mistake(Vector(4, 0, 10), "it has not changed. A force changes the velocity")
      .mistake(Vector(4, 0, 6), "it fell twice as fast as it should. Is the mass, 2 kg, forgotten?")
      .mistake(Vector(4, 0, 9),
               "that is the velocity in the middle of the step. The ball keeps the one at its end")
      .must_be(Vector(4, 0, 8), 0);
  auto heavy = thrown_ball<Real>();  // 2 kg alone could stand for the 2 of a half
  heavy.inverse_mass = Real(0.125);
  Found("the velocity of a ball of 8 kg after that push", "m/s",
        stepped(heavy, 1, Real(0.5)).velocity)
      .must_be(Vector(4, 0, Real(9.5)), 0);
}

EXERCISE_CHECK("Under a constant force it lands on the parabola, however long a step is") {
  const double time = 2;
  for (const int steps : {1, 2, 8, 32}) {
    const Real h = Real(time / steps);
    const auto ball = stepped(thrown_ball<Real>(), steps, h);
    const Real parabola = Real(3 + 10 * time - 4 * time * time / 2), lag = Real(4 * h * time / 2);
    // Numbers with few binary digits: every sum is exact, but for what another order of the same
    // arithmetic may round, twice a step at heights below 32 m.
    const std::string when = "after 2 s in " + counted(steps, "step") + ", the ";
    Found(when + "height", "m", ball.position.z())
        .mistake(parabola - lag,
                 "too low by half of a h t, as in the chapter. Either the position used the "
                 "velocity at the step's end, or the half of ½ a h² is missing: both come to v h + "
                 "a h²")
        .mistake(parabola + lag,
                 "too high by half of a h t. Either the position used the velocity at the step's "
                 "beginning alone, or ½ was written as 1/2, which C++ computes in whole numbers: "
                 "it is 0")
        .mistake(parabola - 2 * lag,
                 "too low by a h t: the half kick is added to the velocity of the step's end. "
                 "Which velocity "
                 "does it belong to?")
        .must_be(parabola, 2 * steps * 32 * double(unit_roundoff<Real>));
    auto in_wind = thrown_ball<Real>();
    in_wind.inverse_mass = Real(0.125);
    in_wind.force = Vec3<Real>(-8, 16, -32);
    Found(when + "position of a ball of 8 kg that is pushed with (-8, 16, -32) N", "m",
          stepped(in_wind, steps, h).position)
        .must_be(Vec3<Real>(Real(1 + 4 * time - time * time / 2), Real(2 + time * time), parabola),
                 2 * steps * 32 * double(unit_roundoff<Real>));
  }
}

EXERCISE_CHECK("Without force it coasts") {
  Particle<Real> puck = thrown_ball<Real>();
  puck.force.setZero();
  const auto ball = stepped(puck, 4, Real(0.5));
  Found("the position after 2 s without force", "m", ball.position)
      .must_be(Vec3<Real>(9, 2, 23), 0);
  Found("the velocity without force", "m/s", ball.velocity).must_be(puck.velocity, 0);
}

EXERCISE_CHECK("A wall stays where it is, whatever pushes") {
  Particle<Real> wall = make_static_particle(Vec3<Real>(1, 2, 3));
  wall.force = Vec3<Real>(100, 0, 0);
  require(stepped(thrown_ball<Real>(), 1, Real(0.5)).position != thrown_ball<Real>().position,
          "a thrown ball stays where it is, too: there is no step yet");
  const auto pushed = stepped(wall, 4, Real(0.5));
  Found("the position of a wall pushed with 100 N", "m", pushed.position)
      .not_a_number("a wall has no mass to divide by. Its inverse mass is 0; multiply by that")
      .must_be(Vec3<Real>(1, 2, 3), 0);
}
