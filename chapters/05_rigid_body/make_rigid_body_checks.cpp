#include <numbers>
#include <support/bad_vectors.hpp>
#include <support/body_bounds.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

template <class Real>
MassProperties<Real> brick() {
  return mass_properties(Box<Real>{Vec3<Real>(1, 2, 3)}, 2);
}

}  // namespace

TEST_CASE_TEMPLATE("A made body has the shape's tensor, wherever and however its model stands",
                   Real, EVERY_PRECISION) {
  std::mt19937_64 generator(71);
  for (int trial = 0; trial < 100; ++trial) {
    // A slanted brick, off its model's origin.
    const Mat3<Real> slant = matrix_of(random_orientation<Real>(generator));
    const MassProperties<Real> model = moved(brick<Real>(), slant, random_vector<Real>(generator));
    const Pose<Real> pose{random_vector<Real>(generator), random_orientation<Real>(generator)};
    const ModelledBody<Real> made = make_rigid_body("slanted", model, pose);
    const Real largest = model.inertia.cwiseAbs().maxCoeff() * 3;

    CHECK(distance(made.body.centre.position, point_outward(pose, model.centre_of_mass)) <=
          2 * rotation_error<Real> * 2);
    // The tensor in the model's axes, turned into the world, is that of the body.
    const Mat3<Real> in_world = in_other_axes(model.inertia, matrix_of(pose.orientation));
    CHECK((world_inertia(made.body.top) - in_world).cwiseAbs().maxCoeff() <=
          8 * tensor_error<Real> * largest);
    CHECK(std::abs(mass_of(made.body.centre) - 2) <= 2 * 2 * unit_roundoff<Real>);
  }
}

TEST_CASE_TEMPLATE("A made body's model is drawn where it was put, and keeps its place in the body",
                   Real, EVERY_PRECISION) {
  std::mt19937_64 generator(72);
  for (int trial = 0; trial < 100; ++trial) {
    const Mat3<Real> slant = matrix_of(random_orientation<Real>(generator));
    const MassProperties<Real> model = moved(brick<Real>(), slant, random_vector<Real>(generator));
    const Pose<Real> pose{random_vector<Real>(generator), random_orientation<Real>(generator)};
    ModelledBody<Real> made = make_rigid_body("slanted", model, pose);
    // Three rotations of vectors under 2 m, and twice as many products of quaternions.
    const Real bound = 6 * rotation_error<Real> * 4;
    const Pose<Real> drawn = drawn_pose(made.body, made.model_in_body);
    CHECK(distance(drawn.position, pose.position) <= bound);
    CHECK(angle_between(drawn.orientation, pose.orientation) <= 2 * bound);

    // Wherever the body goes, the model's point that is its centre of mass goes with it.
    made.body.centre.position = random_vector<Real>(generator);
    made.body.top.orientation = random_orientation<Real>(generator);
    const Pose<Real> elsewhere = drawn_pose(made.body, made.model_in_body);
    CHECK(distance(point_outward(elsewhere, model.centre_of_mass), made.body.centre.position) <=
          bound);
  }
}

TEST_CASE_TEMPLATE("Poses compose like moves, and a pose and its inverse move nothing", Real,
                   EVERY_PRECISION) {
  std::mt19937_64 generator(73);
  for (int trial = 0; trial < 100; ++trial) {
    const Pose<Real> first{random_vector<Real>(generator), random_orientation<Real>(generator)},
        second{random_vector<Real>(generator), random_orientation<Real>(generator)};
    const Vec3<Real> point = random_vector<Real>(generator);
    const Real bound = 4 * rotation_error<Real> * 6;
    CHECK(distance(point_outward(composed(first, second), point),
                   point_outward(first, point_outward(second, point))) <= bound);
    CHECK(distance(point_inward(first, point_outward(first, point)), point) <= bound);
    CHECK(distance(point_outward(inverse(first), point_outward(first, point)), point) <= bound);
    CHECK(composed(first, inverse(first)).position.norm() <= bound);
  }
}

