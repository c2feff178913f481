#include <numbers>
#include <support/checks.hpp>
#include <tumble/drawing.hpp>
#include <tumble/solids.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

/// A box whose model's origin is a corner, tumbling as it flies.
template <class Real>
ModelledBody<Real> flying_box() {
  const MassProperties<Real> box =
      moved(mass_properties(Box<Real>{{1, 2, 3}}, 2), Mat3<Real>::Identity(), {1, 1, 2});
  return make_rigid_body<Real>("box", box, {{1, 2, 3}, quaternion_about<Real>({1, 1, 0}, 1)},
                               {4, 5, 6}, {1, 2, -1});
}

/// True if no more lies between two poses than roundings: chapter 10 counts forty of numbers up to
/// π for the turn between two, and the composition turns an arm of 3 m by it, some 10 m away.
template <class Real>
bool is_near(const Pose<Real>& a, const Pose<Real>& b) {
  const Real turned = 48 * std::numbers::pi_v<Real> * unit_roundoff<Real>;
  return angle_between(a.orientation, b.orientation) <= turned &&
         distance(a.position, b.position) <= 3 * turned + 16 * 10 * unit_roundoff<Real>;
}

}  // namespace

TEST_CASE_TEMPLATE("A model is drawn by its handle, on the way between the last two steps", Real,
                   EVERY_PRECISION) {
  World<Real> world(steps_per_second(20));
  const ModelledBody<Real> made = flying_box<Real>();
  const BodyHandle box = world.add("box", made.body);
  const BodyHandle point = world.add("point", make_particle<Real>(1, {0, 0, 0}, {20, 0, 0}));
  Drawing<Real> drawing;
  drawing.set_model(box, made.model_in_body);
  drawing.note(world);
  const Pose<Real> start = drawn_pose(made.body, made.model_in_body);
  for (const Real fraction : {Real(0), Real(0.5), Real(1)})  // no step yet
    CHECK(is_near(drawing.pose(box, fraction), start));

  for (int n = 0; n < 3; ++n) {
    const RigidBody<Real> before = world.body(box);
    world.step();
    drawing.note(world);
    const RigidBody<Real> now = world.body(box);
    CHECK(is_near(drawing.pose(box, 1), drawn_pose(now, made.model_in_body)));
    CHECK(is_near(drawing.pose(box, 0), drawn_pose(before, made.model_in_body)));
    // In the middle the centre of mass is in the middle, wherever the corner is.
    const Pose<Real> middle = drawing.pose(box, Real(0.5));
    const Pose<Real> of_body = composed(middle, inverse(made.model_in_body));
    CHECK(distance<Real>(of_body.position, (before.centre.position + now.centre.position) / 2) <=
          500 * unit_roundoff<Real>);  // as above
    CHECK(std::abs(drawing.pose(point, Real(0.25)).position.x() - (Real(n) + Real(0.25))) <=
          8 * unit_roundoff<Real>);
  }
}

TEST_CASE("A body put elsewhere is not drawn on the way there, and a slot's new body starts anew") {
  World<double> world(steps_per_second(1));
  Drawing<double> drawing;
  const BodyHandle ball = world.add("ball", make_particle<double>(1, {0, 0, 0}, {1, 0, 0}));
  CHECK_THROWS_AS(drawing.pose(ball, 0), std::out_of_range);
  drawing.note(world);
  world.step();
  drawing.note(world);
  CHECK(drawing.pose(ball, 0.5).position.x() == 0.5);
  drawing.cut(ball);
  world.set_position(ball, {100, 0, 0});
  drawing.note(world);
  CHECK(drawing.pose(ball, 0.5).position.x() == 100);

  // Its model stays with it.
  drawing.set_model(ball, {.position = {0, 3, 0}});
  drawing.cut();  // all bodies
  world.set_position(ball, {200, 0, 0});
  drawing.note(world);
  CHECK(drawing.pose(ball, 0.5).position == Vec3d(200, 3, 0));

  world.remove(ball);
  const BodyHandle other = world.add("other", make_particle<double>(1, {7, 0, 0}));
  REQUIRE(other.slot == ball.slot);
  CHECK_THROWS_AS(drawing.pose(other, 0), std::out_of_range);
  drawing.note(world);
  CHECK(drawing.pose(other, 0.5).position.x() == 7);
  CHECK_THROWS_AS(drawing.pose(ball, 0), std::out_of_range);
}
