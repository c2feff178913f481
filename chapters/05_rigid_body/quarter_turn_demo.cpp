// A long box is turned by 90 degrees and pushed by the same torque as before.
#include <numbers>
#include <support/record.hpp>
#include <tumble/make_rigid_body.hpp>
#include <tumble/solids.hpp>

using namespace tumble;
using std::numbers::pi;

namespace {

void print(const char* text, const Top<double>& top, const Vec3d& torque) {
  const auto rounded = [](double x) { return std::round(x * 1e6) / 1e6 + 0.0; };  // no -0.000
  const Mat3d I = world_inertia(top).unaryExpr(rounded);
  const Vec3d a = inverse_inertia_times(top, torque).unaryExpr(rounded);
  std::printf("%s\n", text);
  for (int row = 0; row < 3; ++row)
    std::printf("  | %6.3f %6.3f %6.3f |%s\n", I(row, 0), I(row, 1), I(row, 2),
                row == 1 ? "  kg m^2, world axes" : "");
  std::printf("  1 N m about world x: angular acceleration (%.2f, %.2f, %.2f) rad/s^2\n\n", a.x(),
              a.y(), a.z());
}

}  // namespace

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  const Vec3d torque(1, 0, 0);
  //! [quarter_turn]
  const auto box = mass_properties(Box<double>{{2, 0.2, 0.1}}, 3.0);  // long along x
  for (const double degrees : {0.0, 45.0, 90.0}) {
    const Posed pose{.orientation = quaternion_about(Vec3d(0, 0, 1), degrees / 180 * pi)};
    const Top<double> top = make_rigid_body("box", box, pose).body.top;
    print(support::number("turned by %.0f degrees about z:", degrees).c_str(), top, torque);
  }
  //! [quarter_turn]
  const auto along = [&](double degrees) {
    const Posed pose{.orientation = quaternion_about(Vec3d(0, 0, 1), degrees / 180 * pi)};
    return inverse_inertia_times(make_rigid_body("box", box, pose).body.top, torque).x();
  };
  notebook.value("ratio", support::number("%.0f", along(0) / along(90)));
  support::expect(along(0) > 50 * along(90), "the turned box resists over 50 times as much");
}
