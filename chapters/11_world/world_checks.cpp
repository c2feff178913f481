#include <map>
#include <string>
#include <support/checks.hpp>
#include <support/random_world.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

template <class Real>
const Real infinity = std::numeric_limits<Real>::infinity();
template <class Real>
const Real not_a_number = std::numeric_limits<Real>::quiet_NaN();

template <class Action>
std::string complaint_of_any(const Action& action) {
  try {
    action();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "nothing thrown";
}

/// A force that is no number from a certain time on.
template <class Real>
struct BrokenMotor {
  static constexpr std::string_view name = "broken motor";
  Real breaks_at = Real(0.05);
  Vec3<Real> force(const Particle<Real>&, Real time) const {
    return {time < breaks_at ? Real(1) : not_a_number<Real>, 0, 0};
  }
};

template <class Real>
RigidBody<Real> ball_body(const Vec3<Real>& place, const Vec3<Real>& spin = Vec3<Real>::Zero()) {
  return make_rigid_body<Real>("ball", mass_properties(Sphere<Real>{1}, 2), {place},
                               Vec3<Real>::Zero(), spin)
      .body;
}

}  // namespace

TEST_CASE_TEMPLATE("An effect for a body that has gone is refused, and nothing has changed", Real,
                   EVERY_PRECISION) {
  World<Real> world;
  const BodyHandle first = world.add("first", make_particle<Real>(1)),
                   second = world.add("second", make_particle<Real>(1));
  world.remove(second);
  world.step();
  const std::size_t told = world.change_log().size();
  const SpringBetween<Real> spring{.spring = {.stiffness = 1}};
  for (const std::vector<BodyHandle>& pair : {std::vector{first, second}, {second, first}})
    CHECK_THROWS_WITH_AS(world.add(spring, pair), doctest::Contains("stale handle"),
                         std::out_of_range);
  CHECK_THROWS_AS(world.add(Gravity<Real>{}, {second}), std::out_of_range);
  CHECK(world.effects().empty());
  CHECK(world.change_log().size() == told);
  world.set_velocity(first, {1, 0, 0});  // goes through the effects of this body
  world.step();
  CHECK(world.velocity(first).x() == 1);
}

TEST_CASE_TEMPLATE("An effect is contained until it goes, or its last body", Real,
                   EVERY_PRECISION) {
  World<Real> world;
  const BodyHandle first = world.add("first", make_particle<Real>(1)),
                   second = world.add("second", make_particle<Real>(1));
  const EffectHandle both = world.add(Gravity<Real>{}, {first, second});
  const EffectHandle all = world.add(Gravity<Real>{});
  world.remove(first);
  CHECK(world.contains(both));
  world.remove(second);
  CHECK_FALSE(world.contains(both));
  CHECK(world.contains(all));
  world.remove(all);
  CHECK_FALSE(world.contains(all));
}

TEST_CASE_TEMPLATE("A stale handle says so, and its slot's next body is another body", Real,
                   EVERY_PRECISION) {
  World<Real> world;
  const BodyHandle first = world.add("first", make_particle<Real>(1, {1, 0, 0}));
  const BodyHandle second = world.add("second", ball_body<Real>({2, 0, 0}));
  const BodyHandle third = world.add("third", ball_body<Real>({3, 0, 0}));
  world.remove(first);
  CHECK(complaint_of_any([&] {
          world.set_velocity(first, {1, 0, 0});
        }) == "stale handle: body 0, generation 1, has been removed");
  const BodyHandle fourth = world.add("fourth", make_particle<Real>(1, {4, 0, 0}));
  CHECK(fourth.slot == first.slot);
  CHECK_FALSE(world.contains(first));
  CHECK(world.position(second).x() == 2);
  CHECK(world.position(third).x() == 3);
  CHECK(world.position(fourth).x() == 4);
  CHECK(world.find("third") == third);
  CHECK(world.name_of(second) == "second");
  CHECK(world.handle_at(2) == fourth);
  CHECK(complaint_of_any([&] { (void)world.handle_at(3); }) == "there is no body at place 3 of 3");
}

