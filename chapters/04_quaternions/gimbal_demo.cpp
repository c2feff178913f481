// Three rings, one in the other: where the pitch is a quarter turn, two of their axes are one.
#include <array>
#include <numbers>
#include <support/on_page.hpp>
#include <support/record.hpp>
#include <tumble/rotation_vector.hpp>

using namespace tumble;
using std::numbers::pi;

namespace {

/// The axes in the world: the first is fixed, each other is carried by the rings before it.
struct Axes {
  Vec3d yaw, pitch, roll;
};

Axes axes_at(double yaw, double pitch) {
  const Quaterniond first = quaternion_about(Vec3d(0, 0, 1), yaw);
  const Quaterniond second = first * quaternion_about(Vec3d(0, 1, 0), pitch);
  return {Vec3d(0, 0, 1), rotate(first, Vec3d(0, 1, 0)), rotate(second, Vec3d(1, 0, 0))};
}

/// How much room the three axes span: 1 if they are perpendicular, 0 if they lie in a plane.
double room(const Axes& axes) {
  return axes.yaw.cross(axes.pitch).dot(axes.roll);
}

/// A ring that holds two axes: it lies in the plane of both. What is turned away from the reader
/// has a kind of its own.
void draw_ring(support::Table& out, const std::string& name, const Vec3d& one, const Vec3d& other,
               double radius, double right) {
  for (const bool front : {false, true}) {
    for (int n = 0; n <= 180; ++n) {
      const double angle = n * pi / 90;
      const Vec3d point = radius * (std::cos(angle) * one + std::sin(angle) * other);
      const auto [x, y] = support::on_page(point);
      const bool is_drawn = support::faces_reader(point) == front;
      out.row(front ? name : name + " back", is_drawn ? x + right : std::nan(""), y, 0.0, 0.0);
    }
    out.row("gap", std::nan(""), std::nan(""), 0.0, 0.0);
  }
}

void draw(support::Table& out, const Axes& axes, double right) {
  draw_ring(out, "outer", axes.yaw, axes.pitch, 1.0, right);
  draw_ring(out, "middle", axes.pitch, axes.roll, 0.84, right);
  draw_ring(out, "inner", axes.roll, axes.roll.cross(axes.pitch), 0.68, right);
  const auto arrow = [&](const char* name, const Vec3d& axis, double from, double to) {
    const auto [x, y] = support::on_page(from * axis);
    const auto [dx, dy] = support::on_page((to - from) * axis);
    out.row(name, x + right, y, dx, dy);
  };
  arrow("yaw", axes.yaw, 0.68, 1.45);
  arrow("pitch", axes.pitch, 0.84, 1.4);
  arrow("roll", axes.roll, 0, 0.68);
}

}  // namespace

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  support::Table rings = notebook.table("gimbal", {"kind", "x", "y", "dx", "dy"});
  draw(rings, axes_at(0.2, -0.8), 0);
  draw(rings, axes_at(0.2, -pi / 2), 3.4);

  std::puts("pitch (degrees)   room between the three axes");
  for (const int degrees : {0, 30, 60, 80, 89, 90}) {
    const double pitch = degrees * pi / 180, spanned = room(axes_at(0.2, -pitch));
    std::printf("%15d   %.4f\n", degrees, std::abs(spanned) < 1e-15 ? 0.0 : std::abs(spanned));
    support::expect(std::abs(std::abs(spanned) - std::cos(pitch)) < 1e-15,
                    "the room is the cosine of the pitch");
  }
}
