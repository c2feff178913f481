// The volume of a box that lies away from the origin, as tetrahedra that have a corner there and a
// sign.
#include <array>
#include <support/mesh_shapes.hpp>
#include <support/on_page.hpp>
#include <support/record.hpp>

using namespace tumble;

namespace {

/// Draws one tetrahedron and the box, `right` of the place of the first.
void draw(support::Table& out, const char* sign, const Mesh<double>& box,
          const std::array<std::size_t, 3>& triangle, double right) {
  const auto corner = [&](const char* kind, const Vec3d& at) {
    const auto [x, y] = support::on_page(at);
    out.row(kind, x + right, y);
  };
  const auto gap = [&] { out.row("gap", std::nan(""), std::nan("")); };
  const Vec3d origin(0, 0, 0);
  for (int side = 0; side < 3; ++side) {
    corner(sign, origin);
    corner(sign, box.vertices[triangle[static_cast<std::size_t>(side)]]);
    corner(sign, box.vertices[triangle[static_cast<std::size_t>((side + 1) % 3)]]);
    gap();
  }
  for (std::size_t from = 0; from < 8; ++from)
    for (const std::size_t bit : {1u, 2u, 4u}) {
      if (from & bit) continue;
      corner("edge", box.vertices[from]);
      corner("edge", box.vertices[from | bit]);
      gap();
    }
  corner("origin", origin);
}

}  // namespace

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  support::Table drawing = notebook.table("signed", {"kind", "x", "y"});
  const Vec3d size(0.8, 1.2, 0.7);
  Mesh<double> box = support::box_mesh(size);
  for (Vec3d& vertex : box.vertices) vertex += Vec3d(0, 1.7, 0.5);

  double added = 0, taken = 0;
  for (const auto& [a, b, c] : box.triangles) {
    const double volume = box.vertices[a].dot(box.vertices[b].cross(box.vertices[c])) / 6;
    (volume > 0 ? added : taken) += volume;
  }
  std::printf("tetrahedra that count    %+.3f m^3\n", added);
  std::printf("those taken away again   %+.3f m^3\n", taken);
  std::printf("together                 %+.3f m^3\n", added + taken);
  std::printf("the box                  %+.3f m^3\n", size.prod());
  support::expect(std::abs(added + taken - size.prod()) < 1e-14, "they leave the box");
  support::expect(taken < -0.1, "some face the origin");
  draw(drawing, "added", box, {2, 6, 7}, 0);
  draw(drawing, "taken", box, {0, 1, 5}, 3.3);
}