TEST_CASE_TEMPLATE("The two closest inverse moments come first, in right-handed axes", Real,
                   EVERY_PRECISION) {
  std::mt19937_64 generator(74);
  for (int trial = 0; trial < 100; ++trial) {
    const Vec3<Real> size =
        random_vector<Real>(generator).cwiseAbs() + Vec3<Real>::Constant(Real(0.01));
    const ModelledBody<Real> made = make_rigid_body("box", mass_properties(Box<Real>{size}, 1));
    const Vec3<Real>& i = made.body.top.inverse_moments;
    CHECK(std::abs(i(0) - i(1)) <= std::abs(i(1) - i(2)));
    CHECK(std::abs(i(0) - i(1)) <= std::abs(i(0) - i(2)));
    // A mirrored frame has no quaternion; the axes must still be those of the box.
    const Mat3<Real> tensor = world_inertia(made.body.top);
    const Mat3<Real> expected = mass_properties(Box<Real>{size}, 1).inertia;
    CHECK((tensor - expected).cwiseAbs().maxCoeff() <=
          2 * tensor_error<Real> * expected.maxCoeff());
  }
  CHECK(closest_pair_first(Vec3<Real>(9, 8, 1)) == std::array{0, 1, 2});
  CHECK(closest_pair_first(Vec3<Real>(9, 2, 1)) == std::array{1, 2, 0});
}

TEST_CASE_TEMPLATE("A made body moves and turns as asked", Real, EVERY_PRECISION) {
  std::mt19937_64 generator(75);
  const Vec3<Real> velocity(1, 2, 3), spin(Real(0.1), Real(0.2), Real(-0.7));
  const Pose<Real> pose{random_vector<Real>(generator), random_orientation<Real>(generator)};
  const RigidBody<Real> body = make_rigid_body("brick", brick<Real>(), pose, velocity, spin).body;
  CHECK(same_bits(body.centre.velocity, velocity));
  CHECK(distance(angular_velocity_world(body.top), spin) <= 3 * rotation_error<Real> * spin.norm());
}

TEST_CASE_TEMPLATE("A rod is refused, or locked about its own line when that is asked for", Real,
                   EVERY_PRECISION) {
  const MassProperties<Real> rod = mass_properties(ThinRod<Real>{2}, 3);  // along z, 1 kg m²
  CHECK(complaint_of([&] { make_rigid_body("rod", rod); }) ==
        "rod: the principal moments are (0, 1, 1) kg m^2; the first is zero as far as rounding can "
        "tell, and zero has no inverse; give the body some thickness");
  const Vec3<Real> none = Vec3<Real>::Zero();
  RigidBody<Real> body =
      make_rigid_body("rod", rod, {}, none, Vec3<Real>(1, 2, 0), Turning::locked_where_thin).body;
  CHECK(distance(angular_velocity_world(body.top), Vec3<Real>(1, 2, 0)) <=
        3 * rotation_error<Real> * 3);
  CHECK((body.top.inverse_moments.array() == 0).count() == 1);
  // A torque along the rod is borne; one across it turns the rod.
  const Vec3<Real> before = body.top.angular_momentum_body;
  add_angular_momentum(body.top, Vec3<Real>(0, 0, 5));
  CHECK(distance(body.top.angular_momentum_body, before) <= rotation_error<Real> * 5);
  add_angular_momentum(body.top, Vec3<Real>(5, 0, 0));
  CHECK(distance(angular_velocity_world(body.top), Vec3<Real>(6, 2, 0)) <=
        6 * rotation_error<Real> * 8);
  CHECK(complaint_of([&] {
          make_rigid_body("rod", rod, {}, none, Vec3<Real>(0, 0, 1), Turning::locked_where_thin);
        }) ==
        "rod: angular velocity is (0, 0, 1) rad/s; the body is locked about an axis that this "
        "turns about");
}

