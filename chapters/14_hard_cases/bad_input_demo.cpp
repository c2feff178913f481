// What comes into a world from outside and cannot be: a sentence, and the world is as it was.
#include <support/refusals.hpp>
#include <tumble/gravity.hpp>
#include <tumble/solids.hpp>
#include <tumble/springs.hpp>
#include <tumble/thruster.hpp>
#include <tumble/world.hpp>

using namespace tumble;

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  support::Table table = support::table_of_refusals(notebook, "bad_input");
  World<double> world(steps_per_second(60));
  const BodyHandle crate =
      world.add("crate", make_rigid_body("crate", mass_properties(Box<double>{{1, 1, 1}}, 1)).body);
  const Vec3d nowhere(std::numeric_limits<double>::quiet_NaN(), 0, 0), origin(0, 0, 0);
  int refused = 0;
  const auto attempt = [&](const char* what, const char* who, const auto& action) {
    refused += support::try_it(table, what, who, action);
  };
  const auto add = [&](const char* what, const auto& effect) {
    attempt(what, "World::add", [&] { world.add(effect, {crate}); });
  };
  attempt("a second body of the same name", "World::add",
          [&] { world.add("crate", make_particle(1.0)); });
  attempt("a velocity of 0/0", "World::set_velocity", [&] { world.set_velocity(crate, nowhere); });
  attempt("a blow of 0/0", "World::apply_impulse_at",
          [&] { world.apply_impulse_at(crate, nowhere, origin); });
  add("gravity of 0/0", Gravity<double>{.gravity = nowhere});
  add("a spring that pushes when it is stretched",
      SpringToPoint<double>{.spring = {.stiffness = -1}});
  add("a thruster that ends before it begins", Thruster<double>{.from = 2, .until = 1});
  attempt("a step into the past", "World", [] { World<double>(StepLength{-5, 1}); });
  support::expect(refused == 7 && world.body_count() == 1 && world.effects().empty(),
                  "all seven are refused, and the world is as it was");
}
