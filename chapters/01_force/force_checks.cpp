#include <support/checks.hpp>
#include <tumble/force.hpp>
#include <vector>

using namespace tumble;
using namespace tumble::support;

TEST_CASE_TEMPLATE("Without force a particle coasts: its velocity never changes by a single bit",
                   Real, EVERY_PRECISION) {
  const Vec3<Real> start(1, 2, 3), velocity(Real(0.1), Real(-0.7), Real(12));
  const Real time_step = Real(1) / 60;
  Particle<Real> particle = make_particle(Real(2), start, velocity);
  const int steps = 10'000;
  for (int n = 0; n < steps; ++n) step(particle, time_step);

  CHECK(same_bits(particle.velocity, velocity));
  // Each step rounds h v once and the sum once; no component ever exceeds 2003 m.
  const Real bound = steps * unit_roundoff<Real> * 2 * 2003;
  CHECK(distance(particle.position, start + steps * time_step * velocity) <= bound);
}

TEST_CASE_TEMPLATE(
    "Far from the origin a slow particle stands still, and its velocity keeps every bit", Real,
    EVERY_PRECISION) {
  const Vec3<Real> velocity(Real(0.1), 0, 0);
  const Real time_step = Real(1) / 60;
  // From 32768 m on floats are 2^-8 m apart, and 2^-9 m is more than h v = 1/600 m. For any kind of
  // number that place is 2^(digits - 9) m; right below it the numbers lie twice as close.
  const Real far = std::ldexp(Real(1), std::numeric_limits<Real>::digits - 9);
  if (std::numeric_limits<Real>::digits == 24) CHECK(far == 32768);
  Particle<Real> there = make_particle(Real(1), Vec3<Real>(far, 0, 0), velocity);
  for (int n = 0; n < 1000; ++n) step(there, time_step);
  CHECK(same_bits(there.position, Vec3<Real>(far, 0, 0)));
  CHECK(same_bits(there.velocity, velocity));

  const Real before = std::nextafter(far, Real(0));
  Particle<Real> nearer = make_particle(Real(1), Vec3<Real>(before, 0, 0), velocity);
  step(nearer, time_step);
  CHECK(nearer.position.x() > before);
}

TEST_CASE_TEMPLATE(
    "Gravity as a force and as an acceleration give one motion, up to the roundings of both", Real,
    EVERY_PRECISION) {
  const Vec3<Real> gravity(0, 0, Real(-9.81));
  const Real time_step = Real(1) / 60;
  const int steps = 600;
  for (const Real mass : {Real(1e-6), Real(0.3), Real(7), Real(1e6)}) {
    CAPTURE(mass);
    Particle<Real> pulled = make_particle(mass);
    Particle<Real> accelerated = pulled;
    for (int n = 0; n < steps; ++n) {
      add_gravity(pulled, gravity);
      step(pulled, time_step);
      clear_force(pulled);

      accelerate(accelerated, gravity, time_step);
      step(accelerated, time_step);
    }
    // m = 1/(1/m) and the three products round once each, so an increment is off by 5 roundings at
    // most where the other is off by 1; both sums round once a step at a speed of at most 98.1 m/s.
    const Real speed = steps * time_step * Real(9.81);
    const Real bound = (5 + 1 + 2 * steps) * unit_roundoff<Real> * speed;
    CHECK(distance(pulled.velocity, accelerated.velocity) <= bound);
    // The position adds up h v: the error of the velocity for 10 s, and two more roundings a step
    // on each side.
    const Real height = speed * steps * time_step / 2 + speed * time_step;
    CHECK(distance(pulled.position, accelerated.position) <=
          bound * steps * time_step + 4 * steps * unit_roundoff<Real> * height);
  }
}