TEST_CASE_TEMPLATE("What rounding leaves of a slanted rod's zero moment is locked, never inverted",
                   Real, EVERY_PRECISION) {
  std::mt19937_64 generator(76);
  const MassProperties<Real> rod = mass_properties(ThinRod<Real>{2}, 3);  // along z, 1 kg m²
  bool was_rounded = false;
  for (int trial = 0; trial < 20; ++trial) {
    const Mat3<Real> slant = matrix_of(random_orientation<Real>(generator));
    const MassProperties<Real> model = moved(rod, slant, Vec3<Real>::Zero());
    was_rounded |= principal_axes(model.inertia).moments(0) > 0;
    const RigidBody<Real> body = make_rigid_body("rod", model, {}, Vec3<Real>::Zero(),
                                                 Vec3<Real>::Zero(), Turning::locked_where_thin)
                                     .body;
    CHECK((body.top.inverse_moments.array() == 0).count() == 1);
    // Across the rod the moments are 1; the turn and the way to the principal axes round them.
    CHECK(body.top.inverse_moments.maxCoeff() <= 1 + 4 * tensor_error<Real>);
  }
  CHECK(was_rounded);  // or nothing was checked
}

TEST_CASE_TEMPLATE("A point is refused, or locked about every axis when that is asked for", Real,
                   EVERY_PRECISION) {
  const MassProperties<Real> point{.mass = 3};
  CHECK(complaint_of([&] { make_rigid_body("point", point); }).find("zero has no inverse") !=
        std::string::npos);
  for (const Turning turning : {Turning::locked_where_thin, Turning::locked}) {
    RigidBody<Real> body =
        make_rigid_body("point", point, {}, Vec3<Real>::Zero(), Vec3<Real>::Zero(), turning).body;
    CHECK(same_bits(body.top.inverse_moments, Vec3<Real>::Zero()));
    apply_impulse_at(body, Vec3<Real>(3, 6, 9), Vec3<Real>(1, 0, 0));
    CHECK(distance(body.centre.velocity, Vec3<Real>(1, 2, 3)) <= 2 * 3 * unit_roundoff<Real>);
    CHECK(kinetic_energy(body.top) == 0);
  }
}

TEST_CASE_TEMPLATE("No torque turns a body about a locked axis, and one axis can be locked alone",
                   Real, EVERY_PRECISION) {
  RigidBody<Real> body = make_rigid_body("brick", brick<Real>(), {}, Vec3<Real>::Zero(),
                                         Vec3<Real>::Zero(), Turning::locked)
                             .body;
  add_angular_momentum(body.top, Vec3<Real>(1, 2, 3));
  CHECK(same_bits(angular_velocity_world(body.top), Vec3<Real>::Zero()));

  Top<Real> top{.angular_momentum_body = Vec3<Real>(4, 5, 6),
                .inverse_moments = Vec3<Real>(1, 2, 4)};
  lock_axis(top, 1);
  CHECK(same_bits(top.angular_momentum_body, Vec3<Real>(4, 0, 6)));
  add_angular_momentum(top, Vec3<Real>(1, 1, 1));
  CHECK(same_bits(angular_velocity_body(top), Vec3<Real>(5, 0, 28)));
  set_angular_velocity_world(top, Vec3<Real>(1, 1, 1));
  CHECK(same_bits(top.angular_momentum_body, Vec3<Real>(1, 0, Real(0.25))));
  set_angular_momentum_world(top, Vec3<Real>(1, 1, 1));
  CHECK(same_bits(top.angular_momentum_body, Vec3<Real>(1, 0, 1)));
  CHECK(same_bits(moments_of(top), Vec3<Real>(1, 0, Real(0.25))));
}

