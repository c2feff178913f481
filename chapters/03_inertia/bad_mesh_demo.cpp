// What a mesh gets that encloses nothing, or does not say what.
#include <support/mesh_shapes.hpp>
#include <support/record.hpp>
#include <support/refusals.hpp>
#include <tumble/mesh_mass_properties.hpp>

using namespace tumble;

int main(int argument_count, char** arguments) {
  support::Notebook notebook(argument_count, arguments);
  const Mesh<double> box = support::box_mesh(Vec3d(1, 2, 4));
  const auto spoiled = [&box](const char* what, const auto& spoil) {
    Mesh<double> mesh = box;
    spoil(mesh);
    return support::try_it(what, [&] { mass_properties(mesh, 1); });
  };
  int refused = 0;
  refused += spoiled("one triangle is missing", [](auto& mesh) { mesh.triangles.pop_back(); });
  refused += spoiled("one triangle is turned round",
                     [](auto& mesh) { std::swap(mesh.triangles[5][0], mesh.triangles[5][1]); });
  refused += spoiled("all triangles are turned round", [](auto& mesh) {
    for (auto& triangle : mesh.triangles) std::swap(triangle[0], triangle[1]);
  });
  refused += spoiled("one triangle is there twice",
                     [](auto& mesh) { mesh.triangles.push_back(mesh.triangles[0]); });
  refused += spoiled("two corners of a triangle are one", [](auto& mesh) {
    mesh.triangles[3] = {4, 7, 7};
  });
  support::expect(refused == 5, "all five are refused");
}
