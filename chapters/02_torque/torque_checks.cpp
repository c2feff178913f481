#include <random>
#include <support/checks.hpp>
#include <tumble/torque.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

/// Components between -1 and 1, the same sequence in every precision and on every machine.
template <class Real>
Vec3<Real> random_vector(std::mt19937_64& generator) {
  const auto component = [&generator] {
    return static_cast<Real>(std::ldexp(static_cast<double>(generator() >> 11), -52) - 1);
  };
  const Real x = component(), y = component(), z = component();
  return {x, y, z};
}

/// How much a torque may be off: an arm component rounds once, a product once and a difference of
/// two products once, so each component of r × F is off by 2·3 roundings of |r| |F| at most.
template <class Real>
Real torque_bound(const Vec3<Real>& arm, const Vec3<Real>& force) {
  return 6 * unit_roundoff<Real> * arm.norm() * force.norm();
}

}  // namespace

TEST_CASE_TEMPLATE("A push along y at a point on the x axis turns the body about plus z", Real,
                   EVERY_PRECISION) {
  const Vec3<Real> centre(5, 6, 7);
  const Vec3<Real> x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  CHECK(same_bits(torque_about(centre, centre + 2 * x, 3 * y), 6 * z));
  CHECK(same_bits(torque_about(centre, centre + 2 * y, 3 * z), 6 * x));
  CHECK(same_bits(torque_about(centre, centre + 2 * z, 3 * x), 6 * y));
  CHECK(same_bits(torque_about(centre, centre + 2 * y, 3 * x), -6 * z));
}

TEST_CASE_TEMPLATE(
    "A force at the centre of mass changes the velocity and leaves the torque as it was", Real,
    EVERY_PRECISION) {
  const Vec3<Real> centre(Real(0.1), Real(-7.3), Real(1000.7)), push(Real(12), Real(0.3), -4);
  Wrench<Real> wrench{.about = centre};
  add_couple(wrench, Vec3<Real>(5, 0, 1));
  add_couple(wrench, Vec3<Real>(-4, 2, 2));
  add_force_at(wrench, push, centre);
  CHECK(same_bits(wrench.torque, Vec3<Real>(1, 2, 3)));

  // The centre of mass moves as a particle that is pushed there, and the torque has no say in it.
  Particle<Real> body = make_particle(Real(2), centre), pushed = body;
  add_force(body, wrench.force);
  add_force(pushed, push);
  for (int n = 0; n < 3; ++n) {
    step(body, Real(0.5));
    step(pushed, Real(0.5));
  }
  CHECK(same_bits(body.velocity, 3 * push / 4));
  CHECK(same_bits(body.position, pushed.position));
}

TEST_CASE_TEMPLATE("Under a couple the centre of mass keeps its velocity", Real, EVERY_PRECISION) {
  const Vec3<Real> force(Real(0.1), -3, Real(7.7)), velocity(4, Real(-0.3), 2);
  Particle<Real> centre = make_particle(Real(2), Vec3<Real>(1, 2, 3), velocity);
  for (int n = 0; n < 10; ++n) {
    Wrench<Real> wrench{.about = centre.position};
    add_force_at<Real>(wrench, force, centre.position + Vec3<Real>(0, 1, 0));
    add_force_at<Real>(wrench, -force, centre.position - Vec3<Real>(0, 1, 0));
    CHECK(wrench.torque.norm() > 1);
    clear_force(centre);
    add_force(centre, wrench.force);
    step(centre, Real(0.125));
  }
  CHECK(same_bits(centre.velocity, velocity));
}

TEST_CASE_TEMPLATE("A couple has a torque, the same about every point, and no net force", Real,
                   EVERY_PRECISION) {
  std::mt19937_64 generator(2);
  for (int trial = 0; trial < 100; ++trial) {
    const Vec3<Real> force = random_vector<Real>(generator);
    const Vec3<Real> here = random_vector<Real>(generator), there = random_vector<Real>(generator);
    for (const Real distance_of_point : {Real(0), Real(1), Real(100)}) {
      Wrench<Real> wrench{.about = distance_of_point * random_vector<Real>(generator)};
      add_force_at(wrench, force, here);
      add_force_at(wrench, -force, there);
      CHECK(same_bits(wrench.force, Vec3<Real>::Zero()));
      // Two torques and their sum, with arms of up to 1 plus the distance.
      const Real arm = std::sqrt(Real(3)) * (1 + distance_of_point);
      const Real bound = (2 * 6 + 2 + 6) * unit_roundoff<Real> * arm * force.norm();
      CHECK(distance<Real>(wrench.torque, (here - there).cross(force)) <= bound);
    }
  }
}

TEST_CASE_TEMPLATE("A force slid along its own line keeps its torque", Real, EVERY_PRECISION) {
  std::mt19937_64 generator(3);
  for (int trial = 0; trial < 100; ++trial) {
    const Vec3<Real> centre = random_vector<Real>(generator),
                     point = random_vector<Real>(generator), force = random_vector<Real>(generator);
    const Vec3<Real> slid = point + Real(3) * force;
    // The point slid to is rounded: twice a component of at most 4, which the force multiplies.
    const Real bound = torque_bound<Real>(point - centre, force) +
                       torque_bound<Real>(slid - centre, force) +
                       2 * 2 * unit_roundoff<Real> * 4 * force.norm();
    CHECK(distance<Real>(torque_about(centre, point, force), torque_about(centre, slid, force)) <=
          bound);
  }
}

