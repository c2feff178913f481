// What a world tells of itself: news, warnings and the table of its plan.
#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <support/box_body.hpp>
#include <support/checks.hpp>
#include <tumble/air_and_water.hpp>
#include <tumble/gravity.hpp>
#include <tumble/solids.hpp>
#include <tumble/spheres.hpp>
#include <tumble/springs.hpp>
#include <tumble/thruster.hpp>
#include <tumble/world.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

/// A spring on which no step of a second is safe.
template <class Real>
constexpr Spring<Real> stiff = {.stiffness = 500};

/// Whether the sentence is among the news.
template <class AnyWorld>
bool told(const AnyWorld& world, const std::string& sentence) {
  const std::vector<std::string> news = world.change_log();
  return std::find(news.begin(), news.end(), sentence) != news.end();
}

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

TEST_CASE_TEMPLATE(
    "ChangeLog names the pass, how many it visits of those it is meant for, and the cause", Real,
    EVERY_PRECISION) {
  World<Real> world;
  std::vector<BodyHandle> bodies;
  for (const char* name : {"a", "b", "c", "d"})
    bodies.push_back(world.add(name, make_particle<Real>(1, {1, 2, 3})));
  world.step();
  const EffectHandle gravity = world.add(Gravity<Real>{}, {bodies[0]});
  world.step();
  CHECK(world.change_log() ==
        std::vector<std::string>{"step 1: kick visits 1 of 4, before 0 ('gravity' came)",
                                 "step 1: drift visits 1 of 4, before 0 ('gravity' came)",
                                 "step 1: gravity visits 1 of 1, before 0 ('gravity' came)"});
  world.add(SpringBetween<Real>{.spring = {.stiffness = 1}},
            {bodies[0], bodies[1], bodies[2], bodies[3]});
  CHECK(world.change_log().back() ==
        "step 2: spring between bodies visits 2 of 2, before 0 ('spring between bodies' came)");
  world.step();
  world.change(gravity, Gravity<Real>{{0, 0, 0}});
  CHECK(world.change_log().back() ==
        "step 3: gravity visits 0 of 1, before 1 ('gravity' was changed)");
  world.step();
  world.change(gravity, Gravity<Real>{});
  world.step();
  world.turn_by(Steady{});
  const BodyHandle box = world.add("e", box_body<Real>({0, 0, 0}));
  world.set_angular_velocity(box, {1, 2, 3});
  CHECK(world.change_log().back() ==
        "step 5: tumbling: steady visits 1 of 5, before 0 (another method of turning was chosen, "
        "'e' came, 'e' got its first spin)");
  world.step();
  world.add(Thruster<Real>{.force_body = {1, 0, 0}, .point = {0, 1, 0}}, {box});
  CHECK(told(world, "step 6: kick of the spin visits 1 of 5, before 0 ('thruster' came)"));
  world.step();
  const auto ball = mass_properties(Sphere<Real>{1}, 1);
  world.add("f", make_rigid_body<Real>("f", ball, {}, {0, 0, 0}, {0, 0, 1}).body);
  CHECK(told(world, "step 7: steady turning visits 1 of 6, before 0 ('f' came)"));
  world.step();
  const std::size_t so_far = world.change_log().size();
  world.step();
  world.remove(gravity);
  world.set_velocity(bodies[3], {0, 0, 0});
  world.remove(bodies[3]);
  CHECK(world.change_log().size() > so_far);
  CHECK(world.change_log().back().find("('gravity' was removed, 'd' was removed)") !=
        std::string::npos);
}

TEST_CASE_TEMPLATE(
    "A change of a spring or of the scheme brings the warning anew, and nothing else does", Real,
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
  world.change(held, SpringToPoint<Real>{.spring = {.stiffness = 600}});
  tells(1);
  const EffectHandle loose =
      world.add(SpringToPoint<Real>{.spring = {.stiffness = Real(0.01)}}, {box});
  tells(1);
  world.change(loose, SpringToPoint<Real>{});  // no spring any more
  tells(1);
  world.remove(loose);
  tells(1);
  world.step_by(Scheme::verlet);
  tells(1);
  world.add(SpringBetween<Real>{.spring = {.stiffness = 500, .rest_length = 9}}, {end, box});
  tells(1);
  const BodyHandle third = world.add("third", box_body<Real>({0, 5, 0}));
  tells(0);
  world.add(SpringBetween<Real>{.spring = {.stiffness = 500, .rest_length = 5}}, {third, box});
  tells(1);
  world.remove(third);
  tells(1);
  world.remove(held);
  tells(1);
  CHECK(told[0].find("'spring between bodies' on 'end' may gain energy") == 0);
  world.remove(end);
  tells(0);
  world.add(SpringToPoint<Real>{.spring = stiff<Real>});
  tells(1);
  world.add("new", make_particle<Real>(1));  // held by it too
  tells(1);
}

