// Where the refusals of this chapter begin: the last input that is taken, and the first that is
// not.
#include <support/bad_vectors.hpp>
#include <support/particle_cloud.hpp>
#include <tumble/mesh_mass_properties.hpp>
#include <tumble/spheres.hpp>
#include <tumble/tetrahedron.hpp>
#include <tumble/validate_inertia.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

template <class Solid>
std::string complaint_about(const Solid& solid) {
  return complaint_of([&] { mass_properties(solid, 1); });
}

/// A tetrahedron whose first triangle is thin: two of its sides are √2 and nearly 1 m long, at an
/// angle, and twice its area is `height`.
template <class Real>
Mesh<Real> with_thin_triangle(Real height) {
  return {{{0, 0, 0}, {1, -1, 0}, {1, height - 1, 0}, {0, 0, -1}},
          {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {0, 2, 3}}};
}

/// A triangle's refusal, by its number.
bool has_no_area(const std::string& complaint, const std::string& triangle) {
  return complaint.rfind("triangle " + triangle + " has no area", 0) == 0;
}

}  // namespace

TEST_CASE_TEMPLATE("Every length of every solid is refused where it is zero", Real,
                   EVERY_PRECISION) {
  const auto refused = [](const auto& solid, const std::string& name) {
    CHECK(complaint_about(solid) == name + " is 0 m; it must be greater than 0");
  };
  refused(Box<Real>{{0, 1, 1}}, "x size of the box");
  refused(Box<Real>{{1, 0, 1}}, "y size of the box");
  refused(Box<Real>{{1, 1, 0}}, "z size of the box");
  refused(Ellipsoid<Real>{{0, 1, 1}}, "x semi-axis of the ellipsoid");
  refused(Ellipsoid<Real>{{1, 0, 1}}, "y semi-axis of the ellipsoid");
  refused(Ellipsoid<Real>{{1, 1, 0}}, "z semi-axis of the ellipsoid");
  refused(Cylinder<Real>{0, 1}, "radius of the cylinder");
  refused(Cylinder<Real>{1, 0}, "height of the cylinder");
  refused(Cone<Real>{0, 1}, "radius of the cone");
  refused(Cone<Real>{1, 0}, "height of the cone");
  refused(ThinRod<Real>{0}, "length of the rod");
  refused(ThinPlate<Real>{0, 1}, "width of the plate");
  refused(ThinPlate<Real>{1, 0}, "height of the plate");
  refused(Sphere<Real>{0}, "radius of the sphere");
  refused(HollowSphere<Real>{0}, "radius of the hollow sphere");
  refused(SphericalShell<Real>{0, 0}, "outer radius of the shell");
  refused(Capsule<Real>{0, 1}, "radius of the capsule");
}

TEST_CASE_TEMPLATE("Lengths, masses and densities that are infinite or NaN are refused by name",
                   Real, EVERY_PRECISION) {
  const Real infinity = std::numeric_limits<Real>::infinity(),
             nan = std::numeric_limits<Real>::quiet_NaN();
  CHECK(complaint_about(Sphere<Real>{infinity}) ==
        "radius of the sphere is inf m; it must be finite");
  CHECK(complaint_about(SphericalShell<Real>{nan, 1}) ==
        "inner radius of the shell is nan m; it must be finite");
  CHECK(complaint_about(Capsule<Real>{1, infinity}) ==
        "length of the capsule is inf m; it must be finite");
  CHECK(complaint_of([&] { mass_properties(Sphere<Real>{1}, infinity); }) ==
        "mass is inf kg; it must be finite");
  const Sphere<Real> ball{1};
  CHECK(complaint_of([&] { mass_properties_of_density(ball, infinity); }) ==
        "density is inf kg/m^3; it must be finite");
  CHECK(complaint_of([&] { mass_properties_of_density(ball, 0); }) ==
        "density is 0 kg/m^3; it must be greater than 0");
}

TEST_CASE_TEMPLATE("A shell has the volume of its ball without that of the hollow", Real,
                   EVERY_PRECISION) {
  // Of the ball's volume a 27th is taken away; each side rounds a dozen times.
  const Real shell = volume(SphericalShell<Real>{1, 3});
  const Real difference = volume(Sphere<Real>{3}) - volume(Sphere<Real>{1});
  CHECK(std::abs(shell - difference) <= 24 * unit_roundoff<Real> * shell);
}