TEST_CASE_TEMPLATE(
    "A handle from no world or from another is refused; a copy knows those of its original", Real,
    EVERY_PRECISION) {
  World<Real> world, other;
  const BodyHandle body = world.add("body", make_particle<Real>(1));
  const BodyHandle foreign = other.add("foreign", make_particle<Real>(1));
  const EffectHandle gravity = world.add(Gravity<Real>{});
  const EffectHandle foreign_gravity = other.add(Gravity<Real>{});
  CHECK(complaint_of_any([&] { (void)world.body(BodyHandle{}); }) ==
        "empty handle: no world gave it out; add() and find() do");
  CHECK(complaint_of_any([&] { (void)world.body(foreign); }) ==
        "foreign handle: body 0 is one of another world");
  CHECK_FALSE(world.contains(foreign));
  CHECK(complaint_of_any([&] { world.remove(foreign_gravity); }) ==
        "stale handle: effect 1 has been removed or never was in this world");
  World<Real> copy = world;
  // What each is given after that may have the same handle in both.
  const BodyHandle here = world.add("here", make_particle<Real>(1));
  const BodyHandle there = copy.add("there", make_particle<Real>(1));
  CHECK(here == there);
  CHECK(world.name_of(there) == "here");
  CHECK(copy.name_of(there) == "there");
  copy.remove(gravity);
  copy.set_velocity(body, {1, 0, 0});
  CHECK(copy.velocity(body).x() == 1);
  CHECK(world.velocity(body).x() == 0);
}

TEST_CASE("A map has what a user remembers of each body, while bodies come and go") {
  //! [user_data]
  World<double> world;
  std::map<BodyHandle, int> lives;
  lives[world.add("knight", make_particle(80.0))] = 3;
  lives[world.add("dragon", make_particle(900.0))] = 9;
  const BodyHandle knight = world.find("knight");
  --lives[knight];
  world.remove(knight);
  std::erase_if(lives, [&](const auto& entry) { return !world.contains(entry.first); });
  //! [user_data]
  CHECK(lives == std::map<BodyHandle, int>{{world.find("dragon"), 9}});
}

TEST_CASE_TEMPLATE("Bodies keep their tops while others are removed", Real, EVERY_PRECISION) {
  RandomGenerator dice(5);
  World<Real> world;
  std::vector<BodyHandle> handles;
  std::vector<Real> marks;
  for (int n = 0; n < 200; ++n) {
    if (!handles.empty() && dice.one_in(3)) {
      const std::size_t gone = dice.below(handles.size());
      world.remove(handles[gone]);
      handles.erase(handles.begin() + static_cast<std::ptrdiff_t>(gone));
      marks.erase(marks.begin() + static_cast<std::ptrdiff_t>(gone));
    } else {
      const Real mark = Real(n + 1);
      handles.push_back(dice.one_in(2) ? world.add(std::to_string(n), make_particle(mark))
                                       : world.add(std::to_string(n),
                                                   ball_body<Real>({mark, 0, 0}, {mark, 0, 0})));
      marks.push_back(mark);
    }
    for (std::size_t i = 0; i < handles.size(); ++i) {
      const RigidBody<Real> body = world.body(handles[i]);
      if (body.top.inverse_moments.x() == 0) {
        REQUIRE(body.centre.inverse_mass == 1 / marks[i]);
      } else {
        REQUIRE(body.centre.position.x() == marks[i]);
        // L = I ω and back: two roundings.
        REQUIRE(std::abs(angular_velocity_body(body.top).x() - marks[i]) <=
                4 * unit_roundoff<Real> * marks[i]);
      }
    }
  }
}

TEST_CASE_TEMPLATE("A force that turns NaN stops the step, names its effect, and nothing has moved",
                   Real, EVERY_PRECISION) {
  World<Real> world(steps_per_second(64));
  world.add("rock", ball_body<Real>({0, 0, 5}, {1, 0, 0}));
  const BodyHandle kite = world.add("kite", make_particle<Real>(1, {1, 0, 0}));
  world.add(Gravity<Real>{});
  world.add(BrokenMotor<Real>{.breaks_at = Real(0.07)}, {kite});
  world.add(LinearDamping<Real>{.rate = 1});
  for (int n = 0; n < 5; ++n) world.step();
  const Bodies<Real> before = world.bodies();
  std::string effect, body, what;
  double time = 0;
  try {
    world.step();
  } catch (const SimulationError& error) {
    effect = error.effect, body = error.body, what = error.what(), time = error.time;
  }
  CHECK(effect == "broken motor");
  CHECK(body == "kite");
  CHECK(time == 0.078125);  // 5/64, exact in binary
  CHECK(what.find("'kite' at 0.078125 s (step 5): broken motor gives a force of (") == 0);
  CHECK(what.find(" N; every component must be finite; the world is as it was before this step") !=
        std::string::npos);
  CHECK(same_motion(before, world.bodies()));
  CHECK(world.ticks() == 5);
}

