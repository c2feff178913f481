// What a tensor gets that no real body can have.
#include <support/refusals.hpp>
#include <tumble/solids.hpp>
#include <tumble/validate_inertia.hpp>

using namespace tumble;

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  const auto tensor = [](double x, double y, double z, double xy = 0, double yx = 0) {
    Mat3d inertia = Vec3d(x, y, z).asDiagonal();
    inertia(0, 1) = xy;
    inertia(1, 0) = yx;
    return inertia;
  };
  support::Table table = support::table_of_refusals(notebook, "impossible");
  int refused = 0;
  const auto attempt = [&](const char* what, const Mat3d& inertia) {
    refused += support::try_it(table, what, "require_invertible_inertia",
                               [&] { require_invertible_inertia("hammer", inertia); });
  };
  attempt("moments of 1, 2 and 4", tensor(1, 2, 4));
  attempt("moments of 1, 2 and 3: a flat plate", tensor(1, 2, 3));
  attempt("a product larger than its moments", tensor(1, 1, 1, 2, 2));
  attempt("a product without its mirror image", tensor(1, 1, 1, 0.5, 0));
  refused += support::try_it(table, "a rod without thickness", "inverse_inertia", [] {
    inverse_inertia("rod", mass_properties(ThinRod<double>{6}, 1).inertia);
  });
  support::expect(refused == 4, "all but the plate are refused");
}
