#include <support/beside_one_by_one.hpp>

using namespace tumble;
using namespace tumble::support;

TEST_CASE_TEMPLATE("Random worlds move in packs as one by one, to the bit", Real, EVERY_PRECISION) {
  compare_with_one_by_one<Real, natural_width<Real>>(1, 70, 1);
  compare_with_one_by_one<Real, natural_width<Real>>(71, 30, 2);
}

TEST_CASE("A world of points in packs keeps no tops") {
  ManyBodies<float> rain;
  for (int n = 0; n < 20; ++n) rain.add(std::to_string(n), make_particle<float>(1));
  rain.add(GravityAsAcceleration<float>{});
  rain.step();
  CHECK(rain.top_count() == 0);
  CHECK(rain.body_count() == 20);
}

TEST_CASE_TEMPLATE("Thousands of bodies shared among threads move as one by one, to the bit", Real,
                   EVERY_PRECISION) {
  const auto crowd = []<class AnyWorld>(AnyWorld world) {
    RandomGenerator dice(2000);
    std::vector<BodyHandle> bodies;
    for (int n = 0; n < 3001; ++n)
      bodies.push_back(add_random_body(world, dice, "body " + std::to_string(n)));
    world.add(Gravity<Real>{});
    world.add(AngularDamping<Real>{.rate = Real(0.1)});
    world.add(Magnus<Real>{.strength = Real(0.01), .wind = {1, 0, 0}});
    for (int n = 0; n < 20; ++n) add_random_effect(world, dice, {bodies[dice.below(3001)]});
    return world;
  };
  World<Real> plain = crowd(World<Real>(steps_per_second(60)));
  for (int step = 0; step < 10; ++step) plain.step();
  for (const int threads : {2, 3, 5}) {
    CAPTURE(threads);
    auto packed = crowd(World<Real, InPacks<Real>>(steps_per_second(60)));
    packed.use_threads(threads);
    for (int step = 0; step < 10; ++step) packed.step();
    CHECK(same_motion(plain.bodies(), packed.bodies()));
  }
}

TEST_CASE_TEMPLATE("Thousands of springs shared among threads pull as one by one, to the bit", Real,
                   EVERY_PRECISION) {
  const auto net = []<class AnyWorld>(AnyWorld world) {
    RandomGenerator dice(2001);
    std::vector<BodyHandle> bodies, joined, tops;
    constexpr std::size_t count = 3001;
    for (std::size_t n = 0; n < count; ++n)
      bodies.push_back(add_random_body(world, dice, "body " + std::to_string(n)));
    for (std::size_t n = 0; n < count; ++n) {
      const std::size_t first = dice.below(count);
      joined.push_back(bodies[first]);
      joined.push_back(bodies[(first + 1 + dice.below(count - 1)) % count]);
    }
    world.add(Gravity<Real>{});
    world.add(Magnus<Real>{.strength = Real(0.01), .wind = {1, 0, 0}});
    world.add(SpringBetween<Real>{{.stiffness = 3, .damping = Real(0.1), .rest_length = 1}},
              joined);
    for (const BodyHandle body : bodies)
      if (!world.is_point(body)) tops.push_back(body);
    if (tops.size() % 2 == 1) tops.pop_back();
    world.add(SpringBetween<Real>{.spring = {.stiffness = 1, .rest_length = 1},
                                  .attachment_first = {Real(0.5), 0, 0},
                                  .attachment_second = {0, Real(0.25), 0}},
              tops);  // each of them turns its bodies too
    return world;
  };
  World<Real> plain = net(World<Real>(steps_per_second(60)));
  for (int step = 0; step < 4; ++step) plain.step();
  auto packed = net(World<Real, InPacks<Real>>(steps_per_second(60)));
  for (const int threads : {1, 2, 3, 2}) {
    packed.use_threads(threads);
    packed.step();
  }
  CHECK(same_motion(plain.bodies(), packed.bodies()));
}

TEST_CASE_TEMPLATE("A body that fills a gap in a pack keeps its own top", Real, EVERY_PRECISION) {
  // The gap is the second place of the second pack: the last body's top, which lies a pack further
  // on, then belongs between two that lie side by side.
  constexpr int width = natural_width<Real>;
  const auto flown = []<class AnyWorld>(AnyWorld world) {
    const auto ball = mass_properties(Sphere<Real>{1}, 1);
    for (int n = 0; n <= 2 * width; ++n)
      if (n == width + 1)
        world.add("gap", make_particle<Real>(1));
      else
        world.add("ball " + std::to_string(n),
                  make_rigid_body<Real>("ball", ball, {}, {1, 0, 0}, {0, 0, Real(n)}).body);
    world.add(Magnus<Real>{.strength = Real(0.1)});
    world.remove(world.find("gap"));
    for (int step = 0; step < 4; ++step) world.step();
    return world.bodies();
  };
  CHECK(same_motion(flown(World<Real>()), flown(ManyBodies<Real>())));
}