TEST_CASE_TEMPLATE("Under constant force the step leaves the parabola by exactly a h t / 2", Real,
                   EVERY_PRECISION) {
  const Real acceleration = Real(-9.81), upward = 12;
  for (const int steps_per_second : {10, 60, 240}) {
    CAPTURE(steps_per_second);
    const Real time_step = Real(1) / Real(steps_per_second);
    const int steps = 2 * steps_per_second;
    Particle<Real> ball = make_particle(Real(1), Vec3<Real>::Zero(), Vec3<Real>(0, 0, upward));
    add_force(ball, Vec3<Real>(0, 0, acceleration));
    for (int n = 0; n < steps; ++n) step(ball, time_step);

    const Real time = Real(steps) * time_step;
    const Real parabola = upward * time + acceleration * time * time / 2;
    const Real apart = acceleration * time_step * time / 2;
    // Speeds stay under 12 m/s and heights under 8 m. A velocity is off by two roundings a step,
    // which the position sums up over the time; a position by two roundings a step of its own.
    const Real bound = Real(steps) * unit_roundoff<Real> * (2 * 12 * time + 2 * 8);
    CHECK(std::abs(ball.position.z() - (parabola + apart)) <= bound);
    CHECK(std::abs(apart) > 10 * bound);  // so that the line above can tell
  }
  // With powers of two and small whole numbers nothing rounds, and "exactly" is meant to the bit.
  for (const int steps_per_second : {8, 64}) {
    const Real time_step = Real(1) / Real(steps_per_second), time = 2;
    Particle<Real> ball = make_particle(Real(1), Vec3<Real>::Zero(), Vec3<Real>(0, 0, upward));
    add_force(ball, Vec3<Real>(0, 0, -8));
    for (int n = 0; n < 2 * steps_per_second; ++n) step(ball, time_step);
    CHECK(ball.position.z() == upward * time - 8 * time * time / 2 - 8 * time_step * time / 2);
  }
}

TEST_CASE_TEMPLATE("Halving the time step halves the distance from the parabola", Real, float,
                   double) {
  const auto error = [](int steps_per_second) {
    const Real time_step = Real(1) / Real(steps_per_second);
    Particle<Real> ball = make_particle(Real(1));
    add_force(ball, Vec3<Real>(0, 0, 1));
    for (int n = 0; n < steps_per_second; ++n) step(ball, time_step);
    return ball.position.z() - Real(0.5);
  };
  // The exact ratio is 2. Powers of two as steps make every number here exact, in float too.
  CHECK(error(64) == 2 * error(128));
  CHECK(error(128) == 2 * error(256));
}

TEST_CASE_TEMPLATE("A static particle stays where it is under the largest finite force and gravity",
                   Real, EVERY_PRECISION) {
  const Real largest = std::numeric_limits<Real>::max();
  Particle<Real> wall = make_static_particle(Vec3<Real>(1, 2, 3));
  for (int n = 0; n < 100; ++n) {
    add_force(wall, Vec3<Real>(largest, -5, 0));
    for (const Real gravity : {Real(9.81), largest}) {
      add_gravity(wall, Vec3<Real>(0, 0, -gravity));
      accelerate(wall, Vec3<Real>(0, 0, -gravity), Real(0.1));
    }
    step(wall, Real(0.1));
    clear_force(wall);
  }
  CHECK(same_bits(wall.position, Vec3<Real>(1, 2, 3)));
  CHECK(same_bits(wall.velocity, Vec3<Real>::Zero()));
  CHECK(mass_of(wall) == 0);

  // The sum of two such forces is infinite, and 0 times infinity is NaN.
  for (int n = 0; n < 2; ++n) add_force(wall, Vec3<Real>(largest, 0, 0));
  CHECK(std::isinf(wall.force.x()));
  step(wall, Real(0.1));
  CHECK(std::isnan(wall.velocity.x()));
}

TEST_CASE_TEMPLATE("Twice the mass answers the same force with half the acceleration", Real,
                   EVERY_PRECISION) {
  Particle<Real> light = make_particle(Real(3)), heavy = make_particle(Real(6));
  for (Particle<Real>* particle : {&light, &heavy}) {
    add_force(*particle, Vec3<Real>(5, -7, 11));
    step(*particle, Real(0.25));
  }
  CHECK(same_bits(light.velocity, 2 * heavy.velocity));  // doubling is exact in binary
}

TEST_CASE_TEMPLATE("An acceleration gives every mass the same velocity, to the bit", Real,
                   EVERY_PRECISION) {
  const Vec3<Real> gravity(Real(0.1), Real(-0.2), Real(-9.81));
  const Real time_step = Real(1) / 60;
  for (const Real mass : {Real(1e-6), Real(0.3), Real(7), Real(1e6)}) {
    Particle<Real> particle = make_particle(mass);
    accelerate(particle, gravity, time_step);
    CHECK(same_bits(particle.velocity, time_step * gravity));
  }
}

