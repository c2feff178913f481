// What a world tells of itself: news, warnings and the table of its plan.
#include <fcntl.h>
#include <unistd.h>

#include <course/checks.hpp>
#include <cstdio>
#include <tumble/air_and_water.hpp>
#include <tumble/gravity.hpp>
#include <tumble/solids.hpp>
#include <tumble/springs.hpp>
#include <tumble/world.hpp>

using namespace tumble;
using namespace tumble::course;

namespace {

template <class Real>
RigidBody<Real> box_body(const Vec3<Real>& place) {
  return make_rigid_body<Real>("box", mass_properties(Box<Real>{{1, 2, 3}}, 2), {place}).body;
}

/// A spring on which no step of a second is safe.
template <class Real>
constexpr Spring<Real> stiff = {.stiffness = 500};

/// What is written to standard error meanwhile.
template <class Action>
std::string said_to_standard_error(const Action& action) {
  std::FILE* file = std::tmpfile();
  REQUIRE(file);
  std::fflush(stderr);
  const int kept = ::dup(2);
  ::dup2(::fileno(file), 2);
  action();
  std::fflush(stderr);
  ::dup2(kept, 2);
  ::close(kept);
  std::rewind(file);
  std::string text;
  for (int letter = std::fgetc(file); letter != EOF; letter = std::fgetc(file))
    text += static_cast<char>(letter);
  std::fclose(file);
  return text;
}

}  // namespace

TEST_CASE_TEMPLATE("News name the pass, whom it visits of those it is meant for, and the cause",
                   Real, EVERY_PRECISION) {
  World<Real> world;
  std::vector<BodyHandle> bodies;
  for (const char* name : {"a", "b", "c", "d"})
    bodies.push_back(world.add(name, make_particle<Real>(1, {1, 2, 3})));
  world.step();
  const EffectHandle gravity = world.add(Gravity<Real>{}, {bodies[0]});
  world.step();
  CHECK(world.news() ==
        std::vector<std::string>{"step 1: kick visits 1 of 4, before 0 ('gravity' came)",
                                 "step 1: drift visits 1 of 4, before 0 ('gravity' came)",
                                 "step 1: gravity visits 1 of 1, before 0 ('gravity' came)"});
  world.add(SpringBetween<Real>{.spring = {.stiffness = 1}},
            {bodies[0], bodies[1], bodies[2], bodies[3]});
  CHECK(world.news().back() ==
        "step 2: spring between bodies visits 2 of 2, before 0 ('spring between bodies' came)");
  world.step();
  world.change(gravity, Gravity<Real>{{0, 0, 0}});
  CHECK(world.news().back() == "step 3: gravity visits 0 of 1, before 1 ('gravity' was changed)");
  world.step();
  world.change(gravity, Gravity<Real>{});
  world.step();
  world.add("e", box_body<Real>({0, 0, 0}));
  world.set_angular_velocity(world.find("e"), {1, 2, 3});
  CHECK(world.news().back() ==
        "step 5: tumbling: splitting visits 1 of 5, before 0 ('e' came, 'e' got its first spin)");
  const std::size_t so_far = world.news().size();
  world.step();
  world.remove(gravity);
  world.set_velocity(bodies[3], {0, 0, 0});
  world.remove(bodies[3]);
  CHECK(world.news().size() > so_far);
  CHECK(world.news().back().find("('gravity' was removed, 'd' was removed)") != std::string::npos);
}

