// Whom each pass of a step visits: in a small world as it stands, and while that world is changed.
// And how the world finds out.
#include <algorithm>
#include <support/record.hpp>
#include <tumble/air_and_water.hpp>
#include <tumble/gravity.hpp>
#include <tumble/solids.hpp>
#include <tumble/spheres.hpp>
#include <tumble/springs.hpp>
#include <tumble/thruster.hpp>
#include <tumble/world.hpp>

using namespace tumble;

namespace {

struct SmallWorld {
  World<double> world;
  BodyHandle drop, coin;
  EffectHandle thruster, drag;
};

SmallWorld small_world() {
  SmallWorld small;
  World<double>& world = small.world;
  const auto body = [&](const char* name, const MassPropertiesd& solid, const Vec3d& place,
                        const Vec3d& angular_velocity) {
    return world.add(
        name, make_rigid_body<double>(name, solid, {place}, {0, 0, 0}, angular_velocity).body);
  };
  const MassPropertiesd brick = mass_properties(Box<double>{{0.3, 0.5, 0.8}}, 1);
  world.add("post", make_static_particle<double>({0, 0, 3}));
  small.drop = world.add("drop", make_particle<double>(0.05, {-1.5, 0, 1}));
  const BodyHandle ball =
      body("ball", mass_properties(Sphere<double>{0.15}, 1), {0.5, 0, 1.4}, {0, 0, 0});
  const BodyHandle box = body("box", brick, {1.5, 0, 1}, {0, 0, 0});
  body("brick", brick, {4, 0, 1}, {0, 3, 0});
  small.coin =
      body("coin", mass_properties(Box<double>{{0.02, 0.02, 0.002}}, 0.005), {6, 0, 0}, {0, 0, 0});
  world.add(Gravity<double>{}, {small.drop, ball, box});
  world.add(SpringToPoint<double>{.spring = {.stiffness = 400, .rest_length = 1.2},
                                  .anchor = {0, 0, 3},
                                  .attachment = {0, 0, 0.15}},
            {ball});
  small.thruster =
      world.add(Thruster<double>{.force_body = {0, 0, 5}, .point = {0, 0.2, 0}}, {box});
  small.drag = world.add(QuadraticDrag<double>{});
  world.add(AngularDamping<double>{.rate = 0.1});
  return small;
}

/// Calls `visit` with each effect and each motion and which of the two it is, in the order of a
/// step.
template <class Visit>
void for_each_row(const World<double>& world, const Visit& visit) {
  const StepPlan<double>& plan = world.step_plan();
  for (const Pass<double>& pass : all_passes(plan, plan.substeps))
    if (pass.row.kind != PassKind::input) visit(instance_of(pass, plan), pass.row.kind);
}

bool is_visited(const World<double>& world, const EffectInstance<double>& pass, BodyIndex body) {
  const BodyIndex top = world.bodies().top_of[body];
  const bool by_its_top = pass.effect->traits().visits_tops();
  if (by_its_top && top == no_index) return false;
  return pass.members.indices.contains(by_its_top ? top : body);
}

bool is_meant(const World<double>& world, const EffectInstance<double>& pass, BodyIndex body) {
  return pass.everyone || std::ranges::count(pass.targets, world.handle_at(body)) > 0;
}

/// A cell for each pass and each body: whether the plan visits it, and the exhaustive run.
void show_members(support::Notebook& notebook) {
  const World<double> world = small_world().world;
  support::Table table = notebook.table(
      "members", {"pass", "row", "body", "column", "visited", "visited exhaustively"});
  std::size_t rows = 0, visits = 0, exhaustive_visits = 0;
  for_each_row(world, [&](const EffectInstance<double>& pass, PassKind kind) {
    ++rows;
    for (BodyIndex body = 0; body < world.body_count(); ++body) {
      const bool visited = is_visited(world, pass, body);
      const bool exhaustively = is_meant(world, pass, body) &&
                                is_visited_exhaustively(*pass.effect, kind, world.bodies(), body);
      support::expect(exhaustively || !visited, "the exhaustive run leaves out no member");
      visits += visited;
      exhaustive_visits += exhaustively;
      table.row(pass.effect->name(), double(rows), world.name_of(world.handle_at(body)),
                double(body) + 1, double(visited), double(exhaustively));
    }
  });
  notebook.value("visits", std::to_string(visits));
  notebook.value("exhaustive_visits", std::to_string(exhaustive_visits));
  notebook.value("cells", std::to_string(rows * world.body_count()));
}

/// A torque about z, written as a user would.
struct Motor {
  static constexpr std::string_view name = "motor";
  Vec3d torque(const Topd&, double) const { return {0, 0, 1}; }
};

/// What each round finds out about a ball at rest whose motor is switched on.
void show_rounds(support::Notebook& notebook) {
  World<double> world;
  world.add("ball", make_rigid_body<double>("ball", mass_properties(Sphere<double>{0.1}, 1)).body);
  world.add(QuadraticDrag<double>{.coefficient = 0.01});
  world.add(Magnus<double>{.strength = 0.01});
  world.add(Motor{});
  const BodyFlags alone = flags_alone(state_of(world.bodies(), 0), false);
  BodyFlags flags = alone;
  support::Table table = notebook.table("rounds", {"effect", "row", "round", "acts", "says"});
  bool news = true;
  int round = 0;
  while (news) {
    news = false;
    ++round;
    int row = 0;
    for (const EffectInstance<double>& instance : world.effects()) {
      const std::string why(instance.effect->skip_reason(flags));
      const BodyFlags before = flags;
      if (why.empty() && note(flags, instance.effect->traits().writes)) news = true;
      std::string found = flags.is_torqued > before.is_torqued ? "it can turn" : "";
      if (flags.is_pushed > before.is_pushed) found = "it can move";
      table.row(instance.effect->name(), double(++row), double(round), double(why.empty()),
                !why.empty()    ? why
                : found.empty() ? "nothing new"
                                : found);
    }
  }
  support::expect(
      round == 3 && flags == flags_under<double>(alone,
                                                 [&](const auto& visit) {
                                                   for (const EffectInstance<double>& instance :
                                                        world.effects())
                                                     visit(*instance.effect);
                                                 }),
      "the drawing's rounds find what the world finds");
}

/// How many bodies each pass visits in each step, while the world is changed.
void show_changes(support::Notebook& notebook) {
  SmallWorld small = small_world();
  const std::initializer_list<std::string_view> columns = {
      "step",           "gravity",        "spring",           "thruster",
      "quadratic drag", "kick",           "kick of the spin", "angular damping",
      "drift",          "steady turning", "tumbling"};
  support::Table table = notebook.table("changes", columns);
  for (int step = 0; step <= 100; ++step) {
    if (step == 20) small.world.set_angular_velocity(small.coin, {0, 0, 30});
    if (step == 40)
      small.world.change(small.drag, QuadraticDrag<double>{.coefficient = 0.01, .wind = {2, 0, 0}});
    if (step == 60) small.world.change(small.thruster, Thruster<double>{});
    if (step == 80) small.world.remove(small.drop);
    std::vector<double> visited;
    for_each_row(small.world, [&](const EffectInstance<double>& pass, PassKind) {
      visited.push_back(double(pass.members.size()));
      support::expect(
          visited.size() < columns.size() &&
              std::string_view(pass.effect->name()).starts_with(columns.begin()[visited.size()]),
          "each pass stands in the column with its name");
    });
    support::expect(visited.size() + 1 == columns.size(), "no column is without its pass");
    table.row(double(step), visited[0], visited[1], visited[2], visited[3], visited[4], visited[5],
              visited[6], visited[7], visited[8], visited[9]);
    small.world.step();
  }
}

}  // namespace

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  show_members(notebook);
  show_rounds(notebook);
  show_changes(notebook);
}
