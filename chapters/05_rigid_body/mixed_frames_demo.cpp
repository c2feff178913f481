// A torque that is given in world axes is used as if it were given in the body's own.
#include <numbers>
#include <support/record.hpp>
#include <tumble/make_rigid_body.hpp>
#include <tumble/solids.hpp>

using namespace tumble;
using std::numbers::pi;

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  const auto satellite = mass_properties(Box<double>{{1, 1, 2}}, 10.0);
  const Vec3d torque(0, 0, 1);  // about the world's upright
  std::printf("a satellite that has rolled about x, turned by 1 N m about world z for 1 s\n");
  std::printf("rolled by     right: turns about       wrong: turns about\n");
  for (const double degrees : {0.0, 45.0, 90.0, 180.0}) {
    const Posed pose{.orientation = quaternion_about(Vec3d(1, 0, 0), degrees / 180 * pi)};
    const Bodyd start = make_rigid_body("satellite", satellite, pose).body;
    //! [mixed]
    Bodyd right = start, wrong = start;
    add_angular_momentum(right.top, torque);
    wrong.top.angular_momentum_body += torque;  // world numbers into a body's vector
    //! [mixed]
    const auto rounded = [](double x) { return std::round(x * 1e6) / 1e6 + 0.0; };  // no -0.00
    const Vec3d a = angular_velocity_world(right.top).unaryExpr(rounded);
    const Vec3d b = angular_velocity_world(wrong.top).unaryExpr(rounded);
    std::printf("%5.0f deg    (%5.2f, %5.2f, %5.2f) rad/s  (%5.2f, %5.2f, %5.2f) rad/s\n", degrees,
                a.x(), a.y(), a.z(), b.x(), b.y(), b.z());
    const bool agree = (a - b).norm() < 1e-12;
    support::expect(agree == (degrees == 0), "the two agree only before the satellite has rolled");
    if (degrees == 180.0)
      support::expect(b.z() < 0, "upside down, the wrong one turns the other way");
  }
}
