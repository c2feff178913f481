// A mistake, run on purpose: p x F - x x F is the same on paper and loses its digits far away.
#include <support/record.hpp>
#include <tumble/torque.hpp>

using namespace tumble;

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  std::printf("from the origin   (p - x) x F is off by   p x F - x x F is off by\n");
  const Vec3f arm(0.5f, 0.25f, -0.125f), force(0.1f, -0.7f, 0.3f);
  const Vec3d exact = arm.cast<double>().cross(force.cast<double>());
  double last = 0;
  for (const float kilometres : {0.0f, 0.1f, 1.0f, 10.0f, 100.0f}) {
    // Rounded to 1/64 m the positions are exact in float, so all that is lost is the formula's.
    const float distance = std::round(kilometres * 1000 * 64) / 64;
    const Vec3f centre(distance, distance, distance), point = centre + arm;
    const Vec3f near = torque_about(centre, point, force);
    const Vec3f far = point.cross(force) - centre.cross(force);
    const auto relative_error = [&exact](const Vec3f& torque) {
      return (torque.cast<double>() - exact).norm() / exact.norm();
    };
    last = relative_error(far);
    std::printf("%12g km   %18.1e   %24.1e\n", kilometres, relative_error(near), last);
    support::expect(relative_error(near) < 1e-6, "the lever arm keeps its digits");
    if (kilometres == 10.0f)
      notebook.value("error_10_km", support::number("%.2f %%", 100 * relative_error(far)));
  }
  support::expect(last > 1e-3, "the difference of two large torques loses them");
}
