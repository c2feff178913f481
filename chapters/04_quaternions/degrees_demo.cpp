// A mistake, run on purpose: degrees where radians belong.
#include <numbers>
#include <support/record.hpp>
#include <tumble/rotation_vector.hpp>

using namespace tumble;

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  const Vec3d axis(0, 0, 1);
  std::printf("meant            passed as   turned by\n");
  for (const double degrees : {1.0, 10.0, 45.0, 90.0, 180.0, 360.0}) {
    const Vec3d turned = rotation_vector_of(quaternion_about(axis, degrees));
    const double turned_degrees = turned.z() * 180 / std::numbers::pi;
    std::printf("%4.0f degrees   %5.0f rad   %+7.1f degrees\n", degrees, degrees, turned_degrees);
    if (degrees == 90) notebook.value("turned_90", support::number("%.1f", turned_degrees));
    support::expect(std::abs(turned_degrees - degrees) > 1, "degrees are not radians");
  }
  const Quaterniond right = quaternion_about(axis, 90 * std::numbers::pi / 180);
  support::expect(std::abs(angle_between({}, right) - std::numbers::pi / 2) < 1e-15,
                  "90 degrees are half of pi radians");
}