TEST_CASE_TEMPLATE("Whatever changes a spring is warned of anew, and nothing else is", Real,
                   EVERY_PRECISION) {
  World<Real> world(steps_per_second(1));
  std::vector<std::string> told;
  world.on_warning([&](const std::string& warning) { told.push_back(warning); });
  const auto tells = [&](std::size_t count) {
    told.clear();
    world.step();
    CHECK(told.size() == count);
  };
  world.add("stone", make_particle<Real>(1));
  const BodyHandle box = world.add("box", box_body<Real>({0, 0, 0}));
  const BodyHandle end = world.add("end", box_body<Real>({0, 0, 0}));
  const EffectHandle held = world.add(SpringToPoint<Real>{.spring = stiff<Real>}, {box});
  tells(1);
  CHECK(told[0].find("'spring' on 'box' may gain energy") == 0);
  world.set_position(end, {9, 0, 0});
  tells(0);
  world.replace(box, box_body<Real>({0, 0, 0}));
  tells(1);
  world.change(held, SpringToPoint<Real>{.spring = stiff<Real>, .attachment = {1, 0, 0}});
  tells(1);
  world.add(SpringBetween<Real>{.spring = stiff<Real>}, {end, box});
  tells(1);
  world.remove(held);
  tells(1);
  CHECK(told[0].find("'spring between bodies' on 'end' may gain energy") == 0);
  world.remove(end);
  tells(0);
}

TEST_CASE_TEMPLATE("A spring for everyone is limited by the lightest, and named by the first", Real,
                   EVERY_PRECISION) {
  for (const bool light_comes_first : {true, false}) {
    World<Real> world(steps_per_second(1));
    world.add("first", make_particle<Real>(light_comes_first ? 1 : 4));
    world.add("second", make_particle<Real>(light_comes_first ? 4 : 1));
    world.add(SpringToPoint<Real>{.spring = {.stiffness = 16}});
    CHECK(world.spring_limit().time_step == Real(0.5));  // 2/sqrt(16/1), of squares: no rounding
    REQUIRE(world.warnings().size() == 1);
    const std::string warning =
        "'spring' on 'first' may gain energy without bound: the time step is 1 s, and only up to "
        "0.5 s can this be excluded";
    CHECK(world.warnings()[0] == warning);
    const std::string table = table_of(world.plan());
    CHECK(table.substr(table.rfind("\nwarning: ")) == "\nwarning: " + warning + "\n");
  }
}

TEST_CASE("A warning that nobody asked for goes to standard error") {
  World<double> world(steps_per_second(1));
  world.add("ball", make_particle<double>(1));
  world.add(SpringToPoint<double>{.spring = stiff<double>});
  CHECK(said_to_standard_error([&] { world.step(); }) == "warning: " + world.warnings()[0] + "\n");
  CHECK(said_to_standard_error([&] { world.step(); }) == "");
}

TEST_CASE("Each reason in a row of a plan is counted, and all are named") {
  World<double> world;
  world.add("wall", make_static_particle<double>({0, 0, 0}));
  world.add("nail", make_static_body<double>("nail", {}));
  world.add("point", make_particle<double>(1));
  world.add(AngularDamping<double>{.rate = 1});
  for (const PlanRow& row : world.plan().rows)
    if (row.effect == "angular damping")
      CHECK(row.reason == "not 2: points do not turn; not 1: locked about every axis");
}

TEST_CASE_TEMPLATE("An effect that needs a top is refused a point, at first and when it changes",
                   Real, EVERY_PRECISION) {
  World<Real> world;
  const BodyHandle point = world.add("point", make_particle<Real>(1));
  const BodyHandle box = world.add("box", box_body<Real>({0, 0, 0}));
  const std::string sentence =
      "'spring between bodies' needs an orientation, and 'point' is a point";
  using Joint = SpringBetween<Real>;
  const Vec3<Real> off(1, 0, 0);
  CHECK(complaint_of([&] { world.add(Joint{.attachment_first = off}, {point, box}); }) == sentence);
  CHECK(complaint_of([&] {
          world.add(Joint{.attachment_second = off}, {box, point});
        }) == sentence);
  const EffectHandle joint = world.add(Joint{.attachment_second = off}, {point, box});
  CHECK(complaint_of([&] { world.change(joint, Joint{.attachment_first = off}); }) == sentence);
  world.change(joint, Joint{});
  CHECK(world.effects()[0].targets.size() == 2);
}
