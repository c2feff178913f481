// The table of solids: 1 kg of each, with 1 m wherever a size is wanted.
#include <support/record.hpp>
#include <tumble/spheres.hpp>
#include <tumble/tetrahedron.hpp>

using namespace tumble;
using support::number;

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  support::Table table =
      notebook.table("solids", {"solid", "I_x", "I_y", "I_z", "1 kg, 1 m (kg m²)"});
  const auto row = [&](const char* solid, const char* x, const char* y, const char* z,
                       const MassPropertiesd& body) {
    const Vec3d moments = body.inertia.diagonal();
    // Spaces that do not break keep the three together.
    table.row(solid, x, y, z,
              number("%.3f\u00a0\u00a0", moments.x()) + number("%.3f\u00a0\u00a0", moments.y()) +
                  number("%.3f", moments.z()));
    std::printf("%-36s %8.4f %8.4f %8.4f\n", solid, moments.x(), moments.y(), moments.z());
  };
  row("box with edges a, b, c", "m(b²+c²)/12", "m(a²+c²)/12", "m(a²+b²)/12",
      mass_properties(Box<double>{{1, 1, 1}}, 1));
  row("thin plate, width a, height b", "mb²/12", "ma²/12", "m(a²+b²)/12",
      mass_properties(ThinPlate<double>{1, 1}, 1));
  row("thin rod, length l", "ml²/12", "ml²/12", "0", mass_properties(ThinRod<double>{1}, 1));
  row("ellipsoid, semi-axes a, b, c", "m(b²+c²)/5", "m(a²+c²)/5", "m(a²+b²)/5",
      mass_properties(Ellipsoid<double>{{1, 1, 1}}, 1));
  row("solid sphere, radius r", "2mr²/5", "2mr²/5", "2mr²/5",
      mass_properties(Sphere<double>{1}, 1));
  row("hollow sphere, radius r", "2mr²/3", "2mr²/3", "2mr²/3",
      mass_properties(HollowSphere<double>{1}, 1));
  row("spherical shell, radii a < b", "2m(b⁵−a⁵)/(5(b³−a³))", "as I_x", "as I_x",
      mass_properties(SphericalShell<double>{0.5, 1}, 1));
  row("cylinder, radius r, height h", "m(3r²+h²)/12", "as I_x", "mr²/2",
      mass_properties(Cylinder<double>{1, 1}, 1));
  row("cone, radius r, height h", "3m(4r²+h²)/80", "as I_x", "3mr²/10",
      mass_properties(Cone<double>{1, 1}, 1));
  row("capsule, radius r, length l", "sum of its parts", "as I_x", "sum of its parts",
      mass_properties(Capsule<double>{1, 1}, 1));
  const Vec3d o(0, 0, 0), x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  row("tetrahedron", "sum over its corners", "likewise", "likewise",
      mass_properties(Tetrahedron<double>{{o, x, y, z}}, 1));
}
