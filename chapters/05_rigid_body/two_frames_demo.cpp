// One torque on a plate that is turned: read in world axes and in the plate's own, and what the
// plate answers.
#include <array>
#include <numbers>
#include <support/record.hpp>
#include <tumble/make_rigid_body.hpp>
#include <tumble/solids.hpp>

using namespace tumble;

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  support::Table drawing = notebook.table("two_frames", {"kind", "x", "y", "dx", "dy"});
  const Vec3d size(2.4, 0.9, 0.1);
  const Quaterniond turned = quaternion_about(Vec3d(0, 0, 1), 35 * std::numbers::pi / 180);
  const auto plate = mass_properties(Box<double>{size}, 3.0);
  const Top<double> top = make_rigid_body("plate", plate, Posed{.orientation = turned}).body.top;

  const Vec3d torque(1.5, 0.25, 0);               // N m, world axes
  const Vec3d own = rotate_back(turned, torque);  // the same, in the plate's axes
  const Vec3d answer = inverse_inertia_times(top, torque);
  std::printf("torque, world axes        (%6.3f, %6.3f, 0) N m\n", torque.x(), torque.y());
  std::printf("torque, the plate's axes  (%6.3f, %6.3f, 0) N m\n", own.x(), own.y());
  std::printf("the plate starts to turn about (%.2f, %.2f, 0), world axes\n",
              answer.normalized().x(), answer.normalized().y());
  support::expect(std::abs(own.norm() - torque.norm()) < 1e-15, "it is one arrow");
  support::expect(std::abs(answer.normalized().dot(torque.normalized())) < 0.99,
                  "the answer does not point along the torque");

  const auto arrow = [&](const char* kind, const Vec3d& from, const Vec3d& by) {
    drawing.row(kind, from.x(), from.y(), by.x(), by.y());
  };
  for (const auto& [x, y] : {std::array{1, 1}, {1, -1}, {-1, -1}, {-1, 1}, {1, 1}}) {
    const Vec3d corner = rotate(turned, Vec3d(x * size.x() / 2, y * size.y() / 2, 0));
    arrow("plate", corner, Vec3d(0, 0, 0));
  }
  const Vec3d origin(0, 0, 0), along_x(torque.x(), 0, 0);
  const Vec3d along_first = rotate(turned, Vec3d(own.x(), 0, 0));
  arrow("torque", origin, torque);
  arrow("world", origin, along_x);
  arrow("world", along_x, torque - along_x);
  arrow("body", origin, along_first);
  arrow("body", along_first, torque - along_first);
  arrow("answer", origin, 1.3 * answer.normalized());
  const auto name = [&](const char* kind, const Vec3d& at) { arrow(kind, at, Vec3d(0, 0, 0)); };
  name("its name", torque);
  name("answer's name", 1.3 * answer.normalized());
}
