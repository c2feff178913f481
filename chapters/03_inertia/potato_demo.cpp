// The three axes and moments of a potato that is known by its skin alone.
#include <support/mesh_shapes.hpp>
#include <support/on_page.hpp>
#include <support/record.hpp>
#include <tumble/mesh_mass_properties.hpp>
#include <tumble/principal_axes.hpp>
#include <tumble/solids.hpp>

using namespace tumble;
using support::number;

namespace {

/// A sphere's mesh with bumps, a bend and unequal widths: without a mirror, and askew in its axes,
/// m.
Mesh<double> scanned_potato() {
  Mesh<double> potato = support::sphere_mesh(1.0, 3);
  for (Vec3d& vertex : potato.vertices) {
    const double x = vertex.x(), y = vertex.y(), z = vertex.z();
    const double bumps = 1 + 0.2 * x * y * (1 - z) - 0.2 * y * y * y + 0.12 * std::cos(5 * y) * z;
    const Vec3d swollen = bumps * Vec3d(3.6 * x, 5.4 * y, 2.5 * z);
    const Vec3d bent = swollen + 0.06 * swollen.y() * swollen.y() * Vec3d::UnitZ();
    // Askew, as the scanner found it.
    vertex = Vec3d(bent.x() - 0.6 * bent.y() + 0.8 * bent.z(), 0.85 * bent.y(),
                   bent.z() + 0.25 * bent.y() - 0.6 * bent.x()) /
             100;
  }
  return potato;
}

/// Where the ray from `centre` leaves the mesh: in one of its triangles, r = w₁ a + w₂ b + w₃ c for
/// weights that are none negative, as seen from the centre.
double distance_to_skin(const Mesh<double>& mesh, const Vec3d& centre, const Vec3d& direction) {
  double farthest = 0;
  for (const auto& [i, j, k] : mesh.triangles) {
    Mat3d corners;
    corners << mesh.vertices[i] - centre, mesh.vertices[j] - centre, mesh.vertices[k] - centre;
    const Vec3d weights = corners.inverse() * direction;
    if (weights.minCoeff() >= -1e-9) farthest = std::max(farthest, 1 / weights.sum());
  }
  return farthest;
}

void draw(support::Table& out, const Mesh<double>& mesh, const MassPropertiesd& body,
          const Mat3d& axes) {
  const auto row = [&](const char* kind, const Vec3d& from, const Vec3d& to, const char* text) {
    const auto [x, y] = support::on_page(from);
    const auto [dx, dy] = support::on_page(to - from);
    out.row(kind, x, y, dx, dy, text);
  };
  for (const auto& [i, j, k] : mesh.triangles) {
    const Vec3d a = mesh.vertices[i], b = mesh.vertices[j], c = mesh.vertices[k];
    if (!support::faces_reader((b - a).cross(c - a))) continue;
    for (const Vec3d& corner : {a, b, c, a}) row("skin", corner, corner, "");
    out.row("gap", std::nan(""), std::nan(""), 0.0, 0.0, "");
  }
  const Vec3d centre = body.centre_of_mass;
  for (int i = 0; i < 3; ++i) {
    const Vec3d axis = axes.col(i) * (support::faces_reader(axes.col(i)) ? 1 : -1);
    const Vec3d leaves = centre + axis * distance_to_skin(mesh, centre, axis);
    // Longer where it points at the reader, and so looks short.
    const auto [across, up] = support::on_page(axis);
    const double length = std::min(0.06, 0.022 / std::hypot(across, up));
    const Vec3d tip = leaves + length * axis, beyond = leaves + 1.3 * length * axis;
    row("inside", centre, leaves, "");
    row("outside", leaves, tip, "");
    row("label", beyond, beyond, std::to_string(i + 1).c_str());
  }
  row("centre", centre, centre, "");
}

}  // namespace

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  //! [potato]
  const Mesh<double> potato = scanned_potato();
  const MassPropertiesd body = mass_properties_of_density(potato, 1080);
  const auto [moments, axes] = principal_axes(body.inertia, "potato");
  //! [potato]
  std::printf("%zu triangles, %.0f cm^3, %.3f kg\n", potato.triangles.size(), 1e6 * volume(potato),
              body.mass);
  std::printf("\ntensor in the scanner's axes (kg cm^2)\n");
  for (int i = 0; i < 3; ++i)
    std::printf("  %8.4f %8.4f %8.4f\n", 1e4 * body.inertia(i, 0), 1e4 * body.inertia(i, 1),
                1e4 * body.inertia(i, 2));
  std::printf("\naxis   moment (kg cm^2)   direction\n");
  for (int i = 0; i < 3; ++i)
    std::printf("  %d    %10.4f        (%6.3f, %6.3f, %6.3f)\n", i + 1, 1e4 * moments(i),
                axes(0, i), axes(1, i), axes(2, i));
  const Mat3d turned = axes.transpose() * body.inertia * axes;
  // Two products of three terms, each rounded a few times.
  support::expect((turned - Mat3d(moments.asDiagonal())).norm() < 16 * 0x1p-53 * moments.sum(),
                  "in these axes no product is left");
  support::expect(std::abs(body.inertia(0, 1)) > 0.05 * moments(2), "the scan was askew");
  support::Table drawing = notebook.table("potato", {"kind", "x", "y", "dx", "dy", "text"});
  draw(drawing, potato, body, axes);
  notebook.value("triangles", std::to_string(potato.triangles.size()));
  notebook.value("ratio", number("%.1f", moments(2) / moments(0)));
}
