// Solids that turn into each other: the same body, reached in two ways.
#include <support/checks.hpp>
#include <support/mesh_shapes.hpp>
#include <support/quadrature.hpp>
#include <tumble/mesh_mass_properties.hpp>
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

}  // namespace

TEST_CASE_TEMPLATE("An ellipsoid with equal axes is a sphere, and so is a capsule of no length",
                   Real, EVERY_PRECISION) {
  const MassProperties<Real> sphere = mass_properties(Sphere<Real>{Real(0.7)}, Real(1.3));
  const Ellipsoid<Real> ellipsoid{Vec3<Real>::Constant(Real(0.7))};
  CHECK(difference(mass_properties(ellipsoid, Real(1.3)), sphere) <= 4 * unit_roundoff<Real>);
  CHECK(difference(mass_properties(Capsule<Real>{Real(0.7), 0}, Real(1.3)), sphere) <=
        8 * unit_roundoff<Real>);
}

TEST_CASE_TEMPLATE("A capsule longer and longer becomes a cylinder as its balls become negligible",
                   Real, EVERY_PRECISION) {
  const Real r = 1, l = 1000;
  // The balls hold 4r/3l of the mass, and sit at most l/2 + r away where the mean square is l²/12.
  CHECK(difference(mass_properties(Capsule<Real>{r, l}, 1),
                   mass_properties(Cylinder<Real>{r, l}, 1)) <=
        4 * r / (3 * l) * (3 * (1 + 2 * r / l) * (1 + 2 * r / l)));
}

TEST_CASE_TEMPLATE("A shell without a hollow is a sphere, and with the thinnest wall a hollow one",
                   Real, EVERY_PRECISION) {
  const MassProperties<Real> solid = mass_properties(Sphere<Real>{3}, 2);
  CHECK(difference(mass_properties(SphericalShell<Real>{0, 3}, 2), solid) <=
        8 * unit_roundoff<Real>);
  const Real inner = std::nextafter(Real(3), Real(0));
  CHECK(difference(mass_properties(SphericalShell<Real>{inner, 3}, 2),
                   mass_properties(HollowSphere<Real>{3}, 2)) <= 16 * unit_roundoff<Real>);
}

TEST_CASE_TEMPLATE(
    "A box flattened becomes a plate, and a plate narrowed a rod, by the square of "
    "what is left",
    Real, EVERY_PRECISION) {
  const Real thin = Real(1) / 1024;
  const MassProperties<Real> plate = mass_properties(ThinPlate<Real>{3, 2}, 6);
  const MassProperties<Real> box = mass_properties(Box<Real>{{3, 2, thin}}, 6);
  // The thickness adds m t²/12 to two of the moments; 8 roundings of the largest for the rest.
  Mat3<Real> left = Mat3<Real>::Zero();
  left.diagonal() << thin * thin / 2, thin * thin / 2, 0;
  CHECK((box.inertia - plate.inertia - left).norm() <=
        8 * unit_roundoff<Real> * plate.inertia.norm());

  const MassProperties<Real> rod = mass_properties(ThinRod<Real>{2}, 6);
  const Vec3<Real> strip = mass_properties(ThinPlate<Real>{thin, 2}, 6).inertia.diagonal();
  CHECK(std::abs(strip.x() - rod.inertia(0, 0)) <= 8 * unit_roundoff<Real> * strip.x());
  CHECK(std::abs(strip.y() - thin * thin / 2) <= 8 * unit_roundoff<Real> * strip.y());
}

TEST_CASE_TEMPLATE("Two half cylinders make one", Real, EVERY_PRECISION) {
  const Real pi = std::numbers::pi_v<Real>;
  const int corners = 65;
  std::vector<Vec3<Real>> round = arc<Real>(2, 0, 2 * pi, 2 * corners - 1);
  round.pop_back();  // the last corner is the first
  const MassProperties<Real> whole = mass_properties(prism_mesh<Real>(round, -2, 2), 1);
  const MassProperties<Real> half =
      mass_properties(prism_mesh<Real>(arc<Real>(2, 0, pi, corners), -2, 2), Real(0.5));
  Mat3<Real> half_turn = Mat3<Real>::Identity();
  half_turn.diagonal() << -1, -1, 1;
  const MassProperties<Real> both =
      combined(std::vector{half, moved(half, half_turn, Vec3<Real>::Zero())});
  // Sines and cosines put the corners a rounding of the radius off, the rest is the meshes' own.
  CHECK(difference(both, whole) <= 64 * unit_roundoff<Real>);
  // A polygon of n sides lacks (2π/n)²/6 of the circle's area; twice that in the second moments.
  const Real lacking = 2 * std::pow(2 * pi / Real(round.size()), Real(2)) / 6;
  const MassProperties<Real> cylinder = mass_properties(Cylinder<Real>{2, 4}, 1);
  CHECK(difference(whole, cylinder) <= lacking);
}

TEST_CASE_TEMPLATE("A cone cut across is a smaller cone and a frustum", Real, EVERY_PRECISION) {
  const Summed cut = summed(turned_pieces(0, 2, 2, 1));
  const MassProperties<Real> frustum{
      .mass = Real(cut.volume),
      .centre_of_mass = cut.body.centre_of_mass.template cast<Real>(),
      .inertia = (cut.volume * cut.body.inertia).template cast<Real>()};
  const MassProperties<Real> tip =
      moved(mass_properties_of_density(Cone<Real>{1, 2}, 1), Mat3<Real>::Identity(), {0, 0, 2});
  const MassProperties<Real> whole = mass_properties_of_density(Cone<Real>{2, 4}, 1);
  const MassProperties<Real> joined = combined(std::vector{frustum, tip});
  // The frustum's sums round 128 times in long double; the rest is some 32 roundings of Real.
  const Real slack = 32 * unit_roundoff<Real> + 160 * Real(unit_roundoff<long double>);
  CHECK(std::abs(joined.mass - whole.mass) <= slack * whole.mass);
  CHECK(distance(joined.centre_of_mass, whole.centre_of_mass) <= slack * 4);
  CHECK(difference(joined, whole) <= slack);
}

TEST_CASE_TEMPLATE("Six tetrahedra make a box", Real, EVERY_PRECISION) {
  const Vec3<Real> size(3, 1, 2);
  const Vec3<Real> a = -size / 2, g = size / 2;
  // Walk from one corner to the opposite one along x, y and z, in each of the six orders.
  std::vector<MassProperties<Real>> parts;
  for (const auto& [first, second] : {std::pair{0, 1}, {0, 2}, {1, 0}, {1, 2}, {2, 0}, {2, 1}}) {
    Vec3<Real> b = a, c = a;
    b(first) = g(first);
    c(first) = g(first);
    c(second) = g(second);
    parts.push_back(mass_properties(Tetrahedron<Real>{{a, b, c, g}}, 1));
  }
  const MassProperties<Real> whole = combined(parts);
  CHECK(distance(whole.centre_of_mass, Vec3<Real>::Zero()) <= 24 * unit_roundoff<Real>);
  CHECK(difference(whole, mass_properties(Box<Real>{size}, 6)) <= 48 * unit_roundoff<Real>);
}
