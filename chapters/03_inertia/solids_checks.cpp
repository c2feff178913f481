// Every solid against an integration that knows none of its formulas.
#include <support/checks.hpp>
#include <support/particle_cloud.hpp>
#include <support/quadrature.hpp>
#include <tumble/spheres.hpp>
#include <tumble/tetrahedron.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

/// Compares with the integral over the pieces. The integrands are polynomials (and sines of the
/// angle) low enough for the rule to be exact, so both sides only round: a formula under 24 times,
/// a sum of n positive terms n times and a piece some 32 times, in long double.
template <class Real>
void check_body(const MassProperties<Real>& body, const std::vector<Piece>& pieces) {
  const Summed exact = summed(pieces);
  const long double slack =
      24 * static_cast<long double>(unit_roundoff<Real>) +
      static_cast<long double>(pieces.size() + 32) * unit_roundoff<long double>;
  const Mat3<long double> inertia =
      body.inertia.template cast<long double>() / static_cast<long double>(body.mass);
  const long double size = exact.body.inertia.trace();
  CHECK((inertia - exact.body.inertia).cwiseAbs().maxCoeff() <= slack * size);
  const Vec3<long double> centre = body.centre_of_mass.template cast<long double>();
  CHECK(distance(centre, exact.body.centre_of_mass) <=
        slack * (exact.body.centre_of_mass.norm() + std::sqrt(size)));
}

template <class Solid>
void check_volume(const Solid& solid, const std::vector<Piece>& pieces) {
  using Real = decltype(volume(solid));
  const long double exact = summed(pieces).volume;
  const long double slack =
      16 * static_cast<long double>(unit_roundoff<Real>) +
      static_cast<long double>(pieces.size() + 32) * unit_roundoff<long double>;
  CHECK(std::abs(static_cast<long double>(volume(solid)) - exact) <= slack * exact);
}

using Vec = Vec3<long double>;

}  // namespace

TEST_CASE_TEMPLATE("An ellipsoid is the integral over a stretched ball", Real, EVERY_PRECISION) {
  const Ellipsoid<Real> ellipsoid{{3, Real(0.5), 2}};
  const auto pieces = ball_pieces(0, 1, -1, 1, ellipsoid.semi_axes.template cast<long double>());
  check_body(mass_properties(ellipsoid, 7), pieces);
  check_volume(ellipsoid, pieces);
}

TEST_CASE_TEMPLATE("A sphere, a thick shell and a thin one are integrals over their distance", Real,
                   EVERY_PRECISION) {
  const Vec ones(1, 1, 1);
  check_body(mass_properties(Sphere<Real>{3}, 7), ball_pieces(0, 3, -1, 1, ones));
  check_volume(Sphere<Real>{3}, ball_pieces(0, 3, -1, 1, ones));
  check_body(mass_properties(SphericalShell<Real>{2, 3}, 7), ball_pieces(2, 3, -1, 1, ones));
  check_volume(SphericalShell<Real>{2, 3}, ball_pieces(2, 3, -1, 1, ones));
  std::vector<Piece> skin = ball_pieces(0, 1, -1, 1, ones);
  for (Piece& piece : skin) {  // every piece of the ball, pushed out to distance 3
    piece.weight /= piece.position.squaredNorm();
    piece.position *= 3 / piece.position.norm();
  }
  check_body(mass_properties(HollowSphere<Real>{3}, 7), skin);
}

TEST_CASE_TEMPLATE("A cylinder is the integral over its discs", Real, EVERY_PRECISION) {
  const Cylinder<Real> cylinder{.radius = 2, .height = 5};
  check_body(mass_properties(cylinder, 7), turned_pieces(-2.5L, 2.5L, 2, 2));
  check_volume(cylinder, turned_pieces(-2.5L, 2.5L, 2, 2));
}

TEST_CASE_TEMPLATE("A cone is the integral over its shrinking discs, its centre a quarter up", Real,
                   EVERY_PRECISION) {
  const Cone<Real> cone{.radius = 2, .height = 5};
  check_body(mass_properties(cone, 7), turned_pieces(0, 5, 2, 0));
  check_volume(cone, turned_pieces(0, 5, 2, 0));
  CHECK(mass_properties(cone, 7).centre_of_mass.z() == Real(1.25));
}