TEST_CASE_TEMPLATE("A matrix turns while its products are off by 1024 roundings, and no further",
                   Real, EVERY_PRECISION) {
  // Of this shear one product is off by e, and a length by e²/2, which is rounded away.
  const auto complaint = [](Real e) {
    Mat3<Real> shear = Mat3<Real>::Identity();
    shear(0, 1) = e;
    return complaint_of([&] { require_turn("the matrix", shear); });
  };
  const Real most = 1024 * unit_roundoff<Real>;
  CHECK(complaint(most) == "nothing thrown");
  CHECK(complaint(std::nextafter(most, Real(1))) != "nothing thrown");
}

TEST_CASE_TEMPLATE("A product of fifty turns is still a turn, and of a thousand different ones",
                   Real, EVERY_PRECISION) {
  RandomGenerator dice(7);
  for (int trial = 0; trial < 20; ++trial) {
    const Mat3<Real> R = random_turn<Real>(dice);
    Mat3<Real> power = R, product = R;
    for (int n = 1; n < 50; ++n) power = (power * R).eval();
    for (int n = 1; n < 1000; ++n) product = (product * random_turn<Real>(dice)).eval();
    CHECK(complaint_of([&] { require_turn("fifty times the same", power); }) == "nothing thrown");
    CHECK(complaint_of([&] { require_turn("a thousand", product); }) == "nothing thrown");
  }
}

TEST_CASE_TEMPLATE("A triangle has area from 8 roundings of its longest side's square on", Real,
                   EVERY_PRECISION) {
  // Its sides are (1, −1), (1, h − 1) and the short one between them. Begun at each corner in turn,
  // each pair of them is the one whose cross product is taken; it is h every time.
  const Real least = 8 * unit_roundoff<Real> * 2;  // the longest side's square is 2 m²
  for (std::size_t first = 0; first < 3; ++first) {
    const auto complaint = [first](Real height) {
      Mesh<Real> mesh = with_thin_triangle<Real>(height);
      const auto corners = mesh.triangles[0];
      mesh.triangles[0] = {corners[first], corners[(first + 1) % 3], corners[(first + 2) % 3]};
      return complaint_of([&] { require_sound_triangles(mesh); });
    };
    // h is a multiple of what can be stored beside 1: of a rounding.
    CHECK(has_no_area(complaint(least - unit_roundoff<Real> * 2), "0"));
    CHECK_FALSE(has_no_area(complaint(least + unit_roundoff<Real> * 2), "0"));
  }
}

TEST_CASE_TEMPLATE("A triangle whose corners straddle the first one is judged by its longest side",
                   Real, EVERY_PRECISION) {
  // The two sides from the first corner are nearly opposite; the third is 2 m long, so 32 roundings
  // of height are 8 of its square. All of it is exact.
  const auto complaint = [](Real height) {
    const Mesh<Real> mesh{{{0, 0, 0}, {-1, 0, 0}, {1, height, 0}, {0, 0, 1}},
                          {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {0, 2, 3}}};
    return complaint_of([&] { require_sound_triangles(mesh); });
  };
  CHECK(has_no_area(complaint(16 * unit_roundoff<Real>), "0"));
  CHECK(has_no_area(complaint(32 * unit_roundoff<Real>), "0"));
  CHECK(complaint(34 * unit_roundoff<Real>) == "nothing thrown");
}

