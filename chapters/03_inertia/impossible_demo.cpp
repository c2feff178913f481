// What a tensor gets that no real body can have.
#include <support/record.hpp>
#include <support/refusals.hpp>
#include <tumble/solids.hpp>
#include <tumble/validate_inertia.hpp>

using namespace tumble;
using support::try_it;

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  const auto tensor = [](double x, double y, double z, double xy = 0, double yx = 0) {
    Mat3d inertia = Vec3d(x, y, z).asDiagonal();
    inertia(0, 1) = xy;
    inertia(1, 0) = yx;
    return inertia;
  };
  const auto check = [](const Mat3d& inertia) { require_invertible_inertia("hammer", inertia); };
  int refused = 0;
  refused += try_it("moments of 1, 2 and 4", [&] { check(tensor(1, 2, 4)); });
  refused += try_it("moments of 1, 2 and 3: a flat plate", [&] { check(tensor(1, 2, 3)); });
  refused += try_it("a product larger than its moments", [&] { check(tensor(1, 1, 1, 2, 2)); });
  refused += try_it("a product without its mirror image", [&] { check(tensor(1, 1, 1, 0.5, 0)); });
  refused += try_it("a rod without thickness",
                    [] { inverse_inertia("rod", mass_properties(ThinRod<double>{6}, 1).inertia); });
  support::expect(refused == 4, "all but the plate are refused");
}
