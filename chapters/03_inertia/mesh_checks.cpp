// Meshes: against the solids they draw, and against everything that is wrong with some of them.
#include <support/checks.hpp>
#include <support/mesh_shapes.hpp>
#include <support/particle_cloud.hpp>
#include <tumble/mesh_mass_properties.hpp>
#include <tumble/principal_axes.hpp>
#include <tumble/spheres.hpp>
#include <tumble/tetrahedron.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

/// The largest difference in the tensor, relative to its trace.
template <class Real>
Real difference(const MassProperties<Real>& a, const MassProperties<Real>& b) {
  return (a.inertia - b.inertia).cwiseAbs().maxCoeff() / b.inertia.trace();
}

template <class Real>
Mesh<Real> moved(Mesh<Real> mesh, const Mat3<Real>& R, const Vec3<Real>& shift) {
  for (Vec3<Real>& vertex : mesh.vertices) vertex = R * vertex + shift;
  return mesh;
}

/// Two meshes as one.
template <class Real>
Mesh<Real> joined(Mesh<Real> mesh, const Mesh<Real>& other) {
  const std::size_t before = mesh.vertices.size();
  mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const auto& [i, j, k] : other.triangles)
    mesh.triangles.push_back({before + i, before + j, before + k});
  return mesh;
}

template <class Real>
Mesh<Real> inside_out(Mesh<Real> mesh) {
  for (auto& triangle : mesh.triangles) std::swap(triangle[0], triangle[1]);
  return mesh;
}

template <class Real>
std::string complaint_about(const Mesh<Real>& mesh) {
  return complaint_of([&] { mass_properties(mesh, 1); });
}

}  // namespace

TEST_CASE_TEMPLATE("A mesh of a box is a box", Real, EVERY_PRECISION) {
  const Box<Real> box{{3, 1, 2}};
  const MassProperties<Real> solid = mass_properties(box, 7);
  const Mesh<Real> mesh = box_mesh(box.size);
  // The signed volumes sum without cancelling; a term rounds some 20 times.
  CHECK(std::abs(volume(mesh) - 6) <= 24 * unit_roundoff<Real> * 6);
  CHECK(difference(mass_properties(mesh, 7), solid) <= 48 * unit_roundoff<Real>);
  CHECK(distance(mass_properties(mesh, 7).centre_of_mass, solid.centre_of_mass) <=
        24 * unit_roundoff<Real> * 3);
}

