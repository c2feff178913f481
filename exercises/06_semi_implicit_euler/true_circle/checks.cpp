#include <exercise/judge.hpp>
#include <tumble/semi_implicit_euler.hpp>

using namespace tumble;
using namespace tumble::exercise;

namespace {

/// 4 kg on 16 N/m: ω = 2 rad/s.
template <class Real>
Particle<Real> weight(const Vec3<Same<Real>>& position, const Vec3<Same<Real>>& velocity,
                      Same<Real> mass = 4) {
  return make_particle<Real>(mass, position, velocity);
}

const int stiffness = 16;

template <class Real>
Particle<Real> stepped(Particle<Real> body, Same<Real> time_step, int steps = 1,
                       int spring = stiffness) {
  for (int n = 0; n < steps; ++n)
    body = ask<Particle<Real>>("symmetric_step", body, Real(spring), time_step);
  return body;
}

template <class Real>
Real kept(const Particle<Real>& body, Same<Real> time_step, int spring = stiffness) {
  return ask<Real>("kept", body, Real(spring), time_step);
}

template <class Real>
Real energy(const Particle<Real>& body) {
  return 2 * body.velocity.squaredNorm() + stiffness * body.position.squaredNorm() / 2;
}

/// The judge's own step, with an independent formula: (1 - c) x + h v and so on.
template <class Real>
Particle<Real> by_matrix(Particle<Real> body, Same<Real> h, int spring = stiffness) {
  const Real square = Real(spring) * body.inverse_mass, c = square * h * h / 2;
  const Vec3<Real> x = body.position, v = body.velocity;
  body.position = (1 - c) * x + h * v;
  body.velocity = (1 - c) * v - square * h * (1 - c / 2) * x;
  return body;
}

}  // namespace

EXERCISE_CHECK(
    "Half a kick, a drift, half a kick: with the force of the place where each half acts") {
  using Vector = Vec3<Real>;
  const auto start = weight<Real>(Vector(1, 0, Real(-0.5)), Vector(0, 2, 1));
  const Real h = Real(0.25);
  const auto truth = by_matrix(start, h), found = stepped(start, h);
  const Vector a = -Real(4) * start.position;
  const Vector drifted_late = start.position + h * (start.velocity + h * a);
  const Vector after_kick = start.velocity + h * a;
  Found("the place after a step of a quarter of a second", "m", found.position)
      .mistake(drifted_late, "the drift came after the whole kick. Only half of it comes before")
      .mistake(Vector(start.position + h * start.velocity), "the drift came before any kick")
      .must_be(truth.position, 16 * unit_roundoff<Real>);
  Found("the velocity after a step of a quarter of a second", "m/s", found.velocity)
      .mistake(after_kick,
               "both halves of the kick used the force of the place before the drift. The second "
               "half acts where the weight is by then")
      .mistake(Vector(start.velocity - Real(4) * h * truth.position),
               "both halves of the kick used the force of the place after the drift")
      .mistake(Vector(start.velocity + h * a - Real(4) * h / 2 * truth.position),
               "the second half kicked with the forces of both places: clear the first")
      .mistake(Vector(start.velocity + h / 2 * a), "the second half of the kick is missing")
      .must_be(truth.velocity, 32 * unit_roundoff<Real>);
  require(found.force.isZero(0), "the force " + shown(found.force) +
                                     " N is left behind. It would act again in the next step");
  // With 4 kg on 16 N/m the mass, ω² and the root of the stiffness are one number: so another.
  const auto other = weight<Real>(Vector(1, 0, Real(-0.5)), Vector(0, 2, 1), 2);
  const auto other_truth = by_matrix(other, h, 18), other_found = stepped(other, h, 1, 18);
  Found("the place of 2 kg on 18 N/m after a step of a quarter of a second", "m",
        other_found.position)
      .must_be(other_truth.position, 16 * unit_roundoff<Real>);
  Found("the velocity of 2 kg on 18 N/m after a step of a quarter of a second", "m/s",
        other_found.velocity)
      .must_be(other_truth.velocity, 32 * unit_roundoff<Real>);
}