TEST_CASE_TEMPLATE("A body that cannot be is refused by name, value, unit and rule", Real,
                   EVERY_PRECISION) {
  const auto complaint = [](const MassProperties<Real>& properties, const Pose<Real>& pose = {},
                            const Vec3<Real>& velocity = Vec3<Real>::Zero(),
                            const Vec3<Real>& spin = Vec3<Real>::Zero()) {
    return complaint_of([&] { make_rigid_body("kite", properties, pose, velocity, spin); });
  };
  MassProperties<Real> impossible = brick<Real>();
  impossible.inertia.diagonal() = Vec3<Real>(1, 2, 4);
  CHECK(complaint(impossible)
            .find("kite: the principal moments are (1, 2, 4) kg m^2; no real body has these") == 0);
  // Not even where nothing is inverted.
  for (const Turning turning : {Turning::locked_where_thin, Turning::locked})
    CHECK(complaint_of([&] {
            make_rigid_body<Real>("kite", impossible, {}, Vec3<Real>::Zero(), Vec3<Real>::Zero(),
                                  turning);
          }).find("no real body has these") != std::string::npos);
  MassProperties<Real> skew = brick<Real>();
  skew.inertia(0, 1) = 1;
  CHECK(complaint(skew).find("kite: I_xy is 1 and I_yx is 0 kg m^2") == 0);
  MassProperties<Real> massless = brick<Real>();
  massless.mass = 0;
  CHECK(complaint(massless) == "kite: mass is 0 kg; it must be greater than 0");
  const Real huge = std::numeric_limits<Real>::max();
  MassProperties<Real> heavy = brick<Real>();
  heavy.mass = huge;  // its inverse is below the normal numbers
  CHECK(complaint(heavy).find("kite: mass is ") == 0);
  using Vector = Vec3<Real>;
  check_refuses_bad_vectors<Real>("kite: centre of mass", "m", [](const Vector& bad) {
    MassProperties<Real> lost = brick<Real>();
    lost.centre_of_mass = bad;
    make_rigid_body("kite", lost);
  });
  check_refuses_bad_vectors<Real>("kite: position", "m", [](const Vector& bad) {
    make_rigid_body("kite", brick<Real>(), {.position = bad});
  });
  MassProperties<Real> far = brick<Real>();
  far.centre_of_mass.x() = huge;  // and the model as far again from the world's origin
  const std::string too_far = complaint(far, {.position = far.centre_of_mass});
  CHECK(too_far.find("kite: centre of mass in the world is (inf, ") == 0);
  CHECK(too_far.find(") m; every component must be finite") != std::string::npos);
  CHECK(complaint(brick<Real>(), {.orientation = {.real = 0}})
            .find("kite: orientation is (0, 0, 0, 0)") == 0);
  CHECK(complaint(brick<Real>(), {.orientation = {.real = 2}})
            .find("kite: orientation is (2, 0, 0, 0)") == 0);
  check_refuses_bad_vectors<Real>("kite: velocity", "m/s", [](const Vector& bad) {
    make_rigid_body<Real>("kite", brick<Real>(), {}, bad);
  });
  check_refuses_bad_vectors<Real>("kite: angular velocity", "rad/s", [](const Vector& bad) {
    make_rigid_body<Real>("kite", brick<Real>(), {}, Vector::Zero(), bad);
  });
  // About x its moment is more than 1 kg m², so that the momentum leaves the range.
  const std::string too_much = complaint(brick<Real>(), {}, Vector::Zero(), Vector(huge, 0, 0));
  CHECK(too_much.find("kite: angular momentum is (") == 0);
  CHECK(too_much.find(") kg m^2/s; every component must be finite") != std::string::npos);
  check_refuses_bad_vectors<Real>("wall: position", "m", [](const Vector& bad) {
    make_static_body<Real>("wall", {.position = bad});
  });
}

TEST_CASE_TEMPLATE("A spin about a locked axis is refused from 64 roundings of it on", Real,
                   EVERY_PRECISION) {
  const MassProperties<Real> rod = mass_properties(ThinRod<Real>{2}, 3);  // along z
  const auto complaint = [&](Real roundings) {
    return complaint_of([&] {
      make_rigid_body("rod", rod, {}, Vec3<Real>::Zero(),
                      Vec3<Real>(1, 0, roundings * unit_roundoff<Real>),
                      Turning::locked_where_thin);
    });
  };
  CHECK(complaint(60) == "nothing thrown");
  CHECK(complaint(70) == "rod: angular velocity is " +
                             text_of(Vec3<Real>(1, 0, 70 * unit_roundoff<Real>)) +
                             " rad/s; the body is locked about an axis that this turns about");
}

TEST_CASE_TEMPLATE(
    "A locked axis goes with the body: it is the turned rod's line that can't be spun about", Real,
    EVERY_PRECISION) {
  const MassProperties<Real> rod = mass_properties(ThinRod<Real>{2}, 3);  // along its model's z
  // A quarter turn about y lays it along the world's x.
  const Pose<Real> lying{.orientation =
                             quaternion_about(Vec3<Real>(0, 1, 0), std::numbers::pi_v<Real> / 2)};
  const auto complaint = [&](const Vec3<Real>& spin) {
    return complaint_of([&] {
      make_rigid_body("rod", rod, lying, Vec3<Real>::Zero(), spin, Turning::locked_where_thin);
    });
  };
  CHECK(complaint({0, 0, 1}) == "nothing thrown");
  CHECK(complaint({0, 1, 0}) == "nothing thrown");
  CHECK(complaint({1, 0, 0}).find("the body is locked about an axis") != std::string::npos);
}

