// What is changed in a world while it runs, and what of it is refused.
#include <support/box_body.hpp>
#include <support/checks.hpp>
#include <support/random_world.hpp>
#include <tumble/ledger.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

template <class Action>
std::string sentence_of(const Action& action) {
  try {
    action();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "nothing thrown";
}

}  // namespace

TEST_CASE_TEMPLATE("A body that makes no sense is refused, on its own or in place of another", Real,
                   EVERY_PRECISION) {
  const Real infinity = std::numeric_limits<Real>::infinity();
  World<Real> world;
  const BodyHandle there = world.add("there", box_body<Real>({0, 0, 0}));
  const auto refused = [&](const auto& spoil, const std::string& what) {
    RigidBody<Real> body = box_body<Real>({1, 0, 0});
    spoil(body);
    CHECK(sentence_of([&] { world.add("new", body); }).find("new: " + what + " is ") == 0);
    CHECK(sentence_of([&] { world.replace(there, body); }).find("there: " + what + " is ") == 0);
  };
  refused([&](auto& body) { body.centre.position.x() = infinity; }, "position");
  refused([&](auto& body) { body.centre.velocity.y() = infinity; }, "velocity");
  refused([&](auto& body) { body.centre.inverse_mass = -1; }, "inverse mass");
  refused([&](auto& body) { body.top.orientation.real = 2; }, "orientation");
  refused([&](auto& body) { body.top.angular_momentum_body.z() = infinity; }, "angular momentum");
  refused([&](auto& body) { body.top.inverse_moments.x() = infinity; }, "inverse moments");
  refused([&](auto& body) { body.top.inverse_moments.x() = -1; }, "inverse moments");
  const auto spin_about_the_lock = [&](auto& body) {
    body.top.inverse_moments.y() = 0;
    body.top.angular_momentum_body = {1, 2, 3};
  };
  refused(spin_about_the_lock, "angular momentum");
  CHECK(world.body_count() == 1);
}

TEST_CASE_TEMPLATE(
    "An orientation that is nearly of norm 1 has it in the world, on its own or in place of "
    "another",
    Real, EVERY_PRECISION) {
  World<Real> world;
  RigidBody<Real> typed = box_body<Real>({0, 0, 0});
  typed.top.orientation = {.real = Real(0.71), .imaginary = {Real(0.71), 0, 0}};
  const BodyHandle added = world.add("added", typed);
  const BodyHandle replaced = world.add("replaced", box_body<Real>({1, 0, 0}));
  world.replace(replaced, typed);
  for (const BodyHandle body : {added, replaced})
    CHECK(std::abs(norm(world.orientation(body)) - 1) <= 8 * unit_roundoff<Real>);
  // One that has norm 1 to rounding keeps its bits.
  typed.top.orientation = world.orientation(added);
  world.replace(replaced, typed);
  CHECK(same_bits(world.orientation(replaced).imaginary, typed.top.orientation.imaginary));
  // So a body at rest is the same whether it is left alone or turned by nothing.
  World<Real> exhaustive = world;
  world.step();
  exhaustive.step_exhaustively();
  CHECK(world.orientation(added).real == exhaustive.orientation(added).real);
}

TEST_CASE_TEMPLATE("A body turns to the orientation that it is given, and a point is refused one",
                   Real, EVERY_PRECISION) {
  World<Real> world;
  const BodyHandle box = world.add("box", box_body<Real>({0, 0, 0}));
  const BodyHandle point = world.add("point", make_particle<Real>(1));
  const Quaternion<Real> q = {.real = Real(0.5), .imaginary = {Real(0.5), Real(-0.5), Real(0.5)}};
  world.set_orientation(box, q);
  CHECK(world.orientation(box).real == q.real);
  CHECK(same_bits(world.orientation(box).imaginary, q.imaginary));
  CHECK(sentence_of([&] { world.set_orientation(point, q); }) ==
        "'point' is a point: it has no orientation");
  CHECK(sentence_of([&] { (void)world.orientation(point); }) ==
        "'point' is a point: it has no orientation");
  CHECK(sentence_of([&] { (void)world.angular_velocity(point); }) ==
        "'point' is a point: it has no orientation");
}