EXERCISE_CHECK("Turn the velocity round, and the steps lead back to the start") {
  const auto start = weight<Real>(Vec3<Real>(1, 0, Real(-0.5)), Vec3<Real>(0, 2, 1));
  const int steps = 100;
  const Real h = Real(0.125);
  auto body = stepped(start, h, steps);
  require((body.position - start.position).norm() > Real(0.01),
          "after a hundred steps the weight is where it was. Does the step move it?");
  body.velocity = -body.velocity;
  body = stepped(body, h, steps);
  // Sixteen roundings of numbers below 4 a step, which the turning of the ellipse carries on.
  Found("the place after a hundred steps there and a hundred back", "m", body.position)
      .must_be(start.position, 2 * steps * 16 * 4 * unit_roundoff<Real>);
}

EXERCISE_CHECK("Half the step, a quarter of the error") {
  const double time = 3, w = 2;
  const auto miss = [&](int steps) {
    const auto body =
        stepped(weight<Real>(Vec3<Real>(1, 0, 0), Vec3<Real>(0, 0, 0)), Real(time / steps), steps);
    return double(body.position.x()) - std::cos(w * time);
  };
  const double coarse = miss(24), fine = miss(48);
  // The phase is off by ω² h²/24 of ω t; the next order changes the ratio by ω² h²/10, 0.6 %. In
  // float 48 steps round 16 times each, a hundredth of the finer error.
  Found("the error with 24 steps, divided by that with 48,", "", coarse / fine)
      .mistake(2,
               "half the step, half the error: first order. Something in the step isn't symmetric")
      .must_be(4, 0.1);
}

EXERCISE_CHECK(
    "What kept returns stays the same through a thousand steps, and becomes the energy as the step "
    "goes to zero") {
  auto body = weight<Real>(Vec3<Real>(1, 0, Real(-0.5)), Vec3<Real>(0, 2, 1));
  const Real at_zero = kept(body, 0);
  Found("what is kept for a step of no length", "J", at_zero)
      .mistake(energy(body) / 2, "a quarter of m v² + k x²: one half is too many")
      .mistake(energy(body) * 2, "that is m v² + k x²: the factor ½ is missing")
      .mistake(energy(body) / 4, "the mass, 4 kg, is missing")
      .must_be(energy(body), 16 * energy(body) * unit_roundoff<Real>);
  const Real h = Real(0.25);  // ω h = 1/2
  const Real start = kept(body, h), energy_there = energy(body);
  // Each step rounds x and v some sixteen times; the ellipse has the size of its energy. The last
  // roundings are those of kept() itself.
  const int steps = 1000;
  const double rounding = 4 * double(energy_there) * unit_roundoff<Real>;
  for (int n = 1; n <= steps; ++n) {
    body = by_matrix(body, h);
    const Real now = kept(body, h);
    if (std::abs(now - start) <= (16 * n + 16) * rounding) continue;
    const bool is_energy = std::abs(start - energy_there) <= 16 * rounding;
    fail(sentence("after ", n, " steps with ω h = 1/2 it is ", now, " J instead of ", start, " J. ",
                  is_energy ? "It is the energy, which this step does not keep: α differs from 1"
                            : "Put x' and v' into v² + α ω² x², and ask for the mixed term to "
                              "vanish"));
  }
  Found("what is kept after 64 steps of your own", "J",
        kept(stepped(weight<Real>(Vec3<Real>(1, 0, Real(-0.5)), Vec3<Real>(0, 2, 1)), h, 64), h))
      .must_be(start, (16 * 64 + 16) * rounding);
  // With 4 kg on 16 N/m the mass, ω² and the root of the stiffness are one number: so another.
  const auto other = weight<Real>(Vec3<Real>(1, 0, Real(-0.5)), Vec3<Real>(0, 2, 1), 2);
  const Real other_energy = other.velocity.squaredNorm() + 9 * other.position.squaredNorm();
  Found("what is kept of 2 kg on 18 N/m for a step of no length", "J", kept(other, 0, 18))
      .mistake(other_energy * Real(4.5), "ω², which is 9 here, stands where the mass belongs")
      .must_be(other_energy, 16 * double(other_energy) * unit_roundoff<Real>);
  Found("what is kept of 2 kg on 18 N/m after a step, less what was kept before it,", "J",
        kept(by_matrix(other, h, 18), h, 18) - kept(other, h, 18))
      .must_be(0, (16 + 16) * 4 * double(kept(other, 0, 18)) * unit_roundoff<Real>);
}