TEST_CASE_TEMPLATE("A capsule is the integral over its cylinder and its two half balls", Real,
                   EVERY_PRECISION) {
  const Capsule<Real> capsule{.radius = 2, .length = 5};
  std::vector<Piece> pieces = turned_pieces(-2.5L, 2.5L, 2, 2);
  for (const long double side : {-1.0L, 1.0L}) {
    for (Piece piece : ball_pieces(0, 2, 0, 1, {1, 1, 1})) {
      piece.position.z() = side * (piece.position.z() + 2.5L);
      pieces.push_back(piece);
    }
  }
  check_body(mass_properties(capsule, 7), pieces);
  check_volume(capsule, pieces);
}

TEST_CASE_TEMPLATE("A rod is the integral along its length, a plate the one over its area", Real,
                   EVERY_PRECISION) {
  check_body(mass_properties(ThinRod<Real>{5}, 7),
             pieces_of(gauss_legendre(), [](auto u, auto, auto) {
               return Piece{{0, 0, 5 * (u - 0.5L)}, 5};
             }));
  check_body(mass_properties(ThinPlate<Real>{5, 2}, 7),
             pieces_of(gauss_legendre(), [](auto u, auto v, auto) {
               return Piece{{5 * (u - 0.5L), 2 * (v - 0.5L), 0}, 10};
             }));
}

TEST_CASE_TEMPLATE("A tetrahedron with any four corners is the integral over its inside", Real,
                   EVERY_PRECISION) {
  RandomGenerator dice(3);
  for (int n = 0; n < 20; ++n) {
    Tetrahedron<Real> tetrahedron;
    std::array<Vec, 4> corners;
    for (std::size_t i = 0; i < 4; ++i) {
      tetrahedron.corners[i] = dice.vector<Real>();
      corners[i] = tetrahedron.corners[i].template cast<long double>();
    }
    check_body(mass_properties(tetrahedron, 7), tetrahedron_pieces(corners));
    // The volume of a flat one cancels; its error is a few roundings of the product of the edges.
    const Real edges = (tetrahedron.corners[1] - tetrahedron.corners[0]).norm() *
                       (tetrahedron.corners[2] - tetrahedron.corners[0]).norm() *
                       (tetrahedron.corners[3] - tetrahedron.corners[0]).norm();
    CHECK(std::abs(volume(tetrahedron) - Real(summed(tetrahedron_pieces(corners)).volume)) <=
          32 * unit_roundoff<Real> * edges);
  }
}

namespace {

/// The second witness, and the weaker one: throw darts at a box around the solid and average those
/// that hit. Each average is uncertain by the standard deviation of what it averages over √hits.
template <class Inside>
void check_with_darts(const MassProperties<double>& body, const Vec3d& half_box, double volume_m3,
                      const Inside& inside) {
  RandomGenerator dice(4);
  const int darts = 40'000;
  const double too_rare = 5;  // standard deviations: passed by chance once in two million
  Mat3d sum = Mat3d::Zero(), squares = Mat3d::Zero();
  double hits = 0;
  const Mat3d truth = inertia_about(body, Vec3d::Zero()) / body.mass;
  for (int n = 0; n < darts; ++n) {
    const Vec3d r = half_box.cwiseProduct(dice.vector<double>());
    if (!inside(r)) continue;
    const Mat3d off = inertia_of_particle(1.0, r) - truth;
    ++hits;
    sum += off;
    squares += off.cwiseAbs2();
  }
  for (int i = 0; i < 9; ++i)
    CHECK(std::abs(sum(i) / hits) <= too_rare * std::sqrt(squares(i)) / hits);
  const double share = hits / darts, box = 8 * half_box.prod();
  CHECK(std::abs(share * box - volume_m3) <=
        too_rare * box * std::sqrt(share * (1 - share) / darts));
}

}  // namespace

