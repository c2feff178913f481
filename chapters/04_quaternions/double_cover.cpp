// Two whole turns about z, and what the arrow and its quaternion do meanwhile.
#include <numbers>
#include <support/record.hpp>
#include <tumble/rotation_vector.hpp>

using namespace tumble;

namespace {

/// To four digits, and without the sign of a rounded zero.
double shown(double x) {
  return std::round(x * 1e4) / 1e4 + 0.0;
}

}  // namespace

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  support::Table table = notebook.table("double_cover", {"turned (degree)", "x of the arrow",
                                                         "real part", "z of the imaginary part"});
  std::printf("turned by      quaternion (w, z)     the arrow (x, y)\n");
  for (int degrees = 0; degrees <= 720; degrees += 6) {
    const Quaterniond q = quaternion_about(Vec3d(0, 0, 1), degrees * std::numbers::pi / 180);
    const Vec3d arrow = rotate(q, Vec3d(1, 0, 0));
    table.row(degrees, arrow.x(), q.real, q.imaginary.z());
    if (degrees % 90 == 0)
      std::printf("%9d    (%7.4f, %7.4f)    (%4.1f, %4.1f)\n", degrees, shown(q.real),
                  shown(q.imaginary.z()), shown(arrow.x()), shown(arrow.y()));
  }
}