TEST_CASE_TEMPLATE("A mesh of a tetrahedron is a tetrahedron", Real, EVERY_PRECISION) {
  const std::array<Vec3<Real>, 4> corners = {Vec3<Real>(1, 1, 0), Vec3<Real>(4, 0, 1),
                                             Vec3<Real>(0, 3, 1), Vec3<Real>(1, 1, 5)};
  const Mesh<Real> mesh{{corners.begin(), corners.end()},
                        {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
  const MassProperties<Real> solid = mass_properties(Tetrahedron<Real>{corners}, 7);
  CHECK(std::abs(volume(mesh) - volume(Tetrahedron<Real>{corners})) <=
        48 * unit_roundoff<Real> * volume(mesh));
  CHECK(distance(mass_properties(mesh, 7).centre_of_mass, solid.centre_of_mass) <=
        48 * unit_roundoff<Real> * 5);
  CHECK(difference(mass_properties(mesh, 7), solid) <= 64 * unit_roundoff<Real>);
}

TEST_CASE(
    "A mesh of a sphere comes closer at second order: half the edge, a quarter of the error") {
  const double truth = 0.4;
  std::vector<double> errors;
  for (const int cuts : {2, 3, 4, 5, 6})
    errors.push_back(truth - mass_properties(sphere_mesh(1.0, cuts), 1).inertia(0, 0));
  // error = c h² + d h⁴ + …, so the ratio of neighbours differs from 4 by something that itself
  // shrinks by 4 with every cut; 3 leaves room for the terms beyond.
  double departure = 1;
  for (std::size_t i = 0; i + 1 < errors.size(); ++i) {
    const double ratio = errors[i] / errors[i + 1];
    CHECK(std::abs(ratio - 4) <= departure);
    departure = std::abs(ratio - 4) / 3;
  }
  CHECK(departure < 0.01);
}

TEST_CASE_TEMPLATE("A mesh far from the origin, at exact places, keeps the bits it has near it",
                   Real, EVERY_PRECISION) {
  const Vec3<Real> size(3, 1, 2), far(1'000'000, -2'000'000, 500'000);
  const MassProperties<Real> here = mass_properties(box_mesh(size), 7);
  const MassProperties<Real> there =
      mass_properties(moved<Real>(box_mesh(size), Mat3<Real>::Identity(), far), 7);
  CHECK(same_bits(here.inertia, there.inertia));
  CHECK(same_bits(there.centre_of_mass, far));
}

TEST_CASE_TEMPLATE("A mesh scaled by a power of two scales its moments and changes no other bit",
                   Real, EVERY_PRECISION) {
  const auto body = [](int k) {
    Mesh<Real> mesh = sphere_mesh<Real>(Real(0.7), 2);
    for (Vec3<Real>& vertex : mesh.vertices) vertex *= std::ldexp(Real(1), k);
    return mass_properties(mesh, 7).inertia;
  };
  // 2^±50 m: the fifth power of such a length is far outside float, and is never formed.
  for (const int k : {-50, -20, 3, 20, 50})
    CHECK(same_bits(body(k), std::ldexp(Real(1), 2 * k) * body(0)));
}

TEST_CASE_TEMPLATE(
    "From its centre a convex mesh has no tetrahedron to take away, from its box's middle it may",
    Real, EVERY_PRECISION) {
  const Mesh<Real> mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                        {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
  const MeshFrame<Real> frame(mesh);
  const auto taken_away = [&](const Vec3<Real>& from) {
    int count = 0;
    for (const auto& [i, j, k] : mesh.triangles) {
      const Vec3<Real> a = mesh.vertices[i] - from, b = mesh.vertices[j] - from,
                       c = mesh.vertices[k] - from;
      if (dot(a, b.cross(c)) < 0) ++count;
    }
    return count;
  };
  CHECK(same_bits(frame.middle, Vec3<Real>::Constant(Real(0.5))));
  CHECK(taken_away(frame.middle) == 1);
  CHECK(taken_away(mass_properties(mesh, 1).centre_of_mass) == 0);
}

TEST_CASE("A fine mesh in float is as exact as a coarse one") {
  const Mesh<float> mesh = sphere_mesh(0.7f, 6);
  Mesh<double> witness;
  witness.triangles = mesh.triangles;
  for (const Vec3f& vertex : mesh.vertices) witness.vertices.push_back(vertex.cast<double>());
  const Mat3d truth = mass_properties(witness, 7).inertia;
  // 32768 triangles, but the bound is that of the box: 48 roundings.
  CHECK(relative_error<double>(mass_properties(mesh, 7).inertia.cast<double>(), truth) <=
        48 * double(unit_roundoff<float>));
}

TEST_CASE_TEMPLATE("An open mesh is refused, naming the edge", Real, EVERY_PRECISION) {
  Mesh<Real> mesh = box_mesh(Vec3<Real>(1, 1, 1));
  mesh.triangles.pop_back();
  CHECK(complaint_about(mesh) ==
        "the edge from vertex 1 to vertex 5 belongs to triangle 4 alone; the mesh is open there: "
        "close the hole, or merge vertices that lie in the same place");
}

TEST_CASE_TEMPLATE("A triangle wound the opposite way to its neighbours is refused", Real,
                   EVERY_PRECISION) {
  Mesh<Real> mesh = box_mesh(Vec3<Real>(1, 1, 1));
  std::swap(mesh.triangles[5][0], mesh.triangles[5][1]);
  CHECK(complaint_about(mesh) ==
        "the edge from vertex 0 to vertex 4 belongs to triangles 5 and 8, and both run along it "
        "in the same direction; turn one of them round");
}

TEST_CASE_TEMPLATE("A mesh turned inside out is refused, with its negative volume", Real,
                   EVERY_PRECISION) {
  CHECK(complaint_about(inside_out(box_mesh(Vec3<Real>(1, 2, 4)))) ==
        "the mesh is inside out: its volume is -8 m^3; turn the triangles round by swapping two "
        "corners of each");
}

TEST_CASE_TEMPLATE("An edge with three triangles is refused", Real, EVERY_PRECISION) {
  Mesh<Real> mesh = box_mesh(Vec3<Real>(1, 1, 1));
  mesh.vertices.push_back({9, 9, 9});
  mesh.triangles.push_back({0, 1, 8});
  CHECK(complaint_about(mesh) ==
        "the edge from vertex 0 to vertex 1 belongs to 3 triangles; each edge of a solid's skin "
        "joins exactly two");
}

TEST_CASE_TEMPLATE("Triangles without area, corner or place are refused", Real, EVERY_PRECISION) {
  Mesh<Real> mesh = box_mesh(Vec3<Real>(1, 1, 1));
  Mesh<Real> flat = mesh;
  flat.triangles[3] = {4, 7, 7};
  CHECK(complaint_about(flat) ==
        "triangle 3 has no area: its corners (-0.5, -0.5, 0.5), (0.5, 0.5, 0.5) and (0.5, 0.5, "
        "0.5) m lie on one line");
  Mesh<Real> missing = mesh;
  missing.triangles[3][1] = 8;
  CHECK(complaint_about(missing) ==
        "triangle 3 names vertex 8; the mesh has 8 vertices, numbered from 0");
  Mesh<Real> nowhere = mesh;
  nowhere.vertices[2].y() = std::numeric_limits<Real>::quiet_NaN();
  CHECK(complaint_about(nowhere) ==
        "vertex 2 is (-0.5, nan, -0.5) m; every component must be finite");
  CHECK(complaint_about(Mesh<Real>{}) == "the mesh has no triangles");
}

TEST_CASE_TEMPLATE("A flat sheet that is closed on paper encloses nothing and is refused", Real,
                   EVERY_PRECISION) {
  RandomGenerator dice(42);
  for (int n = 0; n < 20; ++n) {
    Mesh<Real> sheet{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
                     {{0, 1, 2}, {0, 2, 3}, {2, 1, 0}, {3, 2, 0}}};
    sheet = moved<Real>(sheet, random_turn<Real>(dice), {1, 2, 3});
    // Both sides share their diagonal: four triangles there. Cut the back along the other one.
    sheet.triangles[2] = {1, 0, 3};
    sheet.triangles[3] = {3, 2, 1};
    CHECK(complaint_about(sheet) ==
          "the mesh encloses no volume: its two sides lie on each other, as far as rounding can "
          "tell");
  }
}

TEST_CASE_TEMPLATE("Slim meshes are taken as long as their volume is more than rounding", Real,
                   EVERY_PRECISION) {
  const Real thin = std::ldexp(Real(1), -12);
  CHECK(complaint_about(box_mesh(Vec3<Real>(1, 1, thin))) == "nothing thrown");
  CHECK(complaint_about(box_mesh(Vec3<Real>(1, thin, thin))) == "nothing thrown");
}
