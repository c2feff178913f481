// Wheels inside bodies that lie in packs.
#include <support/beside_one_by_one.hpp>
#include <support/box_body.hpp>
#include <support/complaint_of_step.hpp>
#include <tumble/reaction_wheel.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

/// Bodies of all kinds, some with one or two locked axes, with a wheel in all and one or two more
/// in some.
template <class Real, class AnyWorld>
AnyWorld with_wheels(AnyWorld world, Scheme scheme, int count) {
  RandomGenerator dice(77);
  std::vector<BodyHandle> third, fifth;
  for (int n = 0; n < count; ++n) {
    const std::string name = "body " + std::to_string(n);
    RigidBody<Real> door = box_body<Real>(dice.vector<Real>());
    for (int axis = 0; axis < 1 + n % 2; ++axis) lock_axis(door.top, (n + axis) % 3);
    set_angular_velocity_body(door.top, free_part<Real>(door.top, dice.vector<Real>()));
    const BodyHandle body = n % 4 == 0 ? world.add(name, door) : add_random_body(world, dice, name);
    if (world.is_point(body)) continue;
    if (n % 3 == 0) third.push_back(body);
    if (n % 5 == 0) fifth.push_back(body);
  }
  world.step_by(scheme);
  world.add(SteadyTorque<Real>{{0, Real(0.25), 0}}, third);
  world.add(ReactionWheel<Real>{.momentum = 4});
  world.add(ReactionWheel<Real>{.axis = {0, Real(0.6), Real(0.8)},
                                .momentum = 3,
                                .torque = 2,
                                .from = Real(0.05),
                                .until = Real(0.125),
                                .name = "second"},
            third);
  world.add(ReactionWheel<Real>{.axis = {1, 0, 0}, .torque = -5, .name = "third"}, fifth);
  return world;
}

}  // namespace

TEST_CASE_TEMPLATE(
    "Bodies with wheels turn in packs as one by one, to the bit, and a step that a wheel spoils is "
    "taken back with the same error",
    Real, EVERY_PRECISION) {
  for (const Scheme scheme : {Scheme::semi_implicit_euler, Scheme::verlet, Scheme::suzuki})
    for (const int threads : {1, 2}) {
      CAPTURE(name_of(scheme));
      CAPTURE(threads);
      const int count = threads == 1 ? 70 : 1501;
      World<Real> plain = with_wheels<Real>(World<Real>(steps_per_second(60)), scheme, count);
      auto packed = with_wheels<Real>(ManyBodies<Real>(steps_per_second(60)), scheme, count);
      packed.use_threads(threads);
      const Bodies<Real> start = plain.bodies();
      for (int n = 0; n < 12; ++n) {
        plain.step(), packed.step();
        REQUIRE(same_motion(plain.bodies(), packed.bodies()));
      }
      CHECK_FALSE(same_motion(start, plain.bodies()));
      const ReactionWheel<Real> wheel{.momentum = Real(1e12), .name = "too fast"};
      plain.add(wheel), packed.add(wheel);
      const std::string complaint = complaint_of_step([&] { plain.step(); });
      CHECK(complaint.find("too fast would turn it by ") != std::string::npos);
      CHECK(complaint_of_step([&] { packed.step(); }) == complaint);
      CHECK(same_motion(plain.bodies(), packed.bodies()));
    }
}

TEST_CASE(
    "In packs a wheel is four parts of each drift: it joins, turns the body twice, and leaves") {
  auto world = with_wheels<float>(ManyBodies<float>(steps_per_second(60)), Scheme::verlet, 70);
  int parts = 0;
  for (const PackedPart& part : world.backend().parts(world.step_plan()))
    parts += part.name == "second";
  CHECK(parts == 2 * 4);
}
