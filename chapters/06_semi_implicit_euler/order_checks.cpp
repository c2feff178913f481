#include <support/bad_vectors.hpp>
#include <support/body_bounds.hpp>
#include <tumble/semi_implicit_euler.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

/// A force that grows with the distance and bends: nothing about it is linear.
template <class Real>
void gather_pendulum(Particle<Real>& particle) {
  clear_force(particle);
  add_force(particle, Vec3<Real>(-std::sin(particle.position.x()), particle.position.z(),
                                 -particle.position.y()));
}

template <class Real>
Particle<Real> swinging() {
  return make_particle(Real(0.7), Vec3<Real>(1, Real(0.3), -2),
                       Vec3<Real>(Real(0.4), Real(-0.1), Real(0.2)));
}

}  // namespace

TEST_CASE_TEMPLATE("A step is the kick and then the drift, to the bit", Real, EVERY_PRECISION) {
  Particle<Real> stepped = swinging<Real>(), halves = swinging<Real>();
  for (int n = 0; n < 100; ++n) {
    gather_pendulum(stepped);
    gather_pendulum(halves);
    step(stepped, Real(0.1));
    const Vec3<Real> old_position = halves.position, old_velocity = halves.velocity;
    kick(halves, Real(0.1));
    CHECK(same_bits(halves.position, old_position));  // a kick moves nothing
    const Vec3<Real> new_velocity = halves.velocity;
    drift(halves, Real(0.1));
    CHECK(same_bits(halves.velocity, new_velocity));  // a drift speeds up nothing
    CHECK(same_bits(halves.position, old_position + Real(0.1) * new_velocity));
    CHECK_FALSE(same_bits(new_velocity, old_velocity));
    REQUIRE(same_bits(stepped.velocity, halves.velocity));
    REQUIRE(same_bits(stepped.position, halves.position));
  }
}

TEST_CASE_TEMPLATE("A rigid body's centre is kicked, hit and drifted as a particle is", Real,
                   EVERY_PRECISION) {
  std::mt19937_64 generator(6);
  RigidBody<Real> body = random_brick<Real>(generator);
  Particle<Real> particle = body.centre;
  const Top<Real> top = body.top;
  const Vec3<Real> force(3, -5, 7), impulse(1, 2, -3);
  for (Particle<Real>* centre : {&body.centre, &particle}) add_force(*centre, force);
  step(body.centre, Real(0.1));
  step(particle, Real(0.1));
  // A blow at the centre of mass is the same whether the body or its centre takes it.
  apply_impulse_at(body, impulse, body.centre.position);
  apply_impulse(particle, impulse);
  CHECK(same_bits(body.centre.position, particle.position));
  CHECK(same_bits(body.centre.velocity, particle.velocity));
  CHECK(same_bits(body.top.angular_momentum_body, top.angular_momentum_body));
  CHECK(same_bits(body.top.orientation.imaginary, top.orientation.imaginary));
}

TEST_CASE_TEMPLATE("Drift first with forces gathered after it is the same motion, to the bit", Real,
                   EVERY_PRECISION) {
  const Real time_step = Real(0.1);
  Particle<Real> kick_first = swinging<Real>();
  gather_pendulum(kick_first);
  Particle<Real> drift_first = kick_first;
  kick(drift_first, time_step);  // the head start: one half of a step
  for (int n = 0; n < 100; ++n) {
    gather_pendulum(kick_first);
    step(kick_first, time_step);
    drift(drift_first, time_step);
    REQUIRE(same_bits(drift_first.position, kick_first.position));
    gather_pendulum(drift_first);
    kick(drift_first, time_step);
  }
}

TEST_CASE_TEMPLATE(
    "Under constant gravity the velocity is linear in time and the place the exact sum", Real,
    EVERY_PRECISION) {
  const Vec3<Real> start(3, -2, 5), velocity(8, Real(-0.5), 10), gravity(0, 0, Real(-9.81));
  const Real time_step = Real(1) / 60;
  Particle<Real> semi = make_particle(Real(1), start, velocity), explicitly = semi;
  for (int n = 1; n <= 600; ++n) {
    for (Particle<Real>* ball : {&semi, &explicitly}) {
      clear_force(*ball);
      add_force(*ball, gravity);
    }
    step(semi, time_step);
    explicit_step(explicitly, time_step);
    const Real time = Real(n) * time_step;
    const Vec3<Real> parabola = start + velocity * time + gravity * (time * time / 2);
    const Vec3<Real> offset = gravity * (time_step * time / 2);
    // The speed stays under 98.1 m/s and the height under 491 m. A velocity rounds twice a step,
    // which the position sums up; so does the position. The formulas round some ten times.
    const Real velocity_bound = Real(2 * n + 4) * unit_roundoff<Real> * Real(98.1);
    const Real bound = velocity_bound * time + Real(2 * n + 10) * unit_roundoff<Real> * 491;
    REQUIRE(distance(semi.velocity, velocity + gravity * time) <= velocity_bound);
    REQUIRE(distance(explicitly.velocity, velocity + gravity * time) <= velocity_bound);
    REQUIRE(distance(semi.position, parabola + offset) <= bound);
    REQUIRE(distance(explicitly.position, parabola - offset) <= bound);
  }
}