TEST_CASE_TEMPLATE("The size of a torque is the force times its distance from the centre", Real,
                   EVERY_PRECISION) {
  std::mt19937_64 generator(4);
  for (int trial = 0; trial < 100; ++trial) {
    const Vec3<Real> arm = random_vector<Real>(generator), force = random_vector<Real>(generator);
    const Vec3<Real> nearest = arm - force * (arm.dot(force) / force.squaredNorm());
    const Real expected = force.norm() * nearest.norm();
    // The foot of the perpendicular: a dot product and a square of 3 roundings each, a quotient, a
    // product and a difference; then two norms of 4 roundings and their product.
    const Real bound = (6 + 9 + 9) * unit_roundoff<Real> * arm.norm() * force.norm();
    const Vec3<Real> torque = torque_about<Real>(Vec3<Real>::Zero(), arm, force);
    CHECK(std::abs(torque.norm() - expected) <= bound);
  }
}

TEST_CASE_TEMPLATE("Torque times turning rate is the power that the force delivers at its point",
                   Real, EVERY_PRECISION) {
  std::mt19937_64 generator(5);
  for (int trial = 0; trial < 100; ++trial) {
    const Vec3<Real> arm = random_vector<Real>(generator), force = random_vector<Real>(generator),
                     angular_velocity = random_vector<Real>(generator);
    const Vec3<Real> velocity_of_point = angular_velocity.cross(arm);
    const Vec3<Real> torque = torque_about<Real>(Vec3<Real>::Zero(), arm, force);
    // Each side is a cross product (6 roundings) in a dot product (3 more in each of 3 terms).
    const Real bound =
        2 * (6 + 9) * unit_roundoff<Real> * arm.norm() * force.norm() * angular_velocity.norm();
    CHECK(std::abs(torque.dot(angular_velocity) - force.dot(velocity_of_point)) <= bound);
  }
}

TEST_CASE_TEMPLATE("A wrench taken about another point is what its forces give about that point",
                   Real, EVERY_PRECISION) {
  std::mt19937_64 generator(6);
  for (int trial = 0; trial < 100; ++trial) {
    const Vec3<Real> first = random_vector<Real>(generator),
                     second = random_vector<Real>(generator);
    Wrench<Real> about_first{.about = first}, about_second{.about = second};
    const int forces = 5;
    for (int n = 0; n < forces; ++n) {
      const Vec3<Real> force = random_vector<Real>(generator),
                       point = random_vector<Real>(generator);
      add_force_at(about_first, force, point);
      add_force_at(about_second, force, point);
    }
    const Wrench<Real> moved = taken_about(about_first, second);
    // Arms are at most 2√3 long and forces √3; five torques of 6 roundings and as many sums of up
    // to 5 torques on each side, one more torque of up to 5 forces for the move.
    const Real size = 2 * std::sqrt(Real(3)) * std::sqrt(Real(3));
    const Real bound =
        (2 * forces * (6 + forces) + 6 * forces + 2 * forces + forces) * unit_roundoff<Real> * size;
    CHECK(same_bits(moved.force, about_second.force));
    CHECK(same_bits(moved.about, second));
    CHECK(distance<Real>(moved.torque, about_second.torque) <= bound);
  }
}

TEST_CASE_TEMPLATE(
    "The point of a torque may be moved along the sum of the forces, and not across it", Real,
    EVERY_PRECISION) {
  // Two children on a seesaw, whose weights sum to 500 N downward. All numbers are exact.
  Wrench<Real> children;
  add_force_at(children, Vec3<Real>(0, 0, -300), Vec3<Real>(-1, 0, 0));
  add_force_at(children, Vec3<Real>(0, 0, -200), Vec3<Real>(Real(1.5), 0, 0));
  for (const Real above : {Real(-64), Real(0), Real(0.25), Real(3)}) {
    const auto torque_beside = [&](Real x, Real y) {
      return taken_about(children, Vec3<Real>(x, y, above)).torque;
    };
    CHECK(same_bits(torque_beside(0, 0), Vec3<Real>::Zero()));
    CHECK(same_bits(torque_beside(2, 0), Vec3<Real>(0, -1000, 0)));
    CHECK(same_bits(torque_beside(0, 2), Vec3<Real>(1000, 0, 0)));
  }
}

TEST_CASE_TEMPLATE("Forces in balance have the same torque about every point: none", Real,
                   EVERY_PRECISION) {
  // A seesaw: 30 kg at 1 m, 20 kg at 1.5 m, and the pivot that carries both. All numbers are exact.
  Wrench<Real> seesaw;
  add_force_at(seesaw, Vec3<Real>(0, 0, -300), Vec3<Real>(-1, 0, 0));
  add_force_at(seesaw, Vec3<Real>(0, 0, -200), Vec3<Real>(Real(1.5), 0, 0));
  add_force_at(seesaw, Vec3<Real>(0, 0, 500), Vec3<Real>(0, 0, 0));
  CHECK(same_bits(seesaw.force, Vec3<Real>::Zero()));
  for (const Real x : {Real(-1), Real(0), Real(1.5), Real(64)})
    CHECK(same_bits(taken_about(seesaw, Vec3<Real>(x, 0, 3)).torque, Vec3<Real>::Zero()));
}
