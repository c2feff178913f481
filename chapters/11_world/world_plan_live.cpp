// A small world, live: effects are switched on and off, and the plan says what a step consists of.
#include <support/live.hpp>
#include <tumble/air_and_water.hpp>
#include <tumble/gravity.hpp>
#include <tumble/solids.hpp>
#include <tumble/spheres.hpp>
#include <tumble/springs.hpp>
#include <tumble/thruster.hpp>
#include <tumble/world.hpp>

using namespace tumble;

namespace {

using Column = std::vector<double>;

const double seconds = 3;

/// Text as a column: its letters' codes.
void write(Column& column, std::string_view text) {
  for (const char letter : text) column.push_back(static_cast<unsigned char>(letter));
}

/// Of each line the name, whom it visits, and why; a line ends with 10, a part with 9.
void write_plan(support::Live& live, const Plan& plan) {
  Column &lines = live.column("plan", ""), &visited = live.column("visited", ""),
         &of = live.column("of", "");
  for (const PlanRow& row : plan.rows) {
    write(lines, row.effect + "\t" + row.reason + "\n");
    visited.push_back(static_cast<double>(row.visited));
    of.push_back(static_cast<double>(row.of));
  }
  Column& warnings = live.column("warnings", "");
  for (const std::string& warning : plan.warnings) write(warnings, warning + "\n");
}

}  // namespace

void tumble::support::run_live(Live& live) {
  const bool gravity = live.choice("gravity", 1, 2) == 1, air = live.choice("air", 0, 2) == 1,
             spring = live.choice("spring", 1, 2) == 1,
             thruster = live.choice("thruster", 0, 2) == 1;
  const double spin = live.knob("spin", "rad/s", 0, 0, 20);
  const auto rate = std::llround(live.knob("rate", "1/s", 60, 5, 480));
  const double h = 1 / static_cast<double>(rate);

  World<double> world(steps_per_second(rate));
  world.on_warning([](const std::string&) {});  // the figure tells it
  const MassPropertiesd solid = mass_properties(Box<double>{{0.3, 0.5, 0.8}}, 1);
  const BodyHandle post = world.add("post", make_static_particle(Vec3d(0, 0, 3)));
  const BodyHandle ball =
      world.add("ball", make_rigid_body<double>("ball", mass_properties(Sphere<double>{0.15}, 1),
                                                {{0.5, 0, 1.4}}, {0, 0, 0}, {0, 3, 0})
                            .body);
  const BodyHandle drop = world.add("drop", make_particle<double>(0.05, {-1.5, 0, 1}, {0.5, 0, 4}));
  const BodyHandle box =
      world.add("box", make_rigid_body<double>("box", solid, {{1.5, 0, 1}}, {-0.3, 0, 5},
                                               Vec3d(0.3 * spin, spin, 0.1 * spin))
                           .body);
  if (gravity) world.add(Gravity<double>{});
  if (air) world.add(QuadraticDrag<double>{.coefficient = 0.05});
  if (spring)
    world.add(SpringBetween<double>{.spring = {.stiffness = 400, .rest_length = 1.2}},
              {post, ball});
  if (thruster) world.add(Thruster<double>{.force_body = {0, 0, 2}, .point = {0.1, 0.2, 0}}, {box});
  write_plan(live, world.plan());

  Column& time = live.column("time", "s");
  const std::array bodies = {post, ball, drop, box};
  const std::array<std::string_view, 4> names = {"post", "ball", "drop", "box"};
  std::array<std::array<Column*, 2>, 4> places{};
  for (std::size_t n = 0; n < bodies.size(); ++n)
    places[n] = {&live.column(std::string(names[n]) + " x", "m"),
                 &live.column(std::string(names[n]) + " z", "m")};
  std::array<Column*, 4> turn = {&live.column("q real", ""), &live.column("q x", ""),
                                 &live.column("q y", ""), &live.column("q z", "")};
  const auto note = [&](double t) {
    time.push_back(t);
    for (std::size_t n = 0; n < bodies.size(); ++n) {
      const Vec3d position = world.body(bodies[n]).centre.position;
      places[n][0]->push_back(position.x());
      places[n][1]->push_back(position.z());
    }
    const Quaterniond q = world.body(box).top.orientation;
    turn[0]->push_back(q.real);
    for (int axis = 0; axis < 3; ++axis)
      turn[static_cast<std::size_t>(axis) + 1]->push_back(q.imaginary[axis]);
  };
  note(0);
  for (int n = 1; n <= seconds * static_cast<double>(rate); ++n) {
    world.step();
    note(n * h);
  }
}
