// A mistake, run on purpose: the moment of a rod about its end, found in a table, is used for a rod
// that flies freely and so turns about its centre.
#include <support/record.hpp>
#include <tumble/solids.hpp>
#include <tumble/torque.hpp>

using namespace tumble;
using support::number;

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  const double length = 2, mass = 3;
  const MassPropertiesd rod = mass_properties(ThinRod<double>{length}, mass);
  const Vec3d end(0, 0, length / 2), push(1, 0, 0);
  const double about_centre = rod.inertia(1, 1);
  const double about_end = inertia_about(rod, end)(1, 1);
  const double torque = torque_about(rod.centre_of_mass, end, push).y();
  std::printf("about the centre   %.2f m l^2   the push turns it by %.2f rad/s^2\n",
              about_centre / (mass * length * length), torque / about_centre);
  std::printf("about the end      %.2f m l^2   the push turns it by %.2f rad/s^2\n",
              about_end / (mass * length * length), torque / about_end);
  const double ratio = about_end / about_centre;
  notebook.value("ratio", number("%.0f", ratio));
  support::expect(std::abs(ratio - 4) < 1e-14, "the wrong tensor is four times too large");

  support::Table table = notebook.table(
      "parallel_axis",
      {"distance from the centre (m)", "parallel axis theorem (kg m²)", "200 particles (kg m²)"});
  const int count = 200;
  for (int n = -12; n <= 12; ++n) {
    const double distance = n * 0.125;
    double particles = 0;
    for (int i = 0; i < count; ++i) {
      const double z = ((i + 0.5) / count - 0.5) * length;
      particles += inertia_of_particle(mass / count, Vec3d(0, 0, z - distance))(1, 1);
    }
    table.row(distance, inertia_about(rod, Vec3d(0, 0, distance))(1, 1), particles);
  }
}