TEST_CASE_TEMPLATE("A spring for everyone is limited by the lightest, which is named", Real,
                   EVERY_PRECISION) {
  for (int lightest = 0; lightest < 3; ++lightest) {
    World<Real> world(steps_per_second(1));
    for (int n = 0; n < 3; ++n)
      world.add("body " + std::to_string(n), make_particle<Real>(n == lightest ? 1 : 4));
    const EffectHandle springs = world.add(SpringToPoint<Real>{.spring = {.stiffness = 16}});
    CHECK(world.step_limit().time_step == Real(0.5));  // 2/sqrt(16/1), of squares: no rounding
    REQUIRE(world.warnings().size() == 1);
    const std::string warning = "'spring' on 'body " + std::to_string(lightest) +
                                "' may gain energy without bound: the "
                                "time step is 1 s, and only up to 0.5 s can this be excluded";
    CHECK(world.warnings()[0] == warning);
    const std::string table = table_of(world.plan());
    CHECK(table.substr(table.rfind("\nwarning: ")) == "\nwarning: " + warning + "\n");
    world.change(springs, SpringToPoint<Real>{.spring = {.stiffness = 4}});
    CHECK(world.warnings().empty());  // the step is the limit itself
  }
}

TEST_CASE("A warning that nobody asked for goes to standard error") {
  World<double> world(steps_per_second(1));
  world.add("ball", make_particle<double>(1));
  world.add(SpringToPoint<double>{.spring = stiff<double>});
  CHECK(said_to_standard_error([&] { world.step(); }) == "warning: " + world.warnings()[0] + "\n");
  CHECK(said_to_standard_error([&] { world.step(); }) == "");
}

TEST_CASE("A row of a plan counts those that the effect is meant for, and each reason") {
  World<double> world;
  for (const PlanRow& row : world.plan().rows) CHECK(row.reason == "there is no body");
  const BodyHandle wall = world.add("wall", make_static_particle<double>({0, 0, 0}));
  world.add("nail", make_static_body<double>("nail", {}));
  const BodyHandle point = world.add("point", make_particle<double>(1));
  const BodyHandle box = world.add("box", box_body<double>({0, 0, 0}));
  world.add(AngularDamping<double>{.rate = 1});
  world.add(Gravity<double>{}, {wall, point});
  world.add(SpringToPoint<double>{.spring = {.stiffness = 1}, .name = "held"}, {box});
  world.add(
      SpringToPoint<double>{.spring = {.stiffness = 1}, .attachment = {1, 0, 0}, .name = "bent"},
      {box});
  world.add(Thruster<double>{.force_body = {1, 0, 0}}, {box});
  const auto row = [plan = world.plan()](const std::string& effect) {
    return *std::find_if(plan.rows.begin(), plan.rows.end(),
                         [&](const PlanRow& one) { return one.effect == effect; });
  };
  CHECK(row("angular damping").reason ==
        "not 2: points do not turn; not 1: locked about every axis");
  CHECK(row("gravity").reason == "not 1: nothing can move them");
  CHECK(row("gravity").of == 2);
  CHECK(row("held").writes == "force");
  CHECK(row("bent").writes == "force, torque");
  CHECK(row("thruster").reads == "time, orientation");
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

TEST_CASE_TEMPLATE("The news names three causes and counts the others", Real, EVERY_PRECISION) {
  const auto news_after = [](int changes) {
    World<Real> world;
    const BodyHandle box = world.add("box", box_body<Real>({0, 0, 0}));
    world.step();  // what was there at the first step is no news
    for (int n = 0; n < changes; ++n) world.replace(box, box_body<Real>({Real(n), 0, 0}));
    world.set_velocity(box, {1, 0, 0});
    std::string all;
    for (const std::string& sentence : world.change_log()) all += sentence;
    return all;
  };
  const std::string replaced = "'box' was replaced", moved = "'box' got its first velocity";
  CHECK(news_after(2).find(replaced + ", " + replaced + ", " + moved) != std::string::npos);
  CHECK(news_after(2).find(" more") == std::string::npos);
  CHECK(news_after(5).find(replaced + ", " + replaced + ", " + replaced + " and 3 more") !=
        std::string::npos);
}

TEST_CASE_TEMPLATE("The last hundred sentences of news are kept", Real, EVERY_PRECISION) {
  World<Real> world;
  world.step();
  for (int n = 0; n < 150; ++n) {
    world.add(std::to_string(n), make_particle<Real>(1, {0, 0, 0}, {1, 0, 0}));
    world.step();
  }
  CHECK(world.change_log().size() == 100);
  CHECK(world.change_log().back() == "step 150: drift visits 150 of 150, before 149 ('149' came)");
}

TEST_CASE_TEMPLATE("A warning reaches the function that one gives, once for each change", Real,
                   EVERY_PRECISION) {
  World<Real> world(steps_per_second(10));
  std::vector<std::string> told;
  world.on_warning([&](const std::string& warning) { told.push_back(warning); });
  const BodyHandle ball = world.add("ball", make_particle<Real>(1));
  world.add(SpringToPoint<Real>{.spring = {.stiffness = 500}}, {ball});
  for (int n = 0; n < 3; ++n) world.step();
  REQUIRE(told.size() == 1);
  CHECK(told[0] == world.warnings()[0]);
  world.add("other", make_particle<Real>(1));  // no spring holds it
  world.step();
  CHECK(told.size() == 1);
  // A copy tells the same function, and what that throws comes before anything moves.
  const SpringToPoint<Real> stiff{.spring = {.stiffness = 500}};
  World<Real> copy = world;
  copy.add(stiff, {copy.find("other")});
  copy.step();
  CHECK(told.size() > 1);
  world.on_warning([](const std::string& warning) { throw std::runtime_error(warning); });
  world.add(stiff, {world.find("other")});
  CHECK_THROWS_AS(world.step(), std::runtime_error);
  CHECK(world.ticks() == 4);
}