TEST_CASE_TEMPLATE("A slanted sheet has a volume from 40/3 roundings of its thickness on", Real,
                   EVERY_PRECISION) {
  // A unit square in the plane z = x + y, of thickness t along z, so that its volume is t. Seen
  // from its middle the corners are (±1/2, ±1/2, −1, 0 or 1): over the twelve triangles a·(b × c),
  // with
  // + for −, comes to 10, of which 8 roundings and a sixth are 40/3. A multiple of 4 roundings
  // leaves all corners exact, and so the volume.
  const auto sheet = [](int roundings) {
    const Real half = Real(roundings) * unit_roundoff<Real> / 2;
    Mesh<Real> mesh{{},
                    {{0, 2, 3},
                     {0, 3, 1},
                     {4, 5, 7},
                     {4, 7, 6},
                     {0, 1, 5},
                     {0, 5, 4},
                     {2, 6, 7},
                     {2, 7, 3},
                     {0, 4, 6},
                     {0, 6, 2},
                     {1, 3, 7},
                     {1, 7, 5}}};
    for (const Real z : {-half, half})
      for (const Real y : {Real(-0.5), Real(0.5)})
        for (const Real x : {Real(-0.5), Real(0.5)}) mesh.vertices.push_back({x, y, x + y + z});
    return mesh;
  };
  const auto complaint = [&](int roundings) {
    const Mesh<Real> mesh = sheet(roundings);
    return complaint_of([&] { checked_integrals(mesh, MeshFrame<Real>(mesh)); });
  };
  // Its frame's unit is 2 m, the size of what is integrated a half of that above. The twelve terms
  // are positive, and each rounds six times.
  const Mesh<Real> mesh = sheet(0);
  const MeshFrame<Real> frame(mesh);
  const Real unit = std::ldexp(Real(1), 3 * frame.exponent);
  CHECK(std::abs(integrate<Real>(mesh, frame, Vec3<Real>::Zero()).rounding * unit * 3 /
                 (40 * unit_roundoff<Real>)-1) <= (12 + 6) * unit_roundoff<Real>);
  CHECK(complaint(12).find("the mesh encloses no volume") == 0);
  CHECK(complaint(16) == "nothing thrown");
}

TEST_CASE_TEMPLATE("A thin wall costs a shell no digits, neither of its moments nor of its volume",
                   Real, EVERY_PRECISION) {
  for (int n = 1; n < std::numeric_limits<Real>::digits; ++n) {
    CAPTURE(n);
    // A wall of about 2^-n, and some more, so that its powers round.
    const Real outer = Real(1.5), inner = outer - std::ldexp(Real(1.3), -n);
    const SphericalShell<Real> shell{inner, outer};
    const long double a = inner, b = outer, wall = b - a;
    const long double sum = a * a * a * a + a * a * a * b + a * a * b * b + a * b * b * b +
                            b * b * b * b,
                      squares = a * a + a * b + b * b;
    const long double moment = 2 * sum / squares / 5;
    CHECK(std::abs(mass_properties(shell, 1).inertia(0, 0) / moment - 1) <=
          24 * unit_roundoff<Real>);
    const long double whole = 4 * std::numbers::pi_v<long double> / 3 * wall * squares;
    CHECK(std::abs(volume(shell) / whole - 1) <= 12 * unit_roundoff<Real>);
  }
}

TEST_CASE_TEMPLATE(
    "A tetrahedron far from the origin, at exact places, keeps the bits it has near it", Real,
    EVERY_PRECISION) {
  // Its centre is a quarter of a metre off the places that can be stored out there.
  const Real far = std::ldexp(Real(1), std::numeric_limits<Real>::digits - 2);
  const auto inertia_at = [](const Vec3<Real>& a) {
    return mass_properties(Tetrahedron<Real>{{a, a + Vec3<Real>(1, 0, 0), a + Vec3<Real>(0, 2, 0),
                                              a + Vec3<Real>(0, 0, 3)}},
                           20)
        .inertia;
  };
  CHECK(same_bits(inertia_at(far * Vec3<Real>(1, 1, -1)), inertia_at(Vec3<Real>(0, 0, 0))));
  CHECK(mass_properties(Tetrahedron<Real>{{Vec3<Real>(far, 0, 0), Vec3<Real>(far + 1, 0, 0),
                                           Vec3<Real>(far, 2, 0), Vec3<Real>(far, 0, 3)}},
                        20)
            .centre_of_mass.y() == Real(0.5));
}

TEST_CASE_TEMPLATE(
    "Lengths whose powers leave the range spoil neither the test for flatness nor a mesh's moments",
    Real, EVERY_PRECISION) {
  // So far that the product of three edges, or of four, leaves the range.
  const int most = std::numeric_limits<Real>::max_exponent * 2 / 5;
  for (const int power : {-most, 0, most}) {
    const Real size = std::ldexp(Real(1), power);
    const Tetrahedron<Real> corner{{size * Vec3<Real>(0, 0, 0), size * Vec3<Real>(1, 0, 0),
                                    size * Vec3<Real>(0, 1, 0), size * Vec3<Real>(0, 0, 1)}};
    CHECK(complaint_of([&] { require_not_flat(corner); }) == "nothing thrown");
    // The mass makes up for it: m l² is the same.
    Mesh<Real> mesh = with_thin_triangle<Real>(1);
    const Mat3<Real> plain = mass_properties(mesh, 1).inertia;
    for (Vec3<Real>& vertex : mesh.vertices) vertex *= size;
    const int half = power / 2 * 2;
    const Real mass = std::ldexp(Real(1), -half);
    CHECK(same_bits(mass_properties(mesh, mass).inertia,
                    std::ldexp(Real(1), 2 * power - half) * plain));
  }
}