TEST_CASE_TEMPLATE("A body is where it was put, and moves and turns as it was told", Real,
                   EVERY_PRECISION) {
  World<Real> world;
  const BodyHandle box = world.add("box", box_body<Real>({0, 0, 0}));
  const Vec3<Real> there(1, 2, 3), velocity(-4, 5, 6), angular_velocity(7, 8, -9);
  world.set_position(box, there);
  world.set_velocity(box, velocity);
  world.set_orientation(box, {.real = Real(0.5), .imaginary = {Real(0.5), Real(-0.5), Real(0.5)}});
  world.set_angular_velocity(box, angular_velocity);
  CHECK(same_bits(world.position(box), there));
  CHECK(same_bits(world.velocity(box), velocity));
  // To L and back: two turns of a vector, some 16 roundings each, and two by the moments.
  CHECK((world.angular_velocity(box) - angular_velocity).norm() <=
        34 * unit_roundoff<Real> * angular_velocity.norm());
}

TEST_CASE_TEMPLATE("A blow that makes a speed or a spin infinite is refused", Real,
                   EVERY_PRECISION) {
  World<Real> world;
  RigidBody<Real> light = box_body<Real>({0, 0, 0});
  light.centre.inverse_mass = 4;
  const BodyHandle box = world.add("box", light);
  const Real most = std::numeric_limits<Real>::max();
  CHECK(sentence_of([&] {
          world.apply_impulse_at(box, {most, 0, 0}, {0, 0, 0});
        }).find("box: velocity after the blow is ") == 0);
  CHECK(sentence_of([&] {
          world.apply_impulse_at(box, {0, most / 8, 0}, {0, 0, 64});
        }).find("box: angular momentum after the blow is ") == 0);
  const std::string spun = sentence_of([&] {
    world.apply_impulse_at(box, {0, most / 8, 0}, {0, 0, 64});
  });
  CHECK(spun.substr(spun.rfind(')')) == ") kg m^2/s; every component must be finite");
  CHECK(world.velocity(box) == Vec3<Real>::Zero());
}

TEST_CASE_TEMPLATE(
    "After a body is taken out, another may have its name, and the last keeps its own", Real,
    EVERY_PRECISION) {
  World<Real> world;
  const BodyHandle first = world.add("first", make_particle<Real>(1, {1, 0, 0}));
  const BodyHandle last = world.add("last", make_particle<Real>(1, {2, 0, 0}, {1, 0, 0}));
  world.remove(first);
  CHECK(world.name_of(last) == "last");
  CHECK(world.find("last") == last);
  world.add("first", make_particle<Real>(1, {3, 0, 0}));
  CHECK(sentence_of([&] { world.set_velocity(first, {1, 0, 0}); }).find("stale handle") == 0);
  CHECK(world.position(world.find("first")).x() == 3);
}

TEST_CASE_TEMPLATE("A world of no time stands still, and one that runs backwards is refused", Real,
                   EVERY_PRECISION) {
  World<Real> still(StepLength{0, 1});
  const BodyHandle ball = still.add("ball", make_particle<Real>(1, {1, 0, 0}, {2, 0, 0}));
  still.step();
  CHECK(still.position(ball).x() == 1);
  CHECK(sentence_of([] { World<Real>(StepLength{-1, 1}); }) != "nothing thrown");
}

TEST_CASE_TEMPLATE(
    "The sums are empty between two steps, and what an effect has set going goes on without it",
    Real, EVERY_PRECISION) {
  World<Real> world(steps_per_second(2));
  RigidBody<Real> loaded = box_body<Real>({0, 0, 0});
  loaded.centre.force = {1, 2, 3};
  loaded.top.torque = {4, 5, 6};
  const BodyHandle box = world.add("box", loaded);
  CHECK(same_bits(world.body(box).centre.force, Vec3<Real>(0, 0, 0)));
  CHECK(same_bits(world.body(box).top.torque, Vec3<Real>(0, 0, 0)));
  world.replace(box, loaded);
  CHECK(same_bits(world.body(box).centre.force, Vec3<Real>(0, 0, 0)));
  CHECK(same_bits(world.body(box).top.torque, Vec3<Real>(0, 0, 0)));
  const EffectHandle pull =
      world.add(Thruster<Real>{.force_body = {4, 0, 0}, .point = {0, 1, 0}}, {box});
  world.step();
  CHECK(same_bits(world.body(box).centre.force, Vec3<Real>(0, 0, 0)));
  CHECK(same_bits(world.body(box).top.torque, Vec3<Real>(0, 0, 0)));
  const BodyHandle wall = world.add("wall", make_static_particle<Real>({9, 0, 0}));
  const EffectHandle spring =
      world.add(SpringBetween<Real>{.spring = {.stiffness = 1}}, {box, wall});
  world.step();
  CHECK(same_bits(world.body(wall).centre.force, Vec3<Real>(0, 0, 0)));
  world.remove(spring);
  world.remove(pull);
  RigidBody<Real> alone = world.body(box);
  world.step();
  drift(alone, Real(0.5));
  CHECK(alone.centre.velocity.norm() > Real(0.5));
  CHECK(same_bits(world.velocity(box), alone.centre.velocity));
  CHECK(same_bits(world.position(box), alone.centre.position));
  CHECK(same_bits(world.orientation(box).imaginary, alone.top.orientation.imaginary));
}

