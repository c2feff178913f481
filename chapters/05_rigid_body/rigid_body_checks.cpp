#include <support/bad_vectors.hpp>
#include <support/body_bounds.hpp>

using namespace tumble;
using namespace tumble::support;

TEST_CASE_TEMPLATE("A force at a point adds chapter 1's force and chapter 2's torque", Real,
                   EVERY_PRECISION) {
  std::mt19937_64 generator(61);
  RigidBody<Real> body = random_brick<Real>(generator);
  Wrench<Real> wrench{.about = body.centre.position};
  for (int push = 0; push < 5; ++push) {
    const Vec3<Real> force = random_vector<Real>(generator), point = random_vector<Real>(generator);
    add_force_at(body, force, point);
    add_force_at(wrench, force, point);
  }
  CHECK(same_bits(body.centre.force, wrench.force));
  CHECK(same_bits(body.top.torque, wrench.torque));
  add_force(body, Vec3<Real>(1, 2, 3));
  CHECK(same_bits(body.centre.force, wrench.force + Vec3<Real>(1, 2, 3)));
  CHECK(same_bits(body.top.torque, wrench.torque));
  add_torque(body, Vec3<Real>(4, 5, 6));
  CHECK(same_bits(body.top.torque, wrench.torque + Vec3<Real>(4, 5, 6)));
  clear_forces(body);
  CHECK(same_bits(body.centre.force, Vec3<Real>::Zero()));
  CHECK(same_bits(body.top.torque, Vec3<Real>::Zero()));
}

TEST_CASE_TEMPLATE("A blow changes both momenta by what it carries", Real, EVERY_PRECISION) {
  std::mt19937_64 generator(62);
  for (int trial = 0; trial < 200; ++trial) {
    RigidBody<Real> body = random_brick<Real>(generator);
    const Vec3<Real> before = momentum(body), spin_before = angular_momentum_world(body.top);
    const Vec3<Real> about = random_vector<Real>(generator),
                     impulse = random_vector<Real>(generator),
                     point = random_vector<Real>(generator);
    const Vec3<Real> all_before = angular_momentum_about(body, about);
    apply_impulse_at(body, impulse, point);
    // A velocity of 2 at most takes up half the impulse: 3 roundings of the momentum 4, and those
    // of two products with the mass.
    CHECK(distance<Real>(momentum(body), before + impulse) <= 12 * unit_roundoff<Real> * 4);
    const Vec3<Real> arm = point - body.centre.position;
    // |L| stays under 8 + 12, with two rotations of it in and out.
    const Real bound = 3 * rotation_error<Real> * 20;
    CHECK(distance<Real>(angular_momentum_world(body.top), spin_before + arm.cross(impulse)) <=
          bound);
    // About any point the same: the torque of the blow about that point.
    CHECK(distance<Real>(angular_momentum_about(body, about),
                         all_before + (point - about).cross(impulse)) <=
          bound + 40 * unit_roundoff<Real> * 4 * 4);
  }
}

TEST_CASE_TEMPLATE("A blow's work is the impulse times the mean velocity of the point it strikes",
                   Real, EVERY_PRECISION) {
  std::mt19937_64 generator(63);
  for (int trial = 0; trial < 200; ++trial) {
    RigidBody<Real> body = random_brick<Real>(generator);
    const Vec3<Real> impulse = random_vector<Real>(generator),
                     point = random_vector<Real>(generator);
    const Real energy_before = kinetic_energy(body);
    const Vec3<Real> velocity_before = velocity_at(body, point);
    apply_impulse_at(body, impulse, point);
    const Real work = impulse.dot(velocity_before + velocity_at(body, point)) / 2;
    // ΔE = J · (v + v')/2, exactly. Velocities of the point stay under 2 + 12 · 4 m/s, energies
    // under 2 · 4 + 20 · 12 J; every one of them holds two rotations.
    const Real bound = 4 * rotation_error<Real> * 250;
    CHECK(std::abs(kinetic_energy(body) - energy_before - work) <= bound);
  }
}

TEST_CASE_TEMPLATE("The velocity at a point is that of a particle fixed to the body", Real, double,
                   long double) {
  std::mt19937_64 generator(64);
  for (int trial = 0; trial < 50; ++trial) {
    const RigidBody<Real> body = random_brick<Real>(generator);
    const Vec3<Real> in_body = random_vector<Real>(generator);
    // Where the particle is a short time before and after, by the turn about ω.
    const auto place = [&](Real time) -> Vec3<Real> {
      const Vec3<Real> turn = time * angular_velocity_world(body.top);
      const Pose<Real> pose{body.centre.position + time * body.centre.velocity,
                            quaternion_of_rotation_vector(turn) * body.top.orientation};
      return point_outward(pose, in_body);
    };
    const Real time = std::cbrt(unit_roundoff<Real>);
    const Vec3<Real> difference = (place(time) - place(-time)) / (2 * time);
    // The central difference leaves out ω³ r t²/6, with ω and r under √3, and rounds places of up
    // to 4 m by two rotations.
    const Real bound = time * time * 9 / 6 + 3 * rotation_error<Real> * 4 / time;
    CHECK(distance<Real>(velocity_at(body, place(0)), difference) <= bound);
  }
}