TEST_CASE_TEMPLATE("A step that leads nowhere finite is not taken", Real, EVERY_PRECISION) {
  World<Real> world;
  const Real huge = std::numeric_limits<Real>::max();
  const BodyHandle comet = world.add("comet", make_particle<Real>(1, {huge, 0, 0}));
  const BodyHandle rock = world.add("rock", make_particle<Real>(1, {0, 0, 0}, {1, 0, 0}));
  world.set_velocity(comet, {huge, 0, 0});
  CHECK(complaint_of_any([&] { world.step(); })
            .find("'comet' at 0 s (step 0): with a velocity of "
                  "(") == 0);
  CHECK(world.position(rock).x() == 0);
  world.set_velocity(comet, {0, 0, 0});  // it does no harm where it stays
  world.step();
  CHECK(world.position(rock).x() == world.time_step());
}

TEST_CASE_TEMPLATE("A turn beyond the range of the sine is taken back, and all that moved with it",
                   Real, EVERY_PRECISION) {
  const Real largest = 2 * SineCosineConstants<Real>::limit;
  const auto world_with = [&](Real turn) {
    World<Real> world(steps_per_second(1));
    world.add("stone", ball_body<Real>({1, 2, 3}, {4, 5, 6}));
    world.add("top", ball_body<Real>({0, 0, 0}, {turn, 0, 0}));
    world.set_velocity(world.find("stone"), {1, 2, 3});
    return world;
  };
  World<Real> slow = world_with(largest * Real(0.99)), fast = world_with(largest * Real(1.01));
  slow.step();
  CHECK(std::isfinite(slow.orientation(slow.find("top")).real));
  const Bodies<Real> before = fast.bodies();
  const std::string what = complaint_of_any([&] { fast.step(); });
  CAPTURE(what);
  CHECK(what.find("'top' at 0 s (step 0): it would turn by ") == 0);
  CHECK(what.find(" rad in this step, and no finite orientation was found; at most " +
                  text_of(largest) + " rad can be turned; the world is as it was") !=
        std::string::npos);
  CHECK(same_motion(before, fast.bodies()));
}