TEST_CASE_TEMPLATE("A moment too small to invert is refused, also where thin axes may be locked",
                   Real, EVERY_PRECISION) {
  MassProperties<Real> speck{.mass = 1};
  // A quarter of the smallest normal number: not zero, but 1 by it is infinite.
  speck.inertia.diagonal().setConstant(std::numeric_limits<Real>::min() / 4);
  const std::string complaint = complaint_of([&] {
    make_rigid_body("speck", speck, {}, Vec3<Real>::Zero(), Vec3<Real>::Zero(),
                    Turning::locked_where_thin);
  });
  CHECK(complaint.find("speck: principal moment is ") == 0);
  CHECK(complaint.find(" kg m^2; it must lie between ") != std::string::npos);
}

TEST_CASE_TEMPLATE("A static body stands as it was put, with a quaternion of norm 1", Real,
                   EVERY_PRECISION) {
  const Quaternion<Real> turn = quaternion_about(Vec3<Real>(1, -2, 3), Real(2));
  const Vec3<Real> place(4, 5, 6);
  // Typed to two digits: half a per cent too long.
  const Quaternion<Real> typed{Real(1.005) * turn.real, Real(1.005) * turn.imaginary};
  const RigidBody<Real> wall = make_static_body<Real>("wall", {place, typed});
  CHECK(same_bits(wall.centre.position, place));
  CHECK(distance(wall.top.orientation, turn) <= 16 * unit_roundoff<Real>);
  CHECK(std::abs(norm(checked_pose<Real>({place, typed}, "wall").orientation) - 1) <=
        8 * unit_roundoff<Real>);
}

TEST_CASE_TEMPLATE("Whether an axis is thin depends on its moments' ratio, not on their unit", Real,
                   EVERY_PRECISION) {
  // The same body, measured in units far apart: none of its moments is thin.
  for (const Real unit : {std::ldexp(Real(1), -30), Real(1), std::ldexp(Real(1), 30)}) {
    const Mat3<Real> inertia = unit * Vec3<Real>(std::ldexp(Real(1), -10), 1, 1).asDiagonal();
    const Vec3<Real> inverse =
        free_inverse_moments("body", inertia, principal_axes(inertia), Turning::locked_where_thin);
    CHECK(same_bits(Vec3<Real>(unit * inverse), Vec3<Real>(1024, 1, 1)));
  }
}

TEST_CASE_TEMPLATE(
    "A moment whose inverse is not a normal number is refused where thin axes are locked", Real,
    EVERY_PRECISION) {
  const Real smallest = std::numeric_limits<Real>::min();
  const auto complaint = [&](Real moment) {
    const Mat3<Real> inertia = moment * Mat3<Real>::Identity();
    return complaint_of([&] {
      free_inverse_moments("body", inertia, principal_axes(inertia), Turning::locked_where_thin);
    });
  };
  CHECK(complaint(1 / smallest) == "nothing thrown");
  CHECK(complaint(Real(1.5) / smallest) == "body: principal moment is " +
                                               text_of(Real(1.5) / smallest) +
                                               " kg m^2; it must lie between " + text_of(smallest) +
                                               " and " + text_of(1 / smallest) + " kg m^2");
}

TEST_CASE_TEMPLATE("How much of a spin may be about a locked axis grows with the spin", Real,
                   EVERY_PRECISION) {
  Top<Real> rod;
  rod.inverse_moments = {1, 1, 0};
  const auto complaint = [&](Real spin, Real roundings) {
    const Vec3<Real> w(spin, 0, spin * roundings * unit_roundoff<Real>);
    return complaint_of([&] { set_checked_angular_velocity("rod", rod, w); });
  };
  for (const Real spin : {Real(0.25), Real(1), Real(1024)}) {
    CHECK(complaint(spin, 63) == "nothing thrown");
    CHECK(complaint(spin, Real(64.5)).find("locked about an axis") != std::string::npos);
  }
}
