#include <array>
#include <exercise/judge.hpp>
#include <tumble/particle.hpp>

using namespace tumble;
using namespace tumble::exercise;

namespace {

/// What the exact motion makes of one coordinate.
struct Motion {
  double position, velocity;
};

/// From the origin, in long double, which is witness enough where z is not small.
Motion exact(double velocity, double acceleration, double rate, double time) {
  const long double k = rate, t = time, z = k * t, v = velocity, a = acceleration;
  const long double kept = expl(-z), part = -expm1l(-z);
  return {double(v * part / k + a * (z - part) / (k * k)), double(v * kept + a * part / k)};
}

template <class Real>
Particle<Real> bead(double velocity, double acceleration, Real mass = 2) {
  auto particle = make_particle<Real>(mass, Vec3<Real>::Zero(), Vec3<Real>(0, 0, Real(velocity)));
  particle.force = Vec3<Real>(0, 0, mass * Real(acceleration));
  return particle;
}

template <class Real>
Particle<Real> stepped(Particle<Real> particle, double rate, double time_step, int steps) {
  const Vec3<Real> force = particle.force;
  for (int n = 0; n < steps; ++n) {
    particle = ask<Particle<Real>>("step_through_honey", particle, Real(rate), Real(time_step));
    particle.force = force;  // a constant force, whether the step clears it or not
  }
  return particle;
}

template <class Real>
constexpr double few_roundings = 16 * unit_roundoff<Real>;

// What is said of the ways to be wrong, wherever they show.
const std::string kicked_first =
    "that is kicked first and then damped, as in the chapter. Here both happen all the time: solve "
    "v' = F/m - k v";
const std::string damped_first =
    "that is damped first and then kicked, by the whole of h F/m. The honey takes from the kick "
    "too";
const std::string moved_by_last =
    "that is moved with the velocity at the end of the step. The distance is the integral of the "
    "velocity over the step";
const std::string moved_by_mean =
    "that is moved with the mean of the two velocities. It was exact on a parabola; here the "
    "velocity bends within the step";
const std::string moved_by_parabola =
    "the distance that comes from the velocity is right, but the force's part, h² a / 2, knows "
    "nothing of the honey";

/// What is found and what is true.
struct Compared {
  double found, truth;
  /// By how much it is off, as a part of itself.
  double off() const { return std::abs(found / truth - 1); }
};

}  // namespace

EXERCISE_CHECK("A bead at its terminal speed F/(m k) keeps it, however long the step") {
  const double a = -8, k = parameter("rate"), terminal = a / k;
  for (const double z : {0.25, 1.0, 8.0}) {
    const double h = z / k, kept = std::exp(-z);
    const auto end = stepped(bead<Real>(terminal, a), k, h, 1);
    Found("after a step of " + shown(h) + " s at the terminal speed, the velocity", "m/s",
          double(end.velocity.z()))
        .mistake((terminal + h * a) * kept, kicked_first)
        .mistake(terminal * kept + h * a, damped_first)
        .mistake(terminal * kept, "it only decays. Where is the force?")
        .mistake(terminal * kept + h * 2 * a * (1 - kept) / z,
                 "it falls twice as hard as it should. Is the mass, 2 kg, forgotten?")
        .must_be(terminal, few_roundings<Real> * std::abs(terminal));
    Found("after a step of " + shown(h) + " s at the terminal speed, the velocity of 5 kg", "m/s",
          double(stepped(bead<Real>(terminal, a, 5), k, h, 1).velocity.z()))
        .must_be(terminal, few_roundings<Real> * std::abs(terminal));
    Found("after a step of " + shown(h) + " s at the terminal speed, the distance", "m",
          double(end.position.z()))
        .must_be(terminal * h, few_roundings<Real> * std::abs(terminal * h));
  }
}

