// A mistake, run on purpose: an angular velocity in world axes, multiplied on the body's side.
#include <support/on_page.hpp>
#include <support/record.hpp>
#include <tumble/orientation.hpp>

using namespace tumble;
using std::numbers::pi;
using support::on_page;

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  support::Table paths =
      notebook.table("wrong_side", {"right x", "right y", "right is near", "wrong x", "wrong y",
                                    "wrong is near", "globe x", "globe y"});
  support::Table marks = notebook.table("wrong_side_marks", {"kind", "x", "y", "dx", "dy", "text"});

  const Vec3d nose(1, 0, 0);  // in body axes
  const Quaterniond start = quaternion_about(Vec3d(0, 1, 0), -0.6);
  const int steps = 240;
  //! [wrong_side]
  const Vec3d omega_world(0, 0, 1);
  const double h = 2 * pi / steps;
  Quaterniond right = start, wrong = start;
  double lowest_right = 1, lowest_wrong = 1;
  for (int n = 0; n <= steps; ++n) {
    const Vec3d right_nose = rotate(right, nose), wrong_nose = rotate(wrong, nose);
    right = quaternion_of_rotation_vector<double>(h * omega_world) * right;
    wrong = wrong * quaternion_of_rotation_vector<double>(h * omega_world);  // !
    //! [wrong_side]
    lowest_right = std::min(lowest_right, right_nose.z());
    lowest_wrong = std::min(lowest_wrong, wrong_nose.z());
    const auto [right_x, right_y] = on_page(right_nose);
    const auto [wrong_x, wrong_y] = on_page(wrong_nose);
    paths.row(right_x, right_y, double(support::faces_reader(right_nose)), wrong_x, wrong_y,
              double(support::faces_reader(wrong_nose)), std::cos(n * h), std::sin(n * h));
    if (n % 60 == 0)
      std::printf("turned by %3d degrees: the nose at height %6.3f, or at %6.3f\n", n * 360 / steps,
                  right_nose.z(), std::round(wrong_nose.z() * 1e3) / 1e3 + 0.0);
  }
  const auto mark = [&](const char* kind, const Vec3d& from, const Vec3d& by) {
    const auto [x, y] = on_page(from);
    const auto [dx, dy] = on_page(by);
    marks.row(kind, x, y, dx, dy, "");
  };
  const Vec3d z(0, 0, 1), own_z = rotate(start, z);
  mark("right", Vec3d(0, 0, 0), 1.35 * z);
  mark("wrong", Vec3d(0, 0, 0), 1.35 * own_z);
  const auto label = [&](const Vec3d& at, double dx, double dy, const char* text) {
    const auto [x, y] = on_page(at);
    marks.row("label", x + dx, y + dy, 0.0, 0.0, text);
  };
  label(1.35 * z, -0.15, -0.05, "ω");
  label(1.35 * own_z, 0.5, -0.05, "the body's z");
  label(rotate(start, nose), -0.05, 0.17, "start");
  mark("dot", rotate(start, nose), Vec3d(0, 0, 0));

  notebook.value("height", support::number("%.3f", std::sin(0.6)));
  support::expect(std::abs(lowest_right - std::sin(0.6)) < 1e-12, "about z the height stays");
  support::expect(std::abs(lowest_wrong + std::sin(0.6)) < 1e-3, "about its own z it goes below");

  // Why it is so often overlooked: from rest, and about one axis, both sides agree.
  Quaterniond left_side, right_side;
  for (int n = 0; n < steps; ++n) {
    left_side = turn_exponential(left_side, omega_world, h);
    right_side = turn_exponential_body(right_side, omega_world, h);
  }
  std::printf("\nstarted from no turn, the two sides end %g rad apart\n",
              angle_between(left_side, right_side));
  support::expect(angle_between(left_side, right_side) == 0, "no test from rest can tell them");
}
