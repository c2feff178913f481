#include <exercise/judge.hpp>
#include <tumble/semi_implicit_euler.hpp>

using namespace tumble;
using namespace tumble::exercise;

namespace {

/// A planet at the distance 1, where a circle takes the speed 1 and a round 2π.
template <class Real>
Particle<Real> planet(Same<Real> speed) {
  return make_particle<Real>(Real(0.5), Vec3<Real>(1, 0, 0), Vec3<Real>(0, speed, 0));
}

template <class Real>
Particle<Real> after(const Particle<Real>& from, Same<Real> time_step, int steps) {
  return ask<Particle<Real>>("orbit", from, time_step, steps);
}

/// Where it is after `time`, by many steps of second order.
Vec3d reference(double speed, double time) {
  const int steps = 4096;
  const double h = time / steps;
  auto body = planet<double>(speed);
  for (int n = 0; n < steps; ++n) {
    drift(body, h / 2);
    body.force = -0.5 * body.position / std::pow(body.position.norm(), 3);  // of 0.5 kg
    kick(body, h);
    drift(body, h / 2);
  }
  return body.position;
}

/// A planet that never went round has kept whatever there is to keep, and so has one that jumps to
/// the other side, or is led along a circle that it would not take. So its place is asked for after
/// a sixth and a third of a year, also with a speed that makes no circle.
template <class Real>
void require_way(Same<Real> own_speed, Same<Real> time_step) {
  may_be_off() = 1;
  for (const Real speed : {own_speed, Real(0.875)})
    for (const int part : {6, 3}) {
      const int steps = int(2 * std::numbers::pi / part / double(time_step));
      const auto body = after(planet<Real>(speed), time_step, steps);
      const Vec3<Real> truth = reference(speed, steps * double(time_step)).template cast<Real>();
      // Kick and drift are off as if the planet had begun with h/2 times its acceleration, 1, too
      // much or too little. On a circle that makes up to 4 times h/2; here r goes down to 0.6.
      require((body.position - truth).norm() < 4 * time_step,
              sentence("after 1/", part, " of a year the planet, which began at (1, 0, 0) with ",
                       speed == 1 ? "a circle's speed" : shown(speed) + " times a circle's speed",
                       ", is at ", body.position, "; it must be near ", truth,
                       ". Does each step kick once and drift once?"));
    }
  // Another rule that keeps the area leads elsewhere, but in a step only by some h², h up to 1/16.
  may_be_off() = 1.0 / 128;
  auto body = planet<Real>(own_speed);
  for (int n = 0; n < 8; ++n) body = after(body, time_step, 1);
}

/// Half of the orbit's longest diameter, from speed and distance: 1/a = 2/r - v².
template <class Real>
Real half_length(const Particle<Real>& body) {
  return 1 / (2 / body.position.norm() - body.velocity.squaredNorm());
}

template <class Real>
Real area(const Particle<Real>& body) {
  return body.position.cross(body.velocity).z() / 2;
}

}  // namespace

EXERCISE_CHECK("After a hundred years the planet is as far from its sun as ever") {
  may_be_off() = 1;
  const Real speed = Real(parameter("speed"));
  const int steps_a_year = 120;
  const Real time_step = Real(2 * std::numbers::pi / steps_a_year);
  auto body = planet<Real>(speed);
  const Real size = half_length(body);
  for (int year = 1; year <= 100; ++year) {
    body = after(body, time_step, steps_a_year);
    const Real now = half_length(body);
    require(std::isfinite(now) && now > 0, "in year " + std::to_string(year) +
                                               " the planet has left its sun for good. Each step "
                                               "gains energy: which place does the kick see?");
    // The energy swings by h/2 r'/r², to first order. Here r' stays below 0.27, r above 0.6 and the
    // energy's size above 0.36, so that is 0.05 of it. The other half is for higher orders.
    require(std::abs(now - size) < Real(0.1) * size,
            sentence("in year ", year, " half of the orbit's length is ", now, " instead of ", size,
                     now > size ? ": the planet spirals outward. Which place does the kick see?"
                                : ": the planet spirals inward. Does something brake it?"));
  }
  require_way<Real>(speed, time_step);
}

EXERCISE_CHECK("The planet sweeps the same area in every step, to rounding") {
  const Real speed = Real(parameter("speed")), time_step = Real(0.0625);
  may_be_off() = 1;
  auto body = planet<Real>(speed);
  const Real before = area(body);
  const int steps = 64;
  // One step of explicit Euler at the distance 1 adds h² of it.
  const Real by_explicit_euler = before * (1 + time_step * time_step);
  for (int n = 1; n <= steps; ++n) {
    body = after(body, time_step, 1);
    const Real now = area(body);
    if (std::abs(now - before) <= Real(n * 16) * unit_roundoff<Real>) continue;
    std::string message = sentence("after step ", n, " the area swept in a unit of time is ", now,
                                   " instead of ", before, ". ");
    if (n == 1 && std::abs(now - by_explicit_euler) <= 16 * unit_roundoff<Real>)
      message +=
          "It grew by h²/r³ of itself. The kick pulls towards the sun as seen from the "
          "place before the drift: explicit Euler";
    else if (now > before)
      message +=
          "A pull towards the sun can't change it: is the kick along the place that the "
          "planet has when it is kicked? Smaller steps only slow that down";
    else
      message += "Something brakes, or a kick is not along the planet's place";
    fail(message);
  }
  require_way<Real>(speed, time_step);
}

EXERCISE_CHECK("It still takes a year for a round, the nearer the shorter the step") {
  // A circle: after a year the planet is back. The rule's phase is off by h²/24 of the angle, the
  // circle by an eccentricity of h/2.
  for (const int steps : {128, 256, 512}) {
    may_be_off() = 1;
    const Real time_step = Real(2 * std::numbers::pi / steps);
    const auto miss = [&](Real size, Real speed, Real longer) {
      const Vec3<Real> start(size, 0, 0);
      const auto body = after(make_particle<Real>(Real(0.5), start, Vec3<Real>(0, speed, 0)),
                              longer * time_step, steps);
      const Real distance = (body.position - start).norm();
      return std::isfinite(distance) ? distance : std::numeric_limits<Real>::infinity();
    };
    const Real near = miss(1, 1, 1);
    require(near < 4 * time_step,
            sentence("after a year in ", steps, " steps the planet is ", near,
                     " from where it began, and may miss it by ", 4 * time_step,
                     " only. Does each step kick once and drift once?"));
    // Kepler's third law: four times as wide a circle takes eight times as long. All lengths are
    // four times those above, so is what it may miss.
    const Real far = miss(4, Real(0.5), 8);
    require(
        far < 16 * time_step,
        sentence("a planet four times as far away takes eight years for a round. After them it is ",
                 far, " from where it began, and may miss it by ", 16 * time_step,
                 " only. Leave the pull as it was: it falls with the square of the distance"));
    require_way<Real>(1, time_step);
  }
}
