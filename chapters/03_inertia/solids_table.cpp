// The table of solids: 1 kg of each, with 1 m wherever a size is wanted.
#include <course/record.hpp>
#include <tumble/spheres.hpp>
#include <tumble/tetrahedron.hpp>

using namespace tumble;
using course::number;

int main(int argument_count, char** arguments) {
  course::Notebook notebook(argument_count, arguments);
  course::Table table =
      notebook.table("solids", {"shape", "sizes", "I_x", "I_y", "I_z", "for 1 kg and 1 m (kg m²)"});
  int count = 0;
  const auto row = [&](const char* shape, const char* sizes, const char* x, const char* y,
                       const char* z, const MassPropertiesd& body) {
    const Vec3d moments = body.inertia.diagonal();
    table.row(shape, sizes, x, y, z,
              number("%.4f, ", moments.x()) + number("%.4f, ", moments.y()) +
                  number("%.4f", moments.z()));
    std::printf("%-16s %8.4f %8.4f %8.4f\n", shape, moments.x(), moments.y(), moments.z());
    ++count;
  };
  row("box", "edges a, b, c", "m(b² + c²)/12", "m(a² + c²)/12", "m(a² + b²)/12",
      mass_properties(Box<double>{{1, 1, 1}}, 1));
  row("solid sphere", "radius r", "2mr²/5", "the same", "the same",
      mass_properties(Sphere<double>{1}, 1));
  row("hollow sphere", "radius r", "2mr²/3", "the same", "the same",
      mass_properties(HollowSphere<double>{1}, 1));
  row("spherical shell", "radii a < b", "2m(b⁵ − a⁵)/5(b³ − a³)", "the same", "the same",
      mass_properties(SphericalShell<double>{0.5, 1}, 1));
  row("ellipsoid", "semi-axes a, b, c", "m(b² + c²)/5", "m(a² + c²)/5", "m(a² + b²)/5",
      mass_properties(Ellipsoid<double>{{1, 1, 1}}, 1));
  row("cylinder", "radius r, height h", "m(3r² + h²)/12", "as I_x", "mr²/2",
      mass_properties(Cylinder<double>{1, 1}, 1));
  row("capsule", "radius r, length l", "from its parts", "as I_x", "from its parts",
      mass_properties(Capsule<double>{1, 1}, 1));
  row("cone", "radius r, height h", "3m(4r² + h²)/80", "as I_x", "3mr²/10",
      mass_properties(Cone<double>{1, 1}, 1));
  row("thin rod", "length l", "ml²/12", "as I_x", "0", mass_properties(ThinRod<double>{1}, 1));
  row("thin plate", "width a, height b", "mb²/12", "ma²/12", "m(a² + b²)/12",
      mass_properties(ThinPlate<double>{1, 1}, 1));
  row("tetrahedron", "corner at 0, edges of 1 along the axes", "from its corners", "as I_x",
      "as I_x",
      mass_properties(
          Tetrahedron<double>{{Vec3d(0, 0, 0), Vec3d(1, 0, 0), Vec3d(0, 1, 0), Vec3d(0, 0, 1)}},
          1));
  notebook.value("count", number("%.0f", count));
}
