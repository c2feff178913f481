#include <exercise/judge.hpp>

using namespace tumble;
using namespace tumble::exercise;

EXERCISE_CHECK("What falls near the Moon's ground gains 1.62 m/s downward in every second") {
  using Vector = Vec3<Real>;
  const auto gravity = ask<Vector>("gravity");
  Found("the acceleration", "m/s²", gravity)
      .mistake(Vector(0, 0, Real(-9.81)), "that is the Earth's. Change the one number in gravity()")
      .mistake(Vector(0, 0, Real(1.62)),
               "everything would fall upward. z points up, so what pulls down is negative")
      .mistake(Vector(0, 0, Real(-9.81 / 6)),
               "a sixth of the Earth's is the rule of thumb. The number itself is 1.62 m/s²")
      .mistake(Vector(0, Real(-1.62), 0), "it points sideways. z is the axis that points up")
      .mistake(Vector(Real(-1.62), 0, 0), "it points sideways. z is the axis that points up")
      .must_be(Vector(0, 0, Real(-1.62)), 2 * 1.62 * unit_roundoff<Real>);
}

EXERCISE_CHECK("The same throw rises six times as high as on Earth") {
  // Stepped with h, a throw of speed v reaches v²/2g less at most h v, and never more than v²/2g.
  const Real speed = Real(parameter("speed")), time_step = Real(1) / 1024;
  const auto height = ask<Real>("highest_point", speed, time_step);
  const Real moon = speed * speed / Real(2 * 1.62), earth = speed * speed / Real(2 * 9.81);
  require(!(height >= 1000),
          "the ball passes a kilometre and flies on. Does gravity pull down, along minus z?");
  Found("the highest point of a throw with " + shown(speed) + " m/s", "m", height)
      .mistake(
          earth,
          "that is how high it rises on Earth. The gravity that it feels is not yet the Moon's")
      .mistake(0, "the ball never left the ground. Does gravity pull down, along minus z?")
      .must_be(moon, speed * time_step);
}