TEST_CASE_TEMPLATE(
    "In free fall kick and drift loses m g^2 h t / 2 of energy, explicit Euler gains it", Real,
    EVERY_PRECISION) {
  const Real g = Real(9.81), time_step = Real(1) / 60, mass = 2;
  Particle<Real> semi = make_particle(mass, Vec3<Real>(0, 0, 5), Vec3<Real>(8, 0, 10)),
                 explicitly = semi;
  const auto energy = [&](const Particle<Real>& ball) {
    return mass * (ball.velocity.squaredNorm() / 2 + g * ball.position.z());
  };
  const Real start = energy(semi);
  for (int n = 1; n <= 600; ++n) {
    for (Particle<Real>* ball : {&semi, &explicitly}) {
      clear_force(*ball);
      add_gravity(*ball, Vec3<Real>(0, 0, -g));
    }
    step(semi, time_step);
    explicit_step(explicitly, time_step);
    const Real loss = mass * g * g * time_step * (Real(n) * time_step) / 2;
    // Up to 93 m/s and 390 m down, where either energy is under 8.8 kJ. A velocity rounds four
    // times a step and a position twice; both count in full, a velocity's also through the later
    // places.
    const Real speed_bound = Real(4 * n) * unit_roundoff<Real> * 93,
               place_bound =
                   speed_bound * Real(n) * time_step + Real(2 * n) * unit_roundoff<Real> * 390,
               bound = mass * (93 * speed_bound + g * place_bound) +
                       10 * unit_roundoff<Real> * Real(8.8e3);
    REQUIRE(std::abs(energy(semi) - (start - loss)) <= bound);
    REQUIRE(std::abs(energy(explicitly) - (start + loss)) <= bound);
    if (n == 600) CHECK(bound < loss / 2);
  }
}

TEST_CASE_TEMPLATE("Drifting and kicking back undoes a step", Real, EVERY_PRECISION) {
  const Real time_step = Real(0.1);
  const Particle<Real> start = swinging<Real>();
  Particle<Real> particle = start;
  const int steps = 50;
  for (int n = 0; n < steps; ++n) {
    gather_pendulum(particle);
    step(particle, time_step);
  }
  CHECK(distance(particle.position, start.position) > 1);
  for (int n = 0; n < steps; ++n) {
    drift(particle, -time_step);
    gather_pendulum(particle);
    kick(particle, -time_step);
  }
  // Each of the 100 steps rounds four times, numbers under 8. A difference grows on the way, by at
  // most exp(t √(k/m)) for a force that changes by k = 1 N/m over 0.7 kg during t = 5 s.
  const Real growth = std::exp(5 / std::sqrt(Real(0.7)));
  const Real bound = 2 * steps * 4 * 8 * unit_roundoff<Real> * growth;
  CHECK(distance(particle.position, start.position) <= bound);
  CHECK(distance(particle.velocity, start.velocity) <= bound);
}

TEST_CASE_TEMPLATE("An impulse between kick and drift holds a ball on the floor, to the bit", Real,
                   EVERY_PRECISION) {
  Particle<Real> ball = make_particle(Real(0.25));
  for (int n = 0; n < 1000; ++n) {
    clear_force(ball);
    add_force(ball, Vec3<Real>(0, 0, Real(-9.81) / 4));
    kick(ball, Real(1) / 60);
    apply_impulse(ball, -Real(0.25) * ball.velocity);
    drift(ball, Real(1) / 60);
    REQUIRE(same_bits(ball.position, Vec3<Real>::Zero()));
    REQUIRE(same_bits(ball.velocity, Vec3<Real>::Zero()));
  }
}

