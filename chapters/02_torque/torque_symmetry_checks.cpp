#include <support/bad_vectors.hpp>
#include <tumble/torque.hpp>

using namespace tumble;
using namespace tumble::support;

TEST_CASE_TEMPLATE(
    "In a mirror the torque keeps its sign along the mirrored axis and changes it along the other "
    "two",
    Real, EVERY_PRECISION) {
  const Vec3<Real> centre(Real(0.1), Real(0.2), Real(0.3)), point(Real(1.7), Real(-2.9), Real(0.4)),
      force(Real(3.3), Real(0.7), Real(-5.1));
  const Vec3<Real> torque = torque_about(centre, point, force);
  for (int axis = 0; axis < 3; ++axis) {
    Vec3<Real> mirror(1, 1, 1);
    mirror[axis] = -1;
    const Vec3<Real> mirrored = torque_about<Real>(
        centre.cwiseProduct(mirror), point.cwiseProduct(mirror), force.cwiseProduct(mirror));
    // Torque has a handedness: it does not mirror as positions do, but with the opposite sign.
    CHECK(same_bits(mirrored, -torque.cwiseProduct(mirror)));
  }
}

TEST_CASE_TEMPLATE("Turning the whole scene by 90 degrees turns the torque with it, to the bit",
                   Real, EVERY_PRECISION) {
  const Vec3<Real> centre(Real(0.1), Real(0.2), Real(0.3)), point(Real(1.7), Real(-2.9), Real(0.4)),
      force(Real(3.3), Real(0.7), Real(-5.1));
  const auto turned = [](const Vec3<Real>& v) { return Vec3<Real>(-v.y(), v.x(), v.z()); };
  CHECK(same_bits(torque_about(turned(centre), turned(point), turned(force)),
                  turned(torque_about(centre, point, force))));
}

TEST_CASE_TEMPLATE(
    "A force at an exact place has the same torque far from the origin as near it, to the bit",
    Real, float, double) {
  // Coordinates are multiples of 1/64, exact here and there: only the formula can lose digits.
  const Vec3<Real> centre(Real(0.25), Real(-0.5), 1), arm(Real(0.5), Real(0.25), Real(-0.125)),
      force(Real(0.1), Real(-0.7), Real(0.3));
  for (const Real distance_from_origin : {Real(0), Real(1024), Real(65536)}) {
    const Vec3<Real> origin = distance_from_origin * Vec3<Real>(1, 1, 1);
    CHECK(same_bits(torque_about<Real>(origin + centre, origin + centre + arm, force),
                    arm.cross(force)));
  }
}

TEST_CASE_TEMPLATE(
    "A force, point or torque that is not finite is refused, and the wrench keeps its bits", Real,
    EVERY_PRECISION) {
  Wrench<Real> wrench;
  add_force_at(wrench, Vec3<Real>(1, 2, 3), Vec3<Real>(4, 5, 6));
  const Wrench<Real> before = wrench;
  const Vec3<Real> good(1, 1, 1);
  check_refuses_bad_vectors<Real>("force", "N",
                                  [&](const Vec3<Real>& bad) { add_force_at(wrench, bad, good); });
  check_refuses_bad_vectors<Real>("point", "m",
                                  [&](const Vec3<Real>& bad) { add_force_at(wrench, good, bad); });
  check_refuses_bad_vectors<Real>("torque", "N m",
                                  [&](const Vec3<Real>& bad) { add_couple(wrench, bad); });
  CHECK(same_bits(wrench.force, before.force));
  CHECK(same_bits(wrench.torque, before.torque));
}

TEST_CASE_TEMPLATE(
    "Against a witness in long double a torque rounds no more than its operations allow", Real,
    float, double) {
  const Vec3<Real> centre(Real(0.1), Real(0.2), Real(0.3)), point(Real(1.7), Real(-2.9), Real(0.4)),
      force(Real(3.3), Real(0.7), Real(-5.1));
  const auto exactly = [](const Vec3<Real>& v) { return v.template cast<long double>().eval(); };
  const Vec3<long double> witness = torque_about(exactly(centre), exactly(point), exactly(force));
  // One rounding in each arm component, one in each product, one in their difference.
  const Real bound = 3 * 2 * unit_roundoff<Real> * (point - centre).norm() * force.norm();
  CHECK(distance<long double>(exactly(torque_about(centre, point, force)), witness) <= bound);
}
