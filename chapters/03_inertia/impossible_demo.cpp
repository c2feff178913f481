// What a tensor gets that no matter can have, and a mesh that encloses nothing.
#include <course/mesh_shapes.hpp>
#include <course/record.hpp>
#include <tumble/mesh_mass_properties.hpp>
#include <tumble/solids.hpp>
#include <tumble/validate_inertia.hpp>

using namespace tumble;

namespace {

int refused = 0;

template <class Action>
void try_it(const char* what, const Action& action) {
  try {
    action();
    std::printf("%s\n   is taken\n", what);
  } catch (const std::invalid_argument& error) {
    std::printf("%s\n   %s\n", what, error.what());
    ++refused;
  }
}

}  // namespace

int main(int argument_count, char** arguments) {
  course::Notebook notebook(argument_count, arguments);
  const auto tensor = [](double x, double y, double z, double xy = 0, double yx = 0) {
    Mat3d inertia = Vec3d(x, y, z).asDiagonal();
    inertia(0, 1) = xy;
    inertia(1, 0) = yx;
    return inertia;
  };
  const auto check = [](const Mat3d& inertia) { require_invertible_inertia("hammer", inertia); };
  try_it("moments of 1, 2 and 4", [&] { check(tensor(1, 2, 4)); });
  try_it("moments of 1, 2 and 3, a flat plate", [&] { check(tensor(1, 2, 3)); });
  try_it("a product larger than its moments", [&] { check(tensor(1, 1, 1, 2, 2)); });
  try_it("one product typed, its mirror forgotten", [&] { check(tensor(1, 1, 1, 0.5, 0)); });
  try_it("a rod without thickness",
         [] { inverse_inertia("rod", mass_properties(ThinRod<double>{1}, 1).inertia); });

  using Mesh = Mesh<double>;
  const Mesh box = course::box_mesh(Vec3d(1, 2, 4));
  const auto try_mesh = [&box](const char* what, const auto& spoil) {
    Mesh mesh = box;
    spoil(mesh);
    try_it(what, [&] { mass_properties(mesh, 1); });
  };
  try_mesh("a mesh with a hole", [](Mesh& mesh) { mesh.triangles.pop_back(); });
  try_mesh("a mesh with one triangle turned round",
           [](Mesh& mesh) { std::swap(mesh.triangles[5][0], mesh.triangles[5][1]); });
  try_mesh("a mesh turned inside out", [](Mesh& mesh) {
    for (auto& triangle : mesh.triangles) std::swap(triangle[0], triangle[1]);
  });
  try_mesh("a mesh squeezed flat", [](Mesh& mesh) {
    for (Vec3d& vertex : mesh.vertices) vertex.z() = 0;
  });
  course::expect(refused == 8, "all but the plate are refused");
}