TEST_CASE_TEMPLATE("An impulse is a force times its time, and moves no static particle", Real,
                   EVERY_PRECISION) {
  const Vec3<Real> force(12, -5, 7);
  const Real time_step = Real(0.125);  // a power of two: h F is exact
  Particle<Real> forced = swinging<Real>(), hit = swinging<Real>();
  add_force(forced, force);
  kick(forced, time_step);
  apply_impulse(hit, time_step * force);
  CHECK(same_bits(forced.velocity, hit.velocity));
  CHECK(same_bits(hit.position, swinging<Real>().position));

  Particle<Real> wall = make_static_particle(Vec3<Real>(1, 2, 3));
  apply_impulse(wall, force);
  CHECK(same_bits(wall.velocity, Vec3<Real>::Zero()));

  const Vec3<Real> before = hit.velocity;
  check_refuses_bad_vectors<Real>("impulse", "N s",
                                  [&](const Vec3<Real>& bad) { apply_impulse(hit, bad); });
  CHECK(same_bits(hit.velocity, before));
}

TEST_CASE_TEMPLATE("A force that grows with time is stepped to b (t^3 - h^2 t) / 6 exactly", Real,
                   EVERY_PRECISION) {
  const Real growth = 3;  // b, m/s³
  const Real time_step = Real(1) / 64;
  Particle<Real> particle = make_particle(Real(1));
  for (int n = 1; n <= 256; ++n) {
    clear_force(particle);
    add_force(particle, Vec3<Real>(growth * Real(n - 1) * time_step, 0, 0));  // at the step's start
    step(particle, time_step);
    const Real time = Real(n) * time_step;
    const Real speed = growth * time * (time - time_step) / 2;
    const Real exact = growth * time * (time - time_step) * (time + time_step) / 6;
    // Speeds stay under 24 m/s and places under 32 m; two roundings a step and some in the formula.
    const Real bound = Real(2 * n + 8) * unit_roundoff<Real>;
    REQUIRE(std::abs(particle.velocity.x() - speed) <= bound * 24);
    REQUIRE(std::abs(particle.position.x() - exact) <= bound * (24 * time + 32));
  }
}

namespace {

/// Where a push of cos(t) newtons on 1 kg puts the particle after 2 s, against the exact place.
double error_of_changing_push(int steps_per_second, double head_start) {
  const double h = 1.0 / steps_per_second;
  Particled particle = make_particle(1.0);
  const auto push = [&particle](double time) {
    clear_force(particle);
    add_force(particle, Vec3d(std::cos(time), 0, 0));
  };
  push(0);
  kick(particle, head_start * h);
  for (int n = 0; n < 2 * steps_per_second; ++n) {
    push(n * h);
    step(particle, h);
  }
  return particle.position.x() - (1 - std::cos(2.0));
}

}  // namespace

TEST_CASE("Under a changing force the offset is h t / 2 times the first acceleration") {
  const auto rest = [](int steps_per_second) {
    const double first_acceleration = 1, offset = first_acceleration * 2 / (2.0 * steps_per_second);
    return error_of_changing_push(steps_per_second, 0) - offset;
  };
  // What is left is of second order: half the step leaves a quarter.
  for (const int steps_per_second : {32, 64, 128}) {
    const double ratio = rest(steps_per_second) / rest(2 * steps_per_second);
    CHECK(ratio > 3.9);
    CHECK(ratio < 4.1);
  }
}

TEST_CASE("A velocity started half a kick back makes the places second order") {
  for (const int steps_per_second : {32, 64, 128}) {
    const auto ratio = [steps_per_second](double head_start) {
      return error_of_changing_push(steps_per_second, head_start) /
             error_of_changing_push(2 * steps_per_second, head_start);
    };
    CHECK(ratio(0) > 1.9);
    CHECK(ratio(0) < 2.1);
    CHECK(ratio(-0.5) > 3.9);
    CHECK(ratio(-0.5) < 4.1);
  }
}

TEST_CASE_TEMPLATE("A blow leaves the forces of the step and the place as they are, to the bit",
                   Real, EVERY_PRECISION) {
  Particle<Real> particle = make_particle<Real>(2, {1, 2, 3});
  add_force<Real>(particle, {4, 5, 6});
  apply_impulse<Real>(particle, {8, -8, 2});
  CHECK(same_bits(particle.velocity, Vec3<Real>(4, -4, 1)));
  CHECK(same_bits(particle.force, Vec3<Real>(4, 5, 6)));
  CHECK(same_bits(particle.position, Vec3<Real>(1, 2, 3)));
}