TEST_CASE_TEMPLATE("A push stays with its body while others are removed, and goes with its own",
                   Real, EVERY_PRECISION) {
  World<Real> world(steps_per_second(1));
  std::vector<BodyHandle> bodies;
  for (int n = 0; n < 4; ++n)
    bodies.push_back(world.add("body " + std::to_string(n), make_particle<Real>(1)));
  for (const BodyHandle body : {bodies[0], bodies[3], bodies[0]})
    world.push_at(body, {1, 0, 0}, {0, 0, 0});
  world.remove(bodies[0]);  // the last one gets its place
  world.step();
  CHECK(world.velocity(bodies[1]).x() == 0);
  CHECK(world.velocity(bodies[2]).x() == 0);
  CHECK(world.velocity(bodies[3]).x() == 1);
  for (const Particle<Real>& centre : world.bodies().centres) CHECK(centre.force.x() == 0);
  world.push_at(bodies[2], {1, 0, 0}, {0, 0, 0});
  world.remove(bodies[2]);
  world.step();
  CHECK(world.velocity(bodies[1]).x() == 0);
  CHECK(world.velocity(bodies[3]).x() == 1);
}

TEST_CASE_TEMPLATE("A push that is given before a step that fails is given again in the next", Real,
                   EVERY_PRECISION) {
  World<Real> world(steps_per_second(1));
  const BodyHandle ball = world.add("ball", make_particle<Real>(1));
  const EffectHandle rope = world.add(PointGravity<Real>{.strength = 1});  // where the ball is
  world.push_at(ball, {3, 0, 0}, {0, 0, 0});
  CHECK_THROWS_AS(world.step(), SimulationError);
  CHECK(same_bits(world.body(ball).centre.force, Vec3<Real>(0, 0, 0)));
  world.remove(rope);
  world.step();
  CHECK(world.velocity(ball).x() == 3);
  world.step();
  CHECK(world.velocity(ball).x() == 3);
  CHECK(same_bits(world.body(ball).centre.force, Vec3<Real>(0, 0, 0)));
  world.add(Gravity<Real>{{0, 0, -8}});  // what it kicks has no push from before in it
  world.step();
  CHECK(same_bits(world.velocity(ball), Vec3<Real>(3, 0, -8)));
}

TEST_CASE_TEMPLATE("An effect can be changed, and then visits the bodies that need it", Real,
                   EVERY_PRECISION) {
  World<Real> world(steps_per_second(1));
  const BodyHandle ball = world.add("ball", make_particle<Real>(1));
  const EffectHandle gravity = world.add(Gravity<Real>{{0, 0, 0}});
  world.step();
  CHECK(world.plan().passes() == 0);
  //! [change]
  Gravity<Real> changed = world.template effect<Gravity<Real>>(gravity);
  changed.gravity.z() = -8;
  world.change(gravity, changed);
  //! [change]
  world.step();
  CHECK(world.velocity(ball).z() == -8);
  world.change(gravity, Gravity<Real>{{0, 0, 0}});
  world.step();
  CHECK(world.velocity(ball).z() == -8);
  CHECK(world.position(ball).z() == -16);
  CHECK(sentence_of([&] { (void)world.template effect<PointGravity<Real>>(gravity); }) ==
        "'gravity' is an effect of another type");
  CHECK(sentence_of([&] { world.change(gravity, Thruster<Real>{}); }) ==
        "'gravity' is an effect of another type");
}

namespace {

/// A blow that takes what two bodies have against each other, as if they stuck.
template <class Real>
struct Sticking {
  static constexpr std::string_view name = "sticking";
  PairImpulse<Real> blow(const BodyState<Real>& first, const BodyState<Real>& second,
                         const StepTime<Real>&) const {
    const Real inverse = first.centre.inverse_mass + second.centre.inverse_mass;
    return {.impulse_on_first = (second.centre.velocity - first.centre.velocity) / inverse};
  }
};

}  // namespace

