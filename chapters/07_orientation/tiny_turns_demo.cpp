// A million turns too small to see, in float and in double.
#include <numbers>
#include <support/record.hpp>
#include <tumble/orientation.hpp>

using namespace tumble;

namespace {

template <class Real>
double reached(const Quaternion<Real>& start, double turn) {
  const Vec3<Real> omega = Vec3<Real>(1, 2, 2) / 3;
  Quaternion<Real> q = start;
  for (int n = 0; n < 1'000'000; ++n) q = turn_exponential(q, omega, static_cast<Real>(turn));
  return static_cast<double>(angle_between(start, q));
}

}  // namespace

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  const Quaternionf tilted_float = checked_orientation<float>({0.5f, {0.5f, -0.5f, 0.5f}}, "start");
  const Quaterniond tilted = checked_orientation<double>({0.5, {0.5, -0.5, 0.5}}, "start");
  std::printf("a million turns of   make, in double   in float   in float, from a tilt\n");
  double lost = 0;
  for (const double turn : {1e-6, 3e-7, 1e-7, 3e-8, 1e-8}) {
    const double in_double = reached(tilted, turn), in_float = reached(Quaternionf(), turn),
                 from_a_tilt = reached(tilted_float, turn);
    std::printf("%14g rad   %13.6f   %10.4f   %20.4f\n", turn, in_double, in_float, from_a_tilt);
    support::expect(std::abs(in_double / (1e6 * turn) - 1) < 1e-6, "double keeps them all");
    lost = from_a_tilt;
    if (turn == 1e-7) {
      notebook.value("too_large", support::number("%.0f %%", 100 * (from_a_tilt / 0.1 - 1)));
      const double seconds = 2 * std::numbers::pi / (60 * turn);
      notebook.value("days", support::number("%.0f", seconds / (24 * 3600)));
      support::expect(from_a_tilt > 0.11, "in float, from a tilt, such turns are rounded up");
    }
  }
  support::expect(lost == 0, "in float, a turn below the rounding of a component is lost");
}
