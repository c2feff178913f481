// Bodies that cannot be, a rod and a point: what they get.
#include <support/record.hpp>
#include <tumble/make_rigid_body.hpp>
#include <tumble/solids.hpp>

using namespace tumble;

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  int refused = 0;
  const auto attempt = [&](const char* name, const MassProperties<double>& shape, const Posed& pose,
                           const Vec3d& spin, Turning turning) {
    try {
      const Vec3d i =
          make_rigid_body(name, shape, pose, Vec3d::Zero(), spin, turning).body.top.inverse_moments;
      std::printf("%s: made, inverse moments %s 1/(kg m^2)\n", name, text_of(i).c_str());
    } catch (const std::invalid_argument& error) {
      std::printf("%s\n", error.what());
      ++refused;
    }
  };
  const MassProperties<double> rod = mass_properties(ThinRod<double>{2}, 3.0), point{.mass = 3};
  MassProperties<double> kite = rod;
  kite.inertia.diagonal() = Vec3d(1, 2, 4);
  const Vec3d still = Vec3d::Zero();
  attempt("kite", kite, {}, still, Turning::free);
  attempt("top", mass_properties(Box<double>{{1, 1, 1}}, 1.0),
          {.orientation = {.real = 0.5, .imaginary = {0.5, 0, 0}}}, still, Turning::free);
  attempt("rod", rod, {}, still, Turning::free);
  attempt("point", point, {}, still, Turning::free);
  attempt("rod", rod, {}, {0, 0, 1}, Turning::locked_where_thin);
  attempt("rod", rod, {}, {1, 0, 0}, Turning::locked_where_thin);
  attempt("point", point, {}, still, Turning::locked);
  support::expect(refused == 5, "five of the seven are refused");
}
