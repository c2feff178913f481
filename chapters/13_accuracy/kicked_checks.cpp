#include <support/exact_motion.hpp>
#include <support/orders.hpp>

using namespace tumble;
using namespace tumble::support;

TEST_CASE_TEMPLATE("Explicit Euler drifts with the velocity from before its kick", Real,
                   EVERY_PRECISION) {
  const auto orbit = eccentric_orbit<Real>();
  Particle<Real> particle = orbit.start;
  orbit.evaluate_forces(particle, 0);
  step_explicitly(particle, orbit.evaluate_forces, 0, Real(0.25));
  const Vec3<Real> there = orbit.start.position + Real(0.25) * orbit.start.velocity;
  CHECK(same_bits(particle.position, there));
  CHECK(particle.velocity != orbit.start.velocity);
}

TEST_CASE_TEMPLATE("Every step leaves the force and torque gathered for the time that it reaches",
                   Real, EVERY_PRECISION) {
  const auto orbit = eccentric_orbit<Real>();
  for (const auto& rung : motion_ladder<Real, Star<Real>>) {
    CAPTURE(std::string(rung.name));
    Particle<Real> particle = orbit.start;
    orbit.evaluate_forces(particle, 0);
    rung.step(particle, orbit.evaluate_forces, 0, Real(0.01));
    const Vec3<Real> left = particle.force;
    orbit.evaluate_forces(particle, Real(0.01));
    CHECK(same_bits(left, particle.force));
  }
  // And for a push that changes with time alone.
  const auto push = [](Particle<Real>& particle, Real time) {
    particle.force = {std::cos(2 * time), 0, 0};
  };
  for (const auto& rung : motion_ladder<Real, decltype(push)>) {
    CAPTURE(std::string(rung.name));
    Particle<Real> particle = orbit.start;
    push(particle, 1);
    rung.step(particle, push, 1, Real(0.125));
    CHECK(std::abs(particle.force.x() - std::cos(2 * Real(1.125))) <=
          100 * unit_roundoff<Real>);  // the time is a sum of portions
  }
  const auto driven = driven_top<Real>();
  for (const auto& rung : torque_ladder<Real, Drive<Real>>) {
    CAPTURE(std::string(rung.name));
    Top<Real> top = driven.start;
    driven.evaluate_forces(top, 1);
    rung.step(top, driven.evaluate_forces, 1, Real(0.125));
    const Vec3<Real> left = top.torque;
    driven.evaluate_forces(top, Real(1.125));
    CHECK(distance(left, top.torque) <=
          100 * unit_roundoff<Real>);  // the time is a sum of portions
  }
}

TEST_CASE_TEMPLATE("A heavy top that is kicked and drifted keeps L about the vertical", Real,
                   EVERY_PRECISION) {
  // A weight never turns anything about the vertical, and a drift keeps L.
  const auto problem = heavy_top<Real>("", 20);
  for (const auto& rung : torque_ladder<Real, Weight<Real>>) {
    if (rung.name.find("kick") != 0) continue;
    CAPTURE(std::string(rung.name));
    const auto end = problem.evaluate_forces.kept(exactly(after(problem, rung, 100)));
    const auto start = problem.evaluate_forces.kept(exactly(problem.start));
    const Wide off = std::abs(end.momentum.z() - start.momentum.z());
    CHECK(off <= 100 * 35 * 20 * unit_roundoff<Real> * start.momentum.z());
  }
}

TEST_CASE_TEMPLATE("The exact solution as a rung: many steps lead where one does", Real,
                   EVERY_PRECISION) {
  for (const auto& problem : free_problems<Real>()) {
    CAPTURE(problem.name);
    Top<Real> once = problem.start, often = once;
    turn_exactly(once, Real(1));
    for (int n = 0; n < 16; ++n) turn_exactly(often, Real(1) / 16);
    const auto truth = exactly_after(NoTorque<Wide>(), exactly(problem.start), Wide(1));
    // The solution claims 30 roundings, and again as many for each radian of the fastest spin.
    const Real fastest =
        std::sqrt(2 * kinetic_energy(problem.start) * problem.start.inverse_moments.maxCoeff());
    const Wide claim = 30 * (1 + fastest) * unit_roundoff<Real>;
    CHECK(difference(exactly(once), truth) <= claim);
    // Each of the 16 starts afresh from what the one before has rounded, which a flip spreads.
    CHECK(difference(exactly(often), truth) <= 16 * 16 * claim);
  }
}

TEST_CASE_TEMPLATE("On every rung of the torque ladder L about a locked axis stays 0", Real,
                   EVERY_PRECISION) {
  for (int axis = 0; axis < 3; ++axis) {
    auto driven = driven_top<Real>();
    lock_axis(driven.start, axis);
    for (const auto& rung : torque_ladder<Real, Drive<Real>>) {
      CAPTURE(std::string(rung.name));
      const Top<Real> top = after(driven, rung, 40);
      CHECK(top.angular_momentum_body[axis] == 0);
      CHECK(top.angular_momentum_body.norm() > Real(0.1));
    }
  }
}

TEST_CASE_TEMPLATE("Kick and drift takes the force of now, and then the velocity that it has made",
                   Real, EVERY_PRECISION) {
  const auto push = [](Particle<Real>& particle, Real time) { particle.force = {4 * time, 0, 0}; };
  Particle<Real> particle = make_particle<Real>(1, {1, 0, 0}, {2, 0, 0});
  push(particle, 3);
  step_by_kick_and_drift(particle, push, Real(3), Real(0.25));
  CHECK(particle.velocity.x() == 2 + 12 * Real(0.25));
  CHECK(particle.position.x() == 1 + 5 * Real(0.25));
  CHECK(particle.force.x() == 4 * Real(3.25));
}