TEST_CASE("Random darts that hit a solid have its volume and its tensor, as far as luck allows") {
  const auto across = [](const Vec3d& r) { return std::hypot(r.x(), r.y()); };
  const Ellipsoid<double> ellipsoid{{3, 1, 2}};
  check_with_darts(mass_properties(ellipsoid, 7), {3, 1, 2}, volume(ellipsoid),
                   [](const Vec3d& r) { return r.cwiseQuotient(Vec3d(3, 1, 2)).norm() < 1; });
  const SphericalShell<double> shell{2, 3};
  check_with_darts(mass_properties(shell, 7), {3, 3, 3}, volume(shell),
                   [](const Vec3d& r) { return r.norm() > 2 && r.norm() < 3; });
  const Cylinder<double> cylinder{1, 4};
  check_with_darts(mass_properties(cylinder, 7), {1, 1, 2}, volume(cylinder),
                   [&](const Vec3d& r) { return across(r) < 1; });
  const Cone<double> cone{2, 3};
  check_with_darts(mass_properties(cone, 7), {2, 2, 3}, volume(cone),
                   [&](const Vec3d& r) { return r.z() > 0 && across(r) < 2 * (1 - r.z() / 3); });
  const Capsule<double> capsule{1, 2};
  check_with_darts(mass_properties(capsule, 7), {1, 1, 2}, volume(capsule), [&](const Vec3d& r) {
    return std::hypot(across(r), std::max(0.0, std::abs(r.z()) - 1)) < 1;
  });
  const Tetrahedron<double> corner{
      {Vec3d(0, 0, 0), Vec3d(1, 0, 0), Vec3d(0, 2, 0), Vec3d(0, 0, 3)}};
  check_with_darts(mass_properties(corner, 7), {1, 2, 3}, volume(corner), [](const Vec3d& r) {
    return r.minCoeff() > 0 && r.x() + r.y() / 2 + r.z() / 3 < 1;
  });
}

TEST_CASE_TEMPLATE("A solid made of a material weighs its density times its volume", Real,
                   EVERY_PRECISION) {
  CHECK(mass_properties_of_density(Box<Real>{{2, 3, 4}}, 10).mass == 240);
  CHECK(mass_properties_of_density(Box<Real>{{2, 3, 4}}, 10).inertia(2, 2) == 20 * (4 + 9));
  CHECK(complaint_of([] { mass_properties_of_density(Sphere<Real>{1}, -3); }) ==
        "density is -3 kg/m^3; it must be greater than 0");
}

TEST_CASE_TEMPLATE("Sizes that no solid can have are refused by name, value, unit and rule", Real,
                   EVERY_PRECISION) {
  const Real nan = std::numeric_limits<Real>::quiet_NaN(),
             infinity = std::numeric_limits<Real>::infinity();
  const auto refusal = [](const auto& solid) {
    return complaint_of([&] { mass_properties(solid, 1); });
  };
  CHECK(refusal(Box<Real>{{1, 0, 1}}) == "y size of the box is 0 m; it must be greater than 0");
  CHECK(refusal(Ellipsoid<Real>{{1, 1, nan}}) ==
        "z semi-axis of the ellipsoid is nan m; it must be greater than 0");
  CHECK(refusal(Sphere<Real>{-2}) == "radius of the sphere is -2 m; it must be greater than 0");
  CHECK(refusal(HollowSphere<Real>{infinity}) ==
        "radius of the hollow sphere is inf m; it must be finite");
  CHECK(refusal(SphericalShell<Real>{2, 2}) ==
        "inner radius of the shell is 2 m; it must be less than the outer radius, 2 m");
  CHECK(refusal(SphericalShell<Real>{-1, 2}) ==
        "inner radius of the shell is -1 m; it must be 0 or more");
  CHECK(refusal(Cylinder<Real>{1, 0}) ==
        "height of the cylinder is 0 m; it must be greater than 0");
  CHECK(refusal(Cone<Real>{0, 1}) == "radius of the cone is 0 m; it must be greater than 0");
  CHECK(refusal(Capsule<Real>{1, -1}) == "length of the capsule is -1 m; it must be 0 or more");
  CHECK(refusal(ThinRod<Real>{nan}) == "length of the rod is nan m; it must be greater than 0");
  CHECK(refusal(ThinPlate<Real>{1, -1}) ==
        "height of the plate is -1 m; it must be greater than 0");
  CHECK(complaint_of([] { mass_properties(Sphere<Real>{1}, 0); }) ==
        "mass is 0 kg; it must be greater than 0");
  const Vec3<Real> a(0, 0, 0), b(1, 0, 0), c(0, 1, 0), d(1, 1, 0);
  CHECK(refusal(Tetrahedron<Real>{{a, b, c, d}}) ==
        "the corners of the tetrahedron, (0, 0, 0), (1, 0, 0), (0, 1, 0) and (1, 1, 0) m, lie in "
        "one plane; they must enclose a volume");
}
