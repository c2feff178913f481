#include <numbers>
#include <support/body_bounds.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

/// Moments that differ, about axes that coincide with the world's before any turn.
template <class Real>
Top<Real> plain_top() {
  return {.inverse_moments = Vec3<Real>(1, Real(0.5), Real(0.125))};
}

template <class Real>
Quaternion<Real> quarter_turn(const Vec3<Real>& axis) {
  return quaternion_about(axis, std::numbers::pi_v<Real> / 2);
}

}  // namespace

TEST_CASE_TEMPLATE("Turn a body by 90 degrees and its tensor in world axes turns with it", Real,
                   EVERY_PRECISION) {
  Top<Real> top = plain_top<Real>();
  const Mat3<Real> before = world_inertia(top);
  CHECK(before.diagonal() == Vec3<Real>(1, 2, 8));
  top.orientation = quarter_turn(Vec3<Real>(0, 0, 1));
  const Mat3<Real> after = world_inertia(top);
  // About z: what was along x is along y now, and the other way round.
  const Mat3<Real> expected = Vec3<Real>(2, 1, 8).asDiagonal();
  CHECK((after - expected).cwiseAbs().maxCoeff() <= tensor_error<Real> * 8);
  top.orientation = quarter_turn(Vec3<Real>(1, 0, 0));
  const Mat3<Real> about_x = Vec3<Real>(1, 8, 2).asDiagonal();
  CHECK((world_inertia(top) - about_x).cwiseAbs().maxCoeff() <= tensor_error<Real> * 8);
}

TEST_CASE_TEMPLATE(
    "A turn about a principal axis changes the world tensor unless the other two moments are equal",
    Real, EVERY_PRECISION) {
  for (int axis = 0; axis < 3; ++axis) {
    // A brick, which looks the same after half a turn about each of its axes, and a square prism.
    Top<Real> brick = plain_top<Real>(), prism = plain_top<Real>();
    prism.inverse_moments = Vec3<Real>::Constant(Real(0.5));
    prism.inverse_moments[axis] = Real(0.125);
    const Mat3<Real> brick_before = world_inertia(brick), prism_before = world_inertia(prism);
    for (Top<Real>* top : {&brick, &prism})
      top->orientation = quaternion_about<Real>(Vec3<Real>::Unit(axis), Real(0.7));
    CHECK((world_inertia(prism) - prism_before).cwiseAbs().maxCoeff() <= tensor_error<Real> * 8);
    CHECK((world_inertia(brick) - brick_before).cwiseAbs().maxCoeff() > Real(0.4));
  }
}

TEST_CASE_TEMPLATE("After a turn by 90 degrees the same world torque gets another answer", Real,
                   EVERY_PRECISION) {
  Top<Real> top = plain_top<Real>();
  const Vec3<Real> torque(4, 0, 0);
  CHECK(same_bits(inverse_inertia_times(top, torque), Vec3<Real>(4, 0, 0)));
  top.orientation = quarter_turn(Vec3<Real>(0, 0, 1));
  CHECK(distance(inverse_inertia_times(top, torque), Vec3<Real>(2, 0, 0)) <=
        2 * rotation_error<Real> * 4);
  top.orientation = quarter_turn(Vec3<Real>(0, 1, 0));
  CHECK(distance(inverse_inertia_times(top, torque), Vec3<Real>(Real(0.5), 0, 0)) <=
        2 * rotation_error<Real> * 4);
}

TEST_CASE_TEMPLATE("At 45 degrees a torque about one axis is answered about another as well", Real,
                   EVERY_PRECISION) {
  Top<Real> top = plain_top<Real>();
  top.orientation = quaternion_about(Vec3<Real>(0, 0, 1), std::numbers::pi_v<Real> / 4);
  // With c = s = 1/√2: α = c² (1 + 0.5), and across s c (1 − 0.5).
  CHECK(distance(inverse_inertia_times(top, Vec3<Real>(1, 0, 0)),
                 Vec3<Real>(Real(0.75), Real(0.25), 0)) <= 2 * rotation_error<Real>);
}

