// A rod and a point, of which a zero cannot be inverted: what they get.
#include <support/refusals.hpp>
#include <tumble/make_rigid_body.hpp>
#include <tumble/solids.hpp>

using namespace tumble;

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  support::Table table = support::table_of_refusals(notebook, "bad_bodies");
  int refused = 0;
  const auto attempt = [&](const char* what, const char* name, const MassProperties<double>& shape,
                           const Vec3d& spin, Turning turning) {
    refused += support::try_it(table, what, "make_rigid_body", [&] {
      make_rigid_body(name, shape, {}, Vec3d::Zero(), spin, turning);
    });
  };
  const MassProperties<double> rod = mass_properties(ThinRod<double>{2}, 3.0), point{.mass = 3};
  const Vec3d still = Vec3d::Zero();
  attempt("a rod without thickness", "rod", rod, still, Turning::free);
  attempt("a point", "point", point, still, Turning::free);
  attempt("a rod, locked where it is thin, that spins about its line", "rod", rod, {0, 0, 1},
          Turning::locked_where_thin);
  attempt("the same rod, spinning about another axis", "rod", rod, {1, 0, 0},
          Turning::locked_where_thin);
  attempt("a point, locked about every axis", "point", point, still, Turning::locked);
  support::expect(refused == 3, "three of the five are refused");
}