TEST_CASE_TEMPLATE("Forces add up, and after clearing none is left", Real, EVERY_PRECISION) {
  Particle<Real> particle = make_particle(Real(2));
  add_force(particle, Vec3<Real>(1, 2, 3));
  add_force(particle, Vec3<Real>(10, 20, 30));
  CHECK(same_bits(particle.force, Vec3<Real>(11, 22, 33)));
  add_gravity(particle, Vec3<Real>(0, 0, -8));  // 2 kg: 16 N
  CHECK(same_bits(particle.force, Vec3<Real>(11, 22, 17)));
  clear_force(particle);
  CHECK(same_bits(particle.force, Vec3<Real>::Zero()));
}

TEST_CASE_TEMPLATE("Mass and force scaled by the same power of two give the same bits of motion",
                   Real, float, double) {
  const auto fly = [](Real scale) {
    Particle<Real> particle =
        make_particle(Real(0.7) * scale, Vec3<Real>(1, 2, 3), Vec3<Real>(4, 5, 6));
    for (int n = 0; n < 50; ++n) {
      add_force(particle, Vec3<Real>(Real(0.3), -2, Real(n)) * scale);
      add_gravity(particle, Vec3<Real>(0, 0, Real(-9.81)));
      step(particle, Real(1) / 60);
      clear_force(particle);
    }
    return particle.position;
  };
  for (const int exponent : {-40, -7, 13, 40})
    CHECK(same_bits(fly(std::ldexp(Real(1), exponent)), fly(1)));
}

TEST_CASE_TEMPLATE("A throw seen in a mirror is the mirrored throw, to the bit", Real,
                   EVERY_PRECISION) {
  const auto fly = [](const Vec3<Real>& mirror) {
    Particle<Real> particle = make_particle(Real(0.3), Vec3<Real>(1, 2, 3).cwiseProduct(mirror),
                                            Vec3<Real>(4, 5, 6).cwiseProduct(mirror));
    for (int n = 0; n < 50; ++n) {
      add_gravity(particle, Vec3<Real>(Real(0.1), Real(0.2), Real(-9.81)).cwiseProduct(mirror));
      step(particle, Real(1) / 60);
      clear_force(particle);
    }
    return Vec3<Real>(particle.position.cwiseProduct(mirror));
  };
  const Vec3<Real> unmirrored = fly(Vec3<Real>(1, 1, 1));
  CHECK(same_bits(fly(Vec3<Real>(-1, 1, 1)), unmirrored));
  CHECK(same_bits(fly(Vec3<Real>(1, -1, 1)), unmirrored));
  CHECK(same_bits(fly(Vec3<Real>(1, 1, -1)), unmirrored));
}

TEST_CASE_TEMPLATE(
    "Against a witness in long double a thousand steps round no more than their operations allow",
    Real, float, double) {
  const int steps = 1000;
  Particle<Real> particle = make_particle(Real(0.3), Vec3<Real>::Zero(), Vec3<Real>(3, 0, 4));
  // The witness starts from the rounded values, so that it differs by the rounding of the steps
  // alone.
  Particle<long double> witness = {.position = particle.position.template cast<long double>(),
                                   .velocity = particle.velocity.template cast<long double>(),
                                   .inverse_mass = particle.inverse_mass};
  const Vec3<Real> force(Real(-0.1), Real(0.2), Real(-1.5));
  const Real time_step = Real(1) / 64;
  add_force(particle, force);
  add_force(witness, force.template cast<long double>());
  for (int n = 0; n < steps; ++n) {
    step(particle, time_step);
    step(witness, time_step);
  }
  // |v| stays under 75 m/s and |x| under 560 m in each component. A velocity gains at most 3
  // roundings of its increment and one of its sum a step; a position sums that up for 16 s and adds
  // 2 of its own a step.
  const Real velocity_bound = 2 * steps * unit_roundoff<Real> * 75;
  const Real position_bound = velocity_bound * 16 + 2 * steps * unit_roundoff<Real> * 560;
  CHECK(distance(particle.velocity, witness.velocity.template cast<Real>()) <= velocity_bound);
  CHECK(distance(particle.position, witness.position.template cast<Real>()) <= position_bound);
}