TEST_CASE_TEMPLATE("Rotating in, dividing and rotating out is what the world tensor does", Real,
                   EVERY_PRECISION) {
  std::mt19937_64 generator(51);
  for (int trial = 0; trial < 200; ++trial) {
    const Top<Real> top = random_brick<Real>(generator).top;
    const Vec3<Real> vector = random_vector<Real>(generator);
    const Real largest = top.inverse_moments.maxCoeff();
    const Real bound =
        (2 * rotation_error<Real> + 3 * (tensor_error<Real> + 3 * unit_roundoff<Real>)) * largest *
        vector.norm();
    CHECK(distance<Real>(inverse_inertia_times(top, vector), world_inverse_inertia(top) * vector) <=
          bound);
  }
}

TEST_CASE_TEMPLATE("The world tensor and the inverse world tensor undo each other", Real,
                   EVERY_PRECISION) {
  std::mt19937_64 generator(52);
  for (int trial = 0; trial < 200; ++trial) {
    const Top<Real> top = random_brick<Real>(generator).top;
    const Mat3<Real> product = world_inertia(top) * world_inverse_inertia(top);
    const Real condition = top.inverse_moments.maxCoeff() / top.inverse_moments.minCoeff();
    // Each tensor's error meets the whole of the other, in three products of each element.
    const Real bound = 3 * (2 * tensor_error<Real> + 3 * unit_roundoff<Real>)*condition;
    CHECK((product - Mat3<Real>::Identity()).cwiseAbs().maxCoeff() <= bound);
  }
}

TEST_CASE_TEMPLATE("The angular velocity that was set is the one that is read, in both frames",
                   Real, EVERY_PRECISION) {
  std::mt19937_64 generator(53);
  for (int trial = 0; trial < 200; ++trial) {
    Top<Real> top = random_brick<Real>(generator).top;
    const Vec3<Real> spin = random_vector<Real>(generator);
    set_angular_velocity_world(top, spin);
    // In and out, and a moment times its inverse: 3 roundings more.
    const Real bound = (2 * rotation_error<Real> + 3 * unit_roundoff<Real>)*spin.norm();
    CHECK(distance(angular_velocity_world(top), spin) <= bound);
    set_angular_velocity_body(top, spin);
    CHECK(distance(angular_velocity_body(top), spin) <= 3 * unit_roundoff<Real> * spin.norm());
    CHECK(distance<Real>(angular_velocity_world(top), matrix_of(top.orientation) * spin) <=
          (rotation_error<Real> + 2 * 16 * unit_roundoff<Real>)*spin.norm());
  }
}

TEST_CASE_TEMPLATE("The angular momentum is the world tensor times the angular velocity", Real,
                   EVERY_PRECISION) {
  std::mt19937_64 generator(54);
  for (int trial = 0; trial < 200; ++trial) {
    Top<Real> top = random_brick<Real>(generator).top;
    const Vec3<Real> by_tensor = world_inertia(top) * angular_velocity_world(top);
    const Real largest = 1 / top.inverse_moments.minCoeff();
    const Real bound =
        (2 * rotation_error<Real> + 3 * (tensor_error<Real> + 3 * unit_roundoff<Real>)) * largest *
        angular_velocity_body(top).norm();
    CHECK(distance(angular_momentum_world(top), by_tensor) <= bound);
    const Vec3<Real> momentum_before = angular_momentum_world(top);
    set_angular_momentum_world(top, momentum_before);
    CHECK(distance(angular_momentum_world(top), momentum_before) <=
          2 * rotation_error<Real> * momentum_before.norm());
  }
}

TEST_CASE_TEMPLATE("The tensor of a ball or a cube is the same in every frame", Real,
                   EVERY_PRECISION) {
  std::mt19937_64 generator(55);
  for (const MassProperties<Real>& shape : {mass_properties(Sphere<Real>{Real(0.5)}, 3),
                                            mass_properties(Box<Real>{Vec3<Real>(1, 1, 1)}, 3)}) {
    const Top<Real> top =
        make_rigid_body("round", shape, {.orientation = random_orientation<Real>(generator)})
            .body.top;
    const Mat3<Real> unturned = moments_of(top).asDiagonal();
    CHECK((world_inertia(top) - unturned).cwiseAbs().maxCoeff() <=
          tensor_error<Real> * unturned.maxCoeff());
  }
}