TEST_CASE_TEMPLATE("Blows act one after another, each on the velocities that the last has left",
                   Real, EVERY_PRECISION) {
  World<Real> world(steps_per_second(1));
  std::vector<BodyHandle> row;
  for (const char* name : {"a", "b", "c"}) row.push_back(world.add(name, make_particle<Real>(1)));
  world.set_velocity(row[0], {8, 0, 0});
  world.add(Sticking<Real>{}, {row[0], row[1], row[1], row[2]});
  world.step();
  CHECK(world.velocity(row[0]).x() == 4);
  CHECK(world.velocity(row[1]).x() == 2);
  CHECK(world.velocity(row[2]).x() == 2);
  CHECK(world.position(row[2]).x() == 2);
}

TEST_CASE_TEMPLATE("A chain holds together while bodies before it are removed", Real,
                   EVERY_PRECISION) {
  World<Real> world(steps_per_second(4));
  const BodyHandle gone = world.add("gone", make_particle<Real>(1));
  const BodyHandle a = world.add("a", make_particle<Real>(1, {0, 0, 0}));
  const BodyHandle b = world.add("b", make_particle<Real>(1, {2, 0, 0}));
  world.add(SpringBetween<Real>{.spring = {.stiffness = 1, .rest_length = 1}}, {a, b});
  world.remove(gone);  // b gets its place
  world.step();
  CHECK(world.velocity(a).x() == Real(0.25));
  CHECK(world.velocity(b).x() == Real(-0.25));
}

TEST_CASE("A slot whose generations are used up is not used again") {
  Slots slots(std::numeric_limits<std::uint32_t>::max() - 1);
  const BodyHandle last_but_one = slots.take(0);
  slots.release(last_but_one);
  const BodyHandle last = slots.take(0);
  CHECK(last.slot == last_but_one.slot);
  CHECK(last.generation == std::numeric_limits<std::uint32_t>::max());
  slots.release(last);
  const BodyHandle other = slots.take(0);
  CHECK(other.slot != last.slot);
  CHECK(other.generation != 0);
  CHECK(slots.index_of(other) == 0);
  for (const BodyHandle gone : {last_but_one, last}) {
    CHECK(!slots.contains(gone));
    CHECK_THROWS_WITH_AS(slots.index_of(gone), doctest::Contains("stale handle"),
                         std::out_of_range);
  }
}

TEST_CASE_TEMPLATE("A push at a point turns the body that it is meant for about its own centre",
                   Real, EVERY_PRECISION) {
  World<Real> world(steps_per_second(2));
  world.add("other", box_body<Real>({-8, 4, 2}));
  const BodyHandle box = world.add("box", box_body<Real>({1, 2, 3}));
  world.push_at(box, {0, 0, 4}, {2, 2, 3});
  world.step();
  // 4 N along z at an arm of 1 m along x, for half a second.
  CHECK(distance(angular_momentum_world(world.body(box).top), Vec3<Real>(0, -2, 0)) <=
        64 * unit_roundoff<Real>);
}

TEST_CASE(
    "Of a joint of several pairs each end needs an orientation where it holds off the centre") {
  World<double> world;
  const BodyHandle a = world.add("a", box_body<double>({0, 0, 0})),
                   b = world.add("b", box_body<double>({1, 0, 0})),
                   c = world.add("c", box_body<double>({2, 0, 0})),
                   point = world.add("point", make_particle<double>(1));
  const SpringBetween<double> joint{.spring = {.stiffness = 1}, .attachment_second = {0, 1, 0}};
  CHECK(sentence_of([&] {
          world.add(joint, {a, b, c, point});
        }) == "'spring between bodies' needs an orientation, and 'point' is a point");
  CHECK(sentence_of([&] { world.add(joint, {a, b, point, c}); }) == "nothing thrown");
}

TEST_CASE("A world that goes back to rest forgets what could have moved its bodies since") {
  World<double> world(steps_per_second(8));
  const BodyHandle stone = world.add("stone", make_particle<double>(1));
  const EffectHandle gravity = world.add(Gravity<double>{});
  const Snapshot<double> snapshot = world.save();
  const Checkpoint<double> mark = world.checkpoint();
  world.step();
  world.remove(gravity);
  for (const bool by_mark : {false, true}) {
    if (by_mark)
      world.restore(mark);
    else
      world.restore(snapshot);
    CHECK(world.step_plan().moving.size() == 0);
    world.step();
    CHECK(world.position(stone).isZero(0));
    world.set_velocity(stone, {1, 0, 0});
  }
}