TEST_CASE_TEMPLATE("Energy and momenta are the sums over the particles of the body", Real, double,
                   long double) {
  std::mt19937_64 generator(65);
  std::vector<Particle<Real>> particles(20);
  for (Particle<Real>& particle : particles)
    particle = make_particle(Real(1) / 4, random_vector<Real>(generator));
  const Pose<Real> pose{random_vector<Real>(generator), random_orientation<Real>(generator)};
  const RigidBody<Real> body =
      make_rigid_body("cloud", mass_properties(particles), pose, random_vector<Real>(generator),
                      random_vector<Real>(generator))
          .body;
  const Vec3<Real> about = random_vector<Real>(generator);
  Real energy = 0;
  Vec3<Real> p = Vec3<Real>::Zero(), L = Vec3<Real>::Zero();
  for (const Particle<Real>& particle : particles) {
    const Vec3<Real> place = point_outward(pose, particle.position);
    const Vec3<Real> velocity = velocity_at(body, place);
    energy += velocity.squaredNorm() / 8;
    p += velocity / 4;
    L += (place - about).cross(velocity) / 4;
  }
  // 20 particles of speeds under 8 m/s and arms under 6 m, each holding up to six rotations; the
  // tensor's diagonalisation adds as much again.
  const Real each = 12 * rotation_error<Real>;
  CHECK(std::abs(kinetic_energy(body) - energy) <= 20 * each * 64 / 8);
  CHECK(distance(momentum(body), p) <= 20 * each * 8 / 4);
  CHECK(distance(angular_momentum_about(body, about), L) <= 20 * each * 6 * 8 / 4);
  CHECK(energy > 1);
}

TEST_CASE_TEMPLATE("A static body answers to no force, torque or blow", Real, EVERY_PRECISION) {
  RigidBody<Real> wall = make_static_body<Real>("wall", {.position = Vec3<Real>(1, 2, 3)});
  apply_impulse_at(wall, Vec3<Real>(4, 5, 6), Vec3<Real>(7, 8, 9));
  add_force_at(wall, Vec3<Real>(4, 5, 6), Vec3<Real>(7, 8, 9));
  CHECK(same_bits(velocity_at(wall, Vec3<Real>(1, 1, 1)), Vec3<Real>::Zero()));
  CHECK(same_bits(wall.top.angular_momentum_body, Vec3<Real>::Zero()));
  CHECK(same_bits(inverse_inertia_times(wall.top, wall.top.torque), Vec3<Real>::Zero()));
  CHECK(kinetic_energy(wall) == 0);
  CHECK(same_bits(momentum(wall), Vec3<Real>::Zero()));
  CHECK(same_bits(moments_of(wall.top), Vec3<Real>::Zero()));
}

TEST_CASE_TEMPLATE("Input that is not finite is refused, and the body keeps every bit", Real,
                   EVERY_PRECISION) {
  std::mt19937_64 generator(66);
  RigidBody<Real> body = random_brick<Real>(generator);
  const RigidBody<Real> before = body;
  using Vector = Vec3<Real>;
  const Vector good(1, 2, 3);
  check_refuses_bad_vectors<Real>("force", "N",
                                  [&](const Vector& bad) { add_force_at(body, bad, good); });
  check_refuses_bad_vectors<Real>("point", "m",
                                  [&](const Vector& bad) { add_force_at(body, good, bad); });
  check_refuses_bad_vectors<Real>("impulse", "N s",
                                  [&](const Vector& bad) { apply_impulse_at(body, bad, good); });
  check_refuses_bad_vectors<Real>("point", "m",
                                  [&](const Vector& bad) { apply_impulse_at(body, good, bad); });
  check_refuses_bad_vectors<Real>("torque", "N m",
                                  [&](const Vector& bad) { add_torque(body, bad); });
  check_refuses_bad_vectors<Real>("force", "N", [&](const Vector& bad) { add_force(body, bad); });
  CHECK(same_bits(body.centre.force, before.centre.force));
  CHECK(same_bits(body.centre.velocity, before.centre.velocity));
  CHECK(same_bits(body.top.torque, before.top.torque));
  CHECK(same_bits(body.top.angular_momentum_body, before.top.angular_momentum_body));
}

TEST_CASE_TEMPLATE("A push in a mirror turns the mirrored body the mirrored way, to the bit", Real,
                   EVERY_PRECISION) {
  const auto velocity_after_blow = [](const Vec3<Real>& mirror) -> Vec3<Real> {
    RigidBody<Real> body;
    body.centre = make_particle(Real(0.7), Vec3<Real>(1, 2, 3).cwiseProduct(mirror));
    body.top.inverse_moments = Vec3<Real>(Real(0.3), Real(0.9), Real(1.7));
    // A turn is mirrored as a torque is: its part along the mirrored axis keeps its sign.
    const Real handedness = mirror.prod();
    body.top.orientation = {
        .real = Real(0.5),
        .imaginary =
            handedness * Vec3<Real>(Real(0.1), Real(-0.7), Real(0.5)).cwiseProduct(mirror)};
    apply_impulse_at<Real>(body, Vec3<Real>(Real(0.1), Real(0.2), -4).cwiseProduct(mirror),
                           Vec3<Real>(3, Real(1.1), 2).cwiseProduct(mirror));
    return velocity_at<Real>(body, Vec3<Real>(0, 1, 2).cwiseProduct(mirror)).cwiseProduct(mirror);
  };
  const Vec3<Real> unmirrored = velocity_after_blow(Vec3<Real>(1, 1, 1));
  CHECK(same_bits(velocity_after_blow(Vec3<Real>(-1, 1, 1)), unmirrored));
  CHECK(same_bits(velocity_after_blow(Vec3<Real>(1, -1, 1)), unmirrored));
  CHECK(same_bits(velocity_after_blow(Vec3<Real>(1, 1, -1)), unmirrored));
}