TEST_CASE_TEMPLATE("Bad input is refused when it comes, by name, value, unit and rule", Real,
                   EVERY_PRECISION) {
  World<Real> world;
  const BodyHandle ball = world.add("ball", ball_body<Real>({0, 0, 0}));
  const BodyHandle point = world.add("point", make_particle<Real>(1));
  const Vec3<Real> nan_vector(not_a_number<Real>, 0, 0);
  const Bodies<Real> before = world.bodies();
  const auto complaint = [&](const auto& effect) {
    return complaint_of_any([&] { world.add(effect); });
  };
  const auto spring = [&](Spring<Real> terms) {
    return complaint_of_any([&] { world.add(SpringToPoint<Real>{.spring = terms}, {ball}); });
  };
  using Refused = std::pair<std::string, std::string>;  // what is said, and how it must begin
  for (const Refused& refused : {
           Refused(complaint_of_any([&] { world.add("ball", make_particle<Real>(1)); }),
                   "two bodies are called 'ball'; names must differ"),
           Refused(complaint_of_any([&] { world.add("", make_particle<Real>(1)); }),
                   "a body needs a name"),
           Refused(complaint_of_any([&] { world.set_velocity(ball, nan_vector); }),
                   "ball: velocity is (nan, 0, 0) m/s; every component must be finite"),
           Refused(complaint_of_any([&] { world.set_position(ball, nan_vector); }),
                   "ball: position is (nan, 0, 0) m; every component must be finite"),
           Refused(complaint_of_any([&] { world.set_angular_velocity(ball, nan_vector); }),
                   "ball: angular velocity is (nan, 0, 0) rad/s; every component must be finite"),
           Refused(complaint_of_any([&] {
                     world.set_orientation(ball, {0, {0, 0, 0}});
                   }),
                   "ball: orientation"),
           Refused(complaint_of_any([&] {
                     world.set_angular_velocity(point, {1, 0, 0});
                   }),
                   "'point' is a point: it has no orientation"),
           Refused(complaint_of_any([&] {
                     world.apply_impulse_at(ball, nan_vector, {0, 0, 0});
                   }),
                   "impulse is (nan, 0, 0) N s; every component must be finite"),
           Refused(complaint_of_any([&] { world.find("bell"); }), "no body is called 'bell'"),
           Refused(complaint(Gravity<Real>{.gravity = nan_vector}),
                   "gravity is (nan, 0, 0) m/s^2; every component must be finite"),
           Refused(complaint(LinearDamping<Real>{.rate = -1}),
                   "linear damping is -1 1/s; it must be 0 or more: a negative one adds speed"),
           Refused(complaint(AngularDamping<Real>{.rate = infinity<Real>}),
                   "angular damping is inf 1/s; it must be finite"),
           Refused(complaint(QuadraticDrag<Real>{.coefficient = -2}),
                   "drag coefficient is -2 kg/m; it must be 0 or more"),
           Refused(complaint(Magnus<Real>{.strength = not_a_number<Real>}),
                   "strength of the Magnus force is nan kg; it must be finite"),
           Refused(complaint(Buoyancy<Real>{.radius = -1}),
                   "radius of a floating ball is -1 m; it must be 0 or more"),
           Refused(complaint(PointGravity<Real>{.strength = -1}),
                   "strength of point gravity is -1 m^3/s^2; it must be 0 or more"),
           Refused(spring({.stiffness = -1}),
                   "stiffness of a spring is -1 N/m; it must be 0 or more"),
           Refused(spring({.damping = not_a_number<Real>}),
                   "damping of a spring is nan N s/m; it must be finite"),
           Refused(spring({.rest_length = -1}),
                   "rest length of a spring is -1 m; it must be 0 or more"),
           Refused(complaint_of_any([&] {
                     world.add(SpringToPoint<Real>{.attachment = {1, 0, 0}}, {point});
                   }),
                   "'spring' needs an orientation, and 'point' is a point"),
           Refused(complaint_of_any([&] {
                     world.add(SpringBetween<Real>{}, {ball, ball});
                   }),
                   "'spring between bodies' joins 'ball' to itself"),
           Refused(complaint_of_any([&] {
                     world.add(Gravity<Real>{}, {ball, ball});
                   }),
                   "'gravity' was given 'ball' twice"),
           Refused(complaint_of_any([&] { world.add(SpringBetween<Real>{}, {ball}); }),
                   "'spring between bodies' was given 1 bodies; it needs pairs of them"),
           Refused(complaint_of_any([&] { world.add(Gravity<Real>{}, {}); }),
                   "'gravity' was given 0 bodies; it needs at least one"),
           Refused(
               complaint_of_any([&] { world.add(Thruster<Real>{.from = 2, .until = 1}, {ball}); }),
               "end of a thruster is 1 s; it must not lie before the start"),
           Refused(complaint_of_any([&] { world.remove(EffectHandle{77}); }),
                   "stale handle: effect 77 has been removed or never was in this world"),
       }) {
    CAPTURE(refused.first);
    CAPTURE(refused.second);
    CHECK(refused.first.find(refused.second) == 0);
  }
  CHECK(same_motion(before, world.bodies()));
  CHECK(world.effects().empty());
  CHECK(world.body_count() == 2);
}

TEST_CASE_TEMPLATE("Removing a body removes what was fixed to it, and nothing else", Real,
                   EVERY_PRECISION) {
  World<Real> world;
  const BodyHandle a = world.add("a", make_particle<Real>(1));
  const BodyHandle b = world.add("b", make_particle<Real>(1, {1, 0, 0}));
  const BodyHandle c = world.add("c", make_particle<Real>(1, {2, 0, 0}));
  const Spring<Real> spring{.stiffness = 1};
  world.add(SpringBetween<Real>{.spring = spring, .name = "chain"}, {a, b, b, c});
  world.add(SpringToPoint<Real>{.spring = spring, .name = "nail"}, {b, c});
  world.add(SpringBetween<Real>{.spring = spring, .name = "only a"}, {a, c});
  world.add(Gravity<Real>{});
  world.remove(a);
  REQUIRE(world.effects().size() == 3);
  CHECK(world.effects()[0].targets == std::vector<BodyHandle>{b, c});
  CHECK(world.effects()[1].targets == std::vector<BodyHandle>{b, c});
  CHECK(world.effects()[2].everyone);
  world.remove(c);
  REQUIRE(world.effects().size() == 2);
  CHECK(world.effects()[0].targets == std::vector<BodyHandle>{b});
  world.step();
}