EXERCISE_CHECK("It does not matter into how many steps the time is cut") {
  const double k = parameter("rate"), time = 1.5, v = 4, a = -8;
  const auto [position, velocity] = exact(v, a, k, time);
  for (const int steps : {1, 2, 12}) {
    const auto end = stepped(bead<Real>(v, a), k, time / steps, steps);
    const double h = time / steps, z = k * h, kept = std::exp(-z), part = -std::expm1(-z) / z;
    // The ways to be wrong, along the exact velocities.
    double by_last = 0, by_mean = 0, by_parabola = 0, now = v;
    for (int n = 0; n < steps; ++n) {
      const double next = kept * now + h * a * part;
      by_last += h * next;
      by_mean += h * (now + next) / 2;
      by_parabola += h * part * now + h * h / 2 * a;
      now = next;
    }
    const std::string when = "after " + shown(time) + " s in " + counted(steps, "step") + ", ";
    // Numbers below 2 a/k in size, and some sixteen roundings a step.
    const double tolerance = steps * few_roundings<Real> * (std::abs(v) + 2 * std::abs(a) * time);
    Found(when + "the velocity", "m/s", double(end.velocity.z())).must_be(velocity, tolerance);
    Found(when + "the position", "m", double(end.position.z()))
        .mistake(by_last, moved_by_last)
        .mistake(by_mean, moved_by_mean)
        .mistake(by_parabola, moved_by_parabola)
        .must_be(position, tolerance);
  }
}

EXERCISE_CHECK("Without honey it follows the parabola") {
  const auto end = stepped(bead<Real>(4, -8), 0, 0.5, 2);
  const std::string message =
      "with k = 0 a fraction became 0/0. Its limit is 1, or 1/2: say so, or take a series";
  Found("after 1 s without honey, the velocity", "m/s", double(end.velocity.z()))
      .not_a_number(message)
      .must_be(-4, 16 * few_roundings<Real>);
  Found("after 1 s without honey, the position", "m", double(end.position.z()))
      .not_a_number(message)
      .must_be(0, 16 * few_roundings<Real>);
}

EXERCISE_CHECK("In thin air no digit is lost") {
  const double h = 2, a = -8;
  // Velocity and position after a step from rest.
  const auto from_rest = [&](double z) {
    const auto end = stepped(bead<Real>(0, a), z / h, h, 1);
    // The series of (1 - e^(-z))/z and 2 (z - 1 + e^(-z))/z². Up to z = 2 the terms beyond are less
    // than 1e-13 of them, and where digits are counted, up to 1/16, none.
    double first = 1, second = 1;
    for (int n = 20; n >= 2; --n) first = 1 - z / n * first;
    for (int n = 20; n >= 3; --n) second = 1 - z / n * second;
    return std::array{Compared{double(end.velocity.z()), h * a * first},
                      Compared{double(end.position.z()), h * h / 2 * a * second}};
  };
  const auto worst_near = [&](double z, std::size_t which) {
    double worst = 0;
    for (int n = 0; n < 8; ++n)
      worst = std::max(worst, from_rest(double(Real(z * (1 + n / 11.0))))[which].off());
    return worst;
  };
  // Where a short series ends digits are in danger as well, so also at larger z.
  for (const int power : {20, 12, 8, 4}) {
    const double z = std::ldexp(1.0, -power), kept = std::exp(-z);
    const auto found = from_rest(z);
    const auto look = [&](const char* what, const char* unit, std::size_t which) {
      const std::string where = "with k h = 2^-" + std::to_string(power) + ", the " + what;
      // The error of another formula grows with z, that of lost digits falls.
      if (found[which].off() > few_roundings<Real> &&
          worst_near(z, which) > 2 * worst_near(16 * z, which))
        fail(where + " is wrong by " + shown(found[which].off()) +
             " of itself, far more than rounding, and by less where k h is larger: it subtracts "
             "numbers that are nearly equal. expm1, or a few terms of a series, keep the digits");
      return Found(where, unit, found[which].found);
    };
    const auto [velocity, position] = found;
    look("velocity from rest", "m/s", 0)
        .mistake(h * a * kept, kicked_first)
        .mistake(h * a, damped_first)
        .must_be(velocity.truth, few_roundings<Real> * std::abs(velocity.truth));
    look("position from rest", "m", 1)
        .mistake(h * velocity.truth, moved_by_last)
        .mistake(h * velocity.truth / 2, moved_by_mean)
        .mistake(h * h / 2 * a, moved_by_parabola)
        .must_be(position.truth, few_roundings<Real> * std::abs(position.truth));
  }
}