TEST_CASE_TEMPLATE(
    "One bad component of a corner, vertex or shift is enough, and one bad element of a tensor",
    Real, EVERY_PRECISION) {
  using Vector = Vec3<Real>;
  for (std::size_t n = 0; n < 4; ++n) {
    check_refuses_bad_vectors<Real>("corner of the tetrahedron", "m", [n](const Vector& bad) {
      Tetrahedron<Real> corner{
          {Vector(0, 0, 0), Vector(1, 0, 0), Vector(0, 1, 0), Vector(0, 0, 1)}};
      corner.corners[n] = bad;
      mass_properties(corner, 1);
    });
    check_refuses_bad_vectors<Real>("vertex " + std::to_string(n), "m", [n](const Vector& bad) {
      Mesh<Real> mesh = with_thin_triangle<Real>(1);
      mesh.vertices[n] = bad;
      mass_properties(mesh, 1);
    });
  }
  const Mat3<Real> turn = Mat3<Real>::Identity();
  check_refuses_bad_vectors<Real>("the shift that moves a body", "m", [&](const Vector& bad) {
    moved(mass_properties(Sphere<Real>{1}, 1), turn, bad);
  });

  const auto complaint_of_tensor = [](int row, int column, Real element) {
    Mat3<Real> inertia = Mat3<Real>::Identity();
    inertia(row, column) = element;
    return complaint_of([&] { require_symmetric("body", inertia); });
  };
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) {
      for (const Real bad : not_finite<Real>) {
        CHECK(complaint_of_tensor(row, column, bad) ==
              "body: an element of the inertia tensor is infinite or NaN; every element must be "
              "finite");
        Mat3<Real> matrix = turn;
        matrix(row, column) = bad;
        CHECK(complaint_of([&] {
                require_turn("the matrix", matrix);
              }).find("the matrix does not turn rigidly; ") == 0);
      }
      if (row == column) continue;
      const std::string axes = "xyz";
      const int low = std::min(row, column), high = std::max(row, column);
      const auto element = [&](int i, int j, bool is_set) {
        return std::string("I_") + axes[std::size_t(i)] + axes[std::size_t(j)] + " is " +
               (is_set ? "0.25" : "0");
      };
      CHECK(complaint_of_tensor(row, column, Real(0.25)) ==
            "body: " + element(low, high, row < column) + " and " +
                element(high, low, row > column) +
                " kg m^2; an inertia tensor is symmetric: they must be equal");
    }
  for (int axis = 0; axis < 3; ++axis) {
    Vector moments(1, 1, 1);
    moments[axis] = 0;
    CHECK(complaint_of([&] {
            inverse_moments("rod", moments);
          }).find("rod: the principal moments are (0, 1, 1) kg m^2; the first is zero") == 0);
  }
}

TEST_CASE_TEMPLATE("The first vertex and the first triangle of a mesh are looked at too", Real,
                   EVERY_PRECISION) {
  const Mesh<Real> good = with_thin_triangle<Real>(1);
  CHECK(complaint_about(good) == "nothing thrown");
  Mesh<Real> nowhere = good;
  nowhere.vertices[0].x() = std::numeric_limits<Real>::quiet_NaN();
  CHECK(complaint_about(nowhere) == "vertex 0 is (nan, 0, 0) m; every component must be finite");
  Mesh<Real> missing = good;
  missing.triangles[0][2] = 4;
  CHECK(complaint_about(missing) ==
        "triangle 0 names vertex 4; the mesh has 4 vertices, numbered from 0");
}

TEST_CASE_TEMPLATE("A mesh is looked at before its mass properties are computed, and its mass",
                   Real, EVERY_PRECISION) {
  Mesh<Real> open = with_thin_triangle<Real>(1);
  CHECK(complaint_of([&] { mass_properties(open, -1); }) ==
        "mass is -1 kg; it must be greater than 0");
  open.triangles.pop_back();
  CHECK(complaint_about(open).find("the mesh is open there") != std::string::npos);
  CHECK(complaint_of([&] { volume(open); }).find("the mesh is open there") != std::string::npos);
}