TEST_CASE_TEMPLATE("A body can be replaced by a heavier one, which keeps its name and its effects",
                   Real, EVERY_PRECISION) {
  World<Real> world(steps_per_second(1));
  const BodyHandle ball = world.add("ball", ball_body<Real>({0, 0, 0}));
  world.add(Thruster<Real>{.force_body = {12, 0, 0}}, {ball});
  world.step();
  CHECK(world.velocity(ball).x() == 6);  // 12 N on 2 kg for 1 s
  RigidBody<Real> heavier = world.body(ball);
  heavier.centre.inverse_mass = Real(0.25);
  world.replace(ball, heavier);
  world.step();
  CHECK(world.velocity(ball).x() == 9);
  CHECK(world.name_of(ball) == "ball");
  heavier.centre.inverse_mass = 0;
  world.replace(ball, heavier);  // now nothing moves it but the velocity that it was given
  world.step();
  CHECK(world.velocity(ball).x() == 6);
  heavier.centre.inverse_mass = -1;
  CHECK(complaint_of_any([&] { world.replace(ball, heavier); }) ==
        "ball: inverse mass is -1 1/kg; it must be 0 or more");
}

TEST_CASE_TEMPLATE("A point can be replaced by a heavier point, and by nothing else", Real,
                   EVERY_PRECISION) {
  World<Real> world(steps_per_second(1));
  const BodyHandle point = world.add("point", make_particle<Real>(1, {0, 0, 0}, {3, 0, 0}));
  world.add(SpringToPoint<Real>{.spring = {.stiffness = 1}, .anchor = {8, 0, 0}}, {point});
  Particle<Real> heavier = make_particle<Real>(4, {4, 0, 0}, {3, 0, 0});
  heavier.force = {100, 0, 0};  // is dropped
  world.replace(point, heavier);
  world.step();
  CHECK(world.velocity(point).x() == 4);  // 1 N/m by 4 m on 4 kg for 1 s
  CHECK(world.name_of(point) == "point");
  heavier.inverse_mass = -1;
  CHECK(complaint_of_any([&] { world.replace(point, heavier); }) ==
        "point: inverse mass is -1 1/kg; it must be 0 or more");
  const BodyHandle ball = world.add("ball", ball_body<Real>({0, 0, 0}));
  CHECK(complaint_of_any([&] { world.replace(point, world.body(ball)); }) ==
        "'point' is a point: replace it by a Particle");
  CHECK(complaint_of_any([&] { world.replace(ball, world.body(ball).centre); }) ==
        "'ball' is no point: replace it by a RigidBody");
}

TEST_CASE_TEMPLATE("A body that does nothing to the others changes no bit of how they move", Real,
                   EVERY_PRECISION) {
  const auto box = [](World<Real>& world) {
    world.add("box", make_rigid_body<Real>("box", mass_properties(Box<Real>{{1, 2, 3}}, 2), {},
                                           {0, 0, 5}, {1, 2, 3})
                         .body);
    world.add(Gravity<Real>{});
    world.add(AngularDamping<Real>{.rate = Real(0.1)});
  };
  World<Real> alone, crowded;
  box(alone);
  crowded.add("wall", make_static_body<Real>("wall", {}));
  crowded.add("far", make_particle<Real>(1, {std::numeric_limits<Real>::max(), 0, 0}));
  box(crowded);
  for (int n = 0; n < 100; ++n) {
    alone.step();
    crowded.step();
  }
  const RigidBody<Real> a = alone.body(alone.find("box")), b = crowded.body(crowded.find("box"));
  CHECK(same_bits(a.centre.position, b.centre.position));
  CHECK(same_bits(a.centre.velocity, b.centre.velocity));
  CHECK(same_bits(a.top.orientation.imaginary, b.top.orientation.imaginary));
  CHECK(a.top.orientation.real == b.top.orientation.real);
  CHECK(same_bits(a.top.angular_momentum_body, b.top.angular_momentum_body));
}

TEST_CASE("Bodies without a name come in any number, and a sentence calls them by their slot") {
  World<double> world;
  world.add("named", make_particle<double>(1, {0, 0, 0}));
  const BodyHandle one = world.add(make_particle<double>(1, {1, 0, 0}));
  const BodyHandle other = world.add(make_static_body<double>("wall", {}));
  CHECK(world.name_of(one) == "body 1");
  CHECK(world.name_of(other) == "body 2");
  CHECK(complaint_of([&] { (void)world.find("body 1"); }) == "no body is called 'body 1'");
  CHECK(complaint_of([&] {
          world.add("", make_particle<double>(1, {0, 0, 0}));
        }) == "a body needs a name");
  Particle<double> lost = make_particle<double>(1, {0, 0, 0});
  lost.velocity.x() = std::numeric_limits<double>::infinity();
  CHECK(complaint_of([&] { world.add(lost); }).find("a body: velocity is (inf, 0, 0) m/s") == 0);
  world.remove(one);
  CHECK(world.name_of(other) == "body 2");
  CHECK(world.body_count() == 2);
}
