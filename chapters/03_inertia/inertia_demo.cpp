// A long thin box: three axes, three answers to the same torque; and a sphere beside it.
#include <support/record.hpp>
#include <tumble/force.hpp>
#include <tumble/spheres.hpp>
#include <tumble/torque.hpp>
#include <tumble/validate_inertia.hpp>

using namespace tumble;
using support::number;

namespace {

const Vec3d size(2, 0.3, 0.15);

/// Where a point in space is drawn: seen from the right, from the front and from above.
Vec3d drawn(const Vec3d& r) {
  return {0.92 * r.x() + 0.4 * r.y(), 0, r.z() - 0.14 * r.x() + 0.3 * r.y()};
}

void draw_box(const support::Notebook& notebook, const Vec3d& moments) {
  support::Table table =
      notebook.table("hardest_axis", {"kind", "x (m)", "z (m)", "dx (m)", "dz (m)", "text"});
  const Vec3d half = size / 2;
  const auto face = [&](const char* kind, const Vec3d& middle, const Vec3d& a, const Vec3d& b) {
    for (const auto& [i, j] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {-1, -1}}) {
      const Vec3d at = drawn(middle + i * a + j * b);
      table.row(kind, at.x(), at.z(), 0.0, 0.0, "");
    }
  };
  const Vec3d x(half.x(), 0, 0), y(0, half.y(), 0), z(0, 0, half.z());
  face("front", -y, x, z);
  face("top", z, x, y);
  face("side", x, y, z);
  const double longest[] = {1.35, 1.1, 0.6};
  for (int i = 0; i < 3; ++i) {
    const Vec3d tip = drawn(Vec3d::Unit(i) * longest[i]), begin = drawn(Vec3d::Unit(i) * half(i));
    table.row(i == 1 ? "axis behind" : "axis", begin.x(), begin.z(), tip.x() - begin.x(),
              tip.z() - begin.z(), "");
    const Vec3d label = tip + Vec3d(i == 2 ? 0.08 : 0.06, 0, i == 2 ? 0.05 : 0.07);
    table.row("label", label.x(), label.z(), 0.0, 0.0,
              std::string(1, "xyz"[i]) + number(": %.3f kg m²", moments(i)));
  }
}

}  // namespace

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  const double mass = 3;
  const MassPropertiesd box = mass_properties(Box<double>{size}, mass);
  const MassPropertiesd sphere = mass_properties(Sphere<double>{0.3}, mass);
  const Vec3d moments = box.inertia.diagonal();
  draw_box(notebook, moments);

  std::printf("a box of %g x %g x %g m and a sphere of radius 0.3 m, %g kg each\n\n", size.x(),
              size.y(), size.z(), mass);
  std::printf("a torque of 1 N m about    box             sphere\n");
  const Mat3d box_inverse = inverse_inertia("box", box.inertia);
  const Mat3d sphere_inverse = inverse_inertia("sphere", sphere.inertia);
  for (int i = 0; i < 3; ++i)
    std::printf("   %c                       %6.2f rad/s^2   %6.2f rad/s^2\n", "xyz"[i],
                box_inverse.col(i)(i), sphere_inverse.col(i)(i));

  //! [push]
  const Vec3d push(0, 12, 0), point(0.25, 0, 0);  // N, and m from the centre of mass
  const Vec3d torque = torque_about(Vec3d::Zero().eval(), point, push);
  const Vec3d box_answer = box_inverse * torque, sphere_answer = sphere_inverse * torque;
  //! [push]
  std::printf("\nthe same push of %g N, %g m from the centre\n", push.y(), point.x());
  std::printf("   the centre speeds up by %6.2f m/s^2     %6.2f m/s^2\n", push.y() / box.mass,
              push.y() / sphere.mass);
  std::printf("   the turning speeds up by %5.2f rad/s^2   %6.2f rad/s^2\n", box_answer.z(),
              sphere_answer.z());
  notebook.value("about_x", number("%.3f kg m²", moments.x()));
  notebook.value("about_y", number("%.3f kg m²", moments.y()));
  notebook.value("about_z", number("%.3f kg m²", moments.z()));
  notebook.value("ratio_box", number("%.0f", moments.maxCoeff() / moments.minCoeff()));
  notebook.value("ratio_push", number("%.1f", sphere_answer.z() / box_answer.z()));

  // A push along a slant of the box: the answer does not point where the torque points.
  const Vec3d slanted(1, 1, 0);
  const Vec3d answer = box_inverse * slanted;
  const double degrees =
      std::acos(answer.normalized().dot(slanted.normalized())) * 180 / std::numbers::pi;
  std::printf("\na torque of (1, 1, 0) N m gives (%.2f, %.2f, %.2f) rad/s^2\n", answer.x(),
              answer.y(), answer.z());
  std::printf("   %.0f degrees away from the torque\n", degrees);
  notebook.value("degrees_away", number("%.0f", degrees));
}