TEST_CASE_TEMPLATE("A tetrahedron is flat up to 16 roundings of its edges, wherever it lies", Real,
                   EVERY_PRECISION) {
  // Edges of 1, 2 and 4 m, so that it matters which of them is which. Powers of two round nothing,
  // and the origin lies far enough away for sums of corners to differ from edges.
  const Vec3<Real> a(2, 1, 0), b = a + Vec3<Real>(1, 0, 0), c = a + Vec3<Real>(0, 2, 0);
  const auto complaint = [&](Real height, Real size) {
    const Vec3<Real> d = a + Vec3<Real>(4, 0, 4 * height);
    const Vec3<Real> in_turn[] = {size * b, size * c, size * d};
    std::string complaints;
    for (int i = 0; i < 3; ++i)  // each edge is each of the three once
      complaints += complaint_about(
          Tetrahedron<Real>{{size * a, in_turn[i], in_turn[(i + 1) % 3], in_turn[(i + 2) % 3]}});
    return complaints;
  };
  const auto count_flat = [](const std::string& complaints) {
    int count = 0;
    for (std::size_t at = 0; (at = complaints.find("lie in one plane", at)) < complaints.size();
         ++at)
      ++count;
    return count;
  };
  const Real least = 16 * unit_roundoff<Real>;
  for (const Real size : {std::ldexp(Real(1), -40), Real(1), std::ldexp(Real(1), 40)}) {
    CHECK(count_flat(complaint(least / 2, size)) == 3);
    CHECK(count_flat(complaint(least, size)) == 3);
    CHECK(count_flat(complaint(least + unit_roundoff<Real>, size)) == 0);
  }
}

TEST_CASE_TEMPLATE("A tetrahedron needs a mass and four places", Real, EVERY_PRECISION) {
  Tetrahedron<Real> tetrahedron{{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}};
  CHECK(complaint_of([&] { mass_properties(tetrahedron, 0); }) ==
        "mass is 0 kg; it must be greater than 0");
  tetrahedron.corners[3].y() = std::numeric_limits<Real>::infinity();
  CHECK(complaint_about(tetrahedron) ==
        "corner of the tetrahedron is (0, inf, 1) m; every component must be finite");
}

TEST_CASE_TEMPLATE("The smallest and the largest moment are those that must be invertible", Real,
                   EVERY_PRECISION) {
  const Real smallest = std::numeric_limits<Real>::min(), largest = 1 / smallest;
  const auto complaint = [](const Vec3<Real>& moments) {
    return complaint_of([&] { inverse_moments("body", moments); });
  };
  const std::string limits = "each must lie between";
  CHECK(complaint({smallest, smallest, smallest}) == "nothing thrown");
  CHECK(complaint({largest, largest, largest}) == "nothing thrown");
  CHECK(complaint({smallest / 2, 1, 1}).find(limits) != std::string::npos);
  CHECK(complaint({1, 1.5f * largest, 1.5f * largest}).find(limits) != std::string::npos);
  CHECK(complaint({largest, largest, 1.5f * largest}).find(limits) != std::string::npos);
}

TEST_CASE_TEMPLATE("The smallest moment may be negative by its own roundings, not by another's",
                   Real, EVERY_PRECISION) {
  const auto complaint = [](const Vec3<Real>& moments) {
    return complaint_of([&] { require_possible_inertia<Real>("body", moments.asDiagonal()); });
  };
  CHECK(complaint({-unit_roundoff<Real>, 1, 1}).find("none can be negative") != std::string::npos);
}

TEST_CASE_TEMPLATE("A body is possible if its mass, its centre and its tensor are", Real,
                   EVERY_PRECISION) {
  MassProperties<Real> body = mass_properties(Box<Real>{{1, 2, 3}}, 1);
  const auto complaint = [&] { return complaint_of([&] { require_possible("body", body); }); };
  CHECK(complaint() == "nothing thrown");
  body.inertia(2, 2) *= 5;  // 25 beside 13 and 10 twelfths
  CHECK(complaint().find("no real body has these") != std::string::npos);
  body.centre_of_mass.z() = std::numeric_limits<Real>::quiet_NaN();
  CHECK(complaint() == "body: centre of mass is (0, 0, nan) m; every component must be finite");
  body.mass = 0;
  CHECK(complaint() == "body: mass is 0 kg; it must be greater than 0");
}
