// From the particles to the tensor: the steps of the chapter's derivation, one by one.
#include <support/checks.hpp>
#include <support/particle_cloud.hpp>
#include <tumble/force.hpp>
#include <tumble/spheres.hpp>
#include <tumble/torque.hpp>
#include <tumble/validate_inertia.hpp>

using namespace tumble;
using namespace tumble::support;

TEST_CASE_TEMPLATE(
    "A particle resists turning by its mass times its squared distance from the axis", Real,
    EVERY_PRECISION) {
  const Mat3<Real> inertia = inertia_of_particle(Real(2), Vec3<Real>(3, 4, 5));
  Mat3<Real> by_hand;
  by_hand << 2 * (16 + 25), -2 * 3 * 4, -2 * 3 * 5,  //
      -2 * 3 * 4, 2 * (9 + 25), -2 * 4 * 5,          //
      -2 * 3 * 5, -2 * 4 * 5, 2 * (9 + 16);
  CHECK(same_bits(inertia, by_hand));  // small whole numbers: nothing rounds
}

TEST_CASE_TEMPLATE("A product of inertia is negative where x and y have the same sign", Real,
                   EVERY_PRECISION) {
  CHECK(inertia_of_particle(Real(1), Vec3<Real>(1, 1, 0))(0, 1) == -1);
  CHECK(inertia_of_particle(Real(1), Vec3<Real>(1, -1, 0))(0, 1) == 1);
}

TEST_CASE_TEMPLATE("A particle close to an axis keeps every digit of its small moment", Real,
                   EVERY_PRECISION) {
  // r² − x² would leave nothing of y² here: it is below a rounding of x².
  const Real y = std::ldexp(Real(1), -40);
  CHECK(inertia_of_particle(Real(1), Vec3<Real>(1, y, 0))(0, 0) == y * y);
}

TEST_CASE_TEMPLATE(
    "The kinetic energy of 1000 particles is that of their centre plus that of their turning", Real,
    EVERY_PRECISION) {
  const int count = 1000;
  RandomGenerator dice(1);
  std::vector<Particle<Real>> particles;
  for (int i = 0; i < count; ++i)
    particles.push_back(make_particle(Real(0.5 + dice()), dice.vector<Real>()));
  const MassProperties<Real> body = mass_properties(particles);
  const Vec3<Real> V(3, -1, 2), omega(Real(0.5), 4, -2);

  Real total = 0, cross_term = 0, cross_term_size = 0;
  for (Particle<Real>& particle : particles) {
    const Vec3<Real> r = particle.position - body.centre_of_mass;
    const Vec3<Real> turning = omega.cross(r);
    particle.velocity = V + turning;
    total += mass_of(particle) * particle.velocity.squaredNorm() / 2;
    cross_term += mass_of(particle) * V.dot(turning);
    cross_term_size += mass_of(particle) * V.norm() * turning.norm();
  }
  const Real of_the_centre = body.mass * V.squaredNorm() / 2;
  const Real of_the_turning = turning_energy(body.inertia, omega);
  // Each sum of 1000 terms rounds once a term, and a term or a tensor under 30 times.
  CHECK(std::abs(cross_term) <= (count + 30) * unit_roundoff<Real> * cross_term_size);
  CHECK(std::abs(total - (of_the_centre + of_the_turning)) <=
        2 * (count + 30) * unit_roundoff<Real> * (total + cross_term_size));
  CHECK(of_the_turning > total / 10);  // so that the lines above could tell
}

TEST_CASE_TEMPLATE(
    "Seen from another moving point the energy keeps a cross term, from a pivot it is all of "
    "turning",
    Real, EVERY_PRECISION) {
  const std::vector<Particle<Real>> particles = {make_particle(Real(1), {1, 0, 0}),
                                                 make_particle(Real(3), {2, 0, 0})};
  const Vec3<Real> V(0, 1, 0), omega(0, 0, 1);
  Real total = 0;
  for (const Particle<Real>& particle : particles)
    total += mass_of(particle) * (V + omega.cross(particle.position)).squaredNorm() / 2;
  const MassProperties<Real> body = mass_properties(particles);
  const Mat3<Real> about_origin = inertia_about(body, Vec3<Real>::Zero());
  // The cross term is V·(ω × Σ m r) = 1 (1·1 + 3·2) = 7 J.
  CHECK(std::abs(total - (4 * Real(0.5) + turning_energy(about_origin, omega)) - 7) <=
        40 * unit_roundoff<Real> * total);
  // A door on its hinge: the reference stands still, and the whole energy is that of turning.
  Real of_door = 0;
  for (const Particle<Real>& particle : particles)
    of_door += mass_of(particle) * omega.cross(particle.position).squaredNorm() / 2;
  CHECK(of_door == Real(6.5));  // (1 1² + 3 2²)/2
  CHECK(std::abs(of_door - turning_energy(about_origin, omega)) <=
        40 * unit_roundoff<Real> * of_door);
}

TEST_CASE_TEMPLATE(
    "The same off-centre push moves a sphere and a long box alike and turns them differently", Real,
    EVERY_PRECISION) {
  const Real mass = 2;
  const Vec3<Real> force(0, 3, 0), arm(Real(0.25), 0, 0);
  const MassProperties<Real> sphere = mass_properties(Sphere<Real>{Real(0.3)}, mass);
  const MassProperties<Real> box = mass_properties(Box<Real>{{2, Real(0.1), Real(0.1)}}, mass);

  const auto linear = [&](const MassProperties<Real>& body) {
    Particle<Real> centre = make_particle(body.mass);
    add_force(centre, force);
    step(centre, Real(1));
    return centre.velocity;
  };
  const auto angular = [&](const MassProperties<Real>& body) {
    const Vec3<Real> torque = torque_about(body.centre_of_mass, body.centre_of_mass + arm, force);
    return Vec3<Real>(inverse_inertia("body", body.inertia) * torque);
  };
  CHECK(same_bits(linear(sphere), linear(box)));
  // α = r F / I about z alone; I takes 6 roundings, its inverse and the product 6 more.
  const Real sphere_rate = Real(0.25) * 3 / (mass * 2 / 5 * Real(0.3) * Real(0.3));
  const Real box_rate = Real(0.25) * 3 / (mass / 12 * (4 + Real(0.1) * Real(0.1)));
  CHECK(std::abs(angular(sphere).z() - sphere_rate) <= 16 * unit_roundoff<Real> * sphere_rate);
  CHECK(std::abs(angular(box).z() - box_rate) <= 16 * unit_roundoff<Real> * box_rate);
  CHECK(angular(sphere).z() > 9 * angular(box).z());
}

TEST_CASE_TEMPLATE("A body of no particles, or of one that nothing can move, is refused", Real,
                   EVERY_PRECISION) {
  CHECK(complaint_of([] { mass_properties(std::vector<Particle<Real>>{}); }) ==
        "a body needs at least one particle");
  CHECK(complaint_of([] {
          mass_properties(
              std::vector{make_particle(Real(1)), make_static_particle(Vec3<Real>(1, 2, 3))});
        }) == "the mass of a particle is 0 kg; it must be greater than 0");
}
