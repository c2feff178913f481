// A book on a table, turned about two axes in both orders.
#include <array>
#include <support/on_page.hpp>
#include <support/record.hpp>
#include <tumble/rotation_matrix.hpp>
#include <tumble/rotation_vector.hpp>

using namespace tumble;

namespace {

/// Such as "+y"; the numbers of this program are all within rounding of 0 or 1.
std::string direction(const Vec3d& v) {
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {1.0, -1.0})
      if ((v - sign * Vec3d::Unit(axis)).norm() < 1e-15)
        return (sign > 0 ? "+" : "-") + std::string(1, "xyz"[axis]);
  return "askew";
}

void print(const char* what, const Quaterniond& book) {
  const Vec3d cover(0, 0, 1), spine(0, 1, 0);  // in the book's own axes
  const std::string cover_faces = direction(rotate(book, cover)),
                    spine_points = direction(rotate(book, spine));
  std::printf("%-38s the cover faces %s, the spine points along %s\n", what, cover_faces.c_str(),
              spine_points.c_str());
}

/// The faces of a book that a reader sees, `right` of the place where the first one lies.
void draw(support::Table& poses, int number, const Quaterniond& book, double right) {
  const Vec3d half(0.7, 1, 0.2);  // in its own axes; its spine runs along y, at -x
  const auto turned = [&book](const Vec3d& v) { return rotate(book, v); };
  support::for_each_seen_side(half, turned, [&](int axis, int side, const auto& corners) {
    const char* what = axis == 2 && side > 0 ? "cover" : axis == 0 && side < 0 ? "spine" : "page";
    for (const auto& [x, y] : corners)
      poses.row(std::string(what) + " " + std::to_string(number), x + right, y, 0.0, 0.0);
    poses.row("gap", std::nan(""), std::nan(""), 0.0, 0.0);
  });
  // From the foot of the spine to its head, along an edge that is seen.
  const bool is_cover_seen = support::faces_reader(rotate(book, Vec3d(0, 0, 1)));
  const double edge = is_cover_seen ? half.z() : -half.z();
  const auto [x, y] = support::on_page(rotate(book, Vec3d(-half.x(), -half.y(), edge)));
  const auto [dx, dy] = support::on_page(rotate(book, Vec3d(0, 2.7, 0)));
  poses.row("head", x + right, y, dx, dy);
}

/// A vector, its parts along the axis of a turn and across it, and what becomes of each.
void draw_parts(support::Table& parts) {
  const Vec3d n(0, 0, 1), v(1.0, -0.2, 0.95);
  const Quaterniond q = quaternion_about(n, 115 * std::numbers::pi / 180);
  const Vec3d along = v.dot(n) * n, across = v - along;
  const Vec3d turned = rotate(q, v), turned_across = rotate(q, across);
  support::expect((rotate(q, along) - along).norm() == 0, "what lies along the axis stays");
  support::expect((turned - (along + turned_across)).norm() < 1e-15, "the parts make the whole");
  const auto row = [&](const char* kind, const Vec3d& from, const Vec3d& to) {
    const auto [x, y] = support::on_page(from);
    const auto [dx, dy] = support::on_page(to - from);
    parts.row(kind, x, y, dx, dy);
  };
  const Vec3d origin = Vec3d::Zero();
  row("axis", origin, 1.75 * n);
  row("along", origin, along);
  row("v", origin, v);
  row("across", along, v);
  row("turned", origin, turned);
  row("turned across", along, turned);
  const int points = 72;
  for (int point = 0; point <= points; ++point) {
    const Quaterniond part = quaternion_about(n, 2 * std::numbers::pi * point / points);
    const Vec3d at = along + rotate(part, across);
    row("circle", at, at);
  }
  for (int point = 0; point <= points; ++point) {
    const Quaterniond part =
        quaternion_of_rotation_vector(Vec3d(rotation_vector_of(q) * (double(point) / points)));
    const Vec3d at = along + 0.45 * rotate(part, across);
    row("angle", at, at);
  }
}

}  // namespace

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  //! [book]
  const double quarter = std::numbers::pi / 2;
  const Quaterniond about_x = quaternion_about(Vec3d(1, 0, 0), quarter);
  const Quaterniond about_z = quaternion_about(Vec3d(0, 0, 1), quarter);
  const Quaterniond lying = {};

  print("as it lies", lying);
  print("a quarter turn about x", about_x * lying);
  print("... and then one about the world's z", about_z * about_x * lying);
  print("... or one about the book's own z", about_x * about_z * lying);
  //! [book]
  print("first z, then x, both the world's", about_x * about_z);
  support::expect(angle_between(about_z * about_x, about_x * about_z) > 1,
                  "the order of two turns matters");

  support::Table poses = notebook.table("poses", {"kind", "x", "y", "dx", "dy"});
  const std::array drawn{lying, about_x, about_z * about_x, about_z, about_x * about_z};
  for (int n = 0; n < 5; ++n) draw(poses, n, drawn[static_cast<std::size_t>(n)], 3.4 * n);

  for (int axis = 0; axis < 3; ++axis) {
    const auto [dx, dy] = support::on_page(Vec3d::Unit(axis));
    poses.row(std::string("axis ") + "xyz"[axis], 0.0, 0.0, dx, dy);
  }

  support::Table parts = notebook.table("parts", {"kind", "x", "y", "dx", "dy"});
  draw_parts(parts);

  const Quaterniond both = about_z * about_x;
  const Vec3d axis = rotation_vector_of(both).normalized();
  const double degrees = rotation_vector_of(both).norm() * 180 / std::numbers::pi;
  std::printf("\nx and then z is one turn by %.0f degrees about (%.4f, %.4f, %.4f)\n", degrees,
              axis.x(), axis.y(), axis.z());
  notebook.value("degrees", support::number("%.0f", degrees));
}
