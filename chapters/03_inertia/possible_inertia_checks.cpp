// Which tensors matter can have, and what the others get.
#include <support/checks.hpp>
#include <support/particle_cloud.hpp>
#include <tumble/spheres.hpp>
#include <tumble/tetrahedron.hpp>
#include <tumble/validate_inertia.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

template <class Real>
Mat3<Real> diagonal(Real x, Real y, Real z) {
  return Vec3<Real>(x, y, z).asDiagonal();
}

template <class Real>
std::string complaint_about(const Mat3<Real>& inertia) {
  return complaint_of([&] { require_possible_inertia("hammer", inertia); });
}

}  // namespace

TEST_CASE_TEMPLATE("Every solid of this chapter is possible, the flat and the thin ones too", Real,
                   EVERY_PRECISION) {
  RandomGenerator dice(31);
  for (int n = 0; n < 50; ++n) {
    const Mat3<Real> R = random_turn<Real>(dice);
    for (const MassProperties<Real>& body :
         {mass_properties(Box<Real>{{1, 2, 3}}, 1), mass_properties(ThinPlate<Real>{1, 2}, 1),
          mass_properties(ThinRod<Real>{1}, 1), mass_properties(Sphere<Real>{1}, 1),
          mass_properties(Cone<Real>{1, 5}, 1), mass_properties(Cylinder<Real>{1, 5}, 1),
          mass_properties(Ellipsoid<Real>{{1, 2, 3}}, 1), mass_properties(HollowSphere<Real>{1}, 1),
          mass_properties(SphericalShell<Real>{Real(0.999), 1}, 1),
          mass_properties(Capsule<Real>{1, 5}, 1),
          mass_properties(Tetrahedron<Real>{{Vec3<Real>(0, 0, 0), Vec3<Real>(1, 0, 0),
                                             Vec3<Real>(0, 2, 0), Vec3<Real>(0, 0, Real(0.001))}},
                          1)})
      CHECK(complaint_of([&] { require_possible("body", moved(body, R, Vec3<Real>(1, 2, 3))); }) ==
            "nothing thrown");
  }
}

TEST_CASE_TEMPLATE("A tensor that breaks I_1 + I_2 >= I_3 is refused with its three moments", Real,
                   EVERY_PRECISION) {
  CHECK(
      complaint_about(diagonal<Real>(1, 4, 2)) ==
      "hammer: the principal moments are (1, 2, 4) kg m^2; no real body has these: the two smaller "
      "must add up to the largest or more, but I_1 + I_2 = 3 < I_3 = 4");
  RandomGenerator dice(32);
  for (int n = 0; n < 20; ++n) {
    const Mat3<Real> R = random_turn<Real>(dice);
    CHECK(complaint_about(in_other_axes(diagonal<Real>(1, 2, Real(3.001)), R)) != "nothing thrown");
    CHECK(complaint_about(in_other_axes(diagonal<Real>(1, 2, 3), R)) == "nothing thrown");
  }
}

TEST_CASE_TEMPLATE(
    "With its minus forgotten a bar in a plane keeps its moments, and a rod along (1, 1, 1) is "
    "refused",
    Real, EVERY_PRECISION) {
  const auto misread = [](Mat3<Real> inertia) {
    const Vec3<Real> diagonal_part = inertia.diagonal();
    inertia = -inertia;
    inertia.diagonal() = diagonal_part;
    return inertia;
  };
  // A plank that rises in the plane of x and y: of its products I_xy alone is not zero.
  const Vec3<Real> up(0, 0, 1), slanted = Vec3<Real>(2, 1, 0).normalized();
  Mat3<Real> R;
  R << slanted, up.cross(slanted), up;
  const Mat3<Real> plank =
      moved(mass_properties(Box<Real>{{2, Real(0.2), Real(0.1)}}, 3), R, Vec3<Real>(0, 0, 0))
          .inertia;
  CHECK(plank(0, 1) < Real(-0.1));
  CHECK(distance(principal_axes(misread(plank)).moments, principal_axes(plank).moments) <=
        16 * unit_roundoff<Real> * plank.norm());
  // Two particles at ±(1, 1, 1): moments 0, 6 and 6 become 2, 2 and 8.
  const Mat3<Real> rod = 2 * inertia_of_particle(Real(1), Vec3<Real>(1, 1, 1));
  CHECK(complaint_about<Real>(rod) == "nothing thrown");
  CHECK(complaint_about<Real>(misread(rod)).find("no real body has these") != std::string::npos);
}

TEST_CASE_TEMPLATE("The slack is a few roundings of the moments: a little more is refused", Real,
                   EVERY_PRECISION) {
  for (const Real scale : {Real(1e-12), Real(1), Real(1e12)}) {
    CAPTURE(scale);
    // Six units of moment in all, of which 32 roundings are let pass.
    const Real let_pass = 6 * 31 * unit_roundoff<Real>, refused = 6 * 34 * unit_roundoff<Real>;
    CHECK(complaint_about(diagonal<Real>(scale, 2 * scale, scale * (3 + let_pass))) ==
          "nothing thrown");
    CHECK(complaint_about(diagonal<Real>(scale, 2 * scale, scale * (3 + refused))) !=
          "nothing thrown");
  }
}

TEST_CASE_TEMPLATE("Negative moments, and tensors that are lopsided or not finite, are refused",
                   Real, EVERY_PRECISION) {
  CHECK(complaint_about(diagonal<Real>(2, -1, 2)) ==
        "hammer: the principal moments are (-1, 2, 2) kg m^2; none can be negative");
  Mat3<Real> lopsided = diagonal<Real>(1, 1, 1);
  lopsided(0, 2) = Real(0.25);
  CHECK(complaint_about(lopsided) ==
        "hammer: I_xz is 0.25 and I_zx is 0 kg m^2; an inertia tensor is symmetric: they must be "
        "equal");
  CHECK(complaint_about(diagonal<Real>(1, std::numeric_limits<Real>::quiet_NaN(), 1)) ==
        "hammer: an element of the inertia tensor is infinite or NaN; every element must be "
        "finite");
  MassProperties<Real> body = mass_properties(Sphere<Real>{1}, 1);
  body.mass = -1;
  CHECK(complaint_of([&] { require_possible("hammer", body); }) ==
        "hammer: mass is -1 kg; it must be greater than 0");
}

TEST_CASE_TEMPLATE("Mirrored elements may differ by 64 roundings of the largest one and no more",
                   Real, EVERY_PRECISION) {
  for (const Real scale : {Real(1e-12), Real(1), Real(1e12)}) {
    CAPTURE(scale);
    Mat3<Real> lopsided = diagonal<Real>(2 * scale, 3 * scale, 4 * scale);
    // 64 roundings of 4 are let pass; 1 either way is room for those of the check itself.
    lopsided(1, 2) = 4 * scale * 63 * unit_roundoff<Real>;
    CHECK(complaint_about(lopsided) == "nothing thrown");
    lopsided(1, 2) = 4 * scale * 65 * unit_roundoff<Real>;
    CHECK(complaint_about(lopsided).find("they must be equal") != std::string::npos);
  }
}

TEST_CASE_TEMPLATE("Any of the nine elements may be the largest that mirrored ones are measured by",
                   Real, EVERY_PRECISION) {
  for (int row = 0; row < 3; ++row)
    for (int column = row; column < 3; ++column)
      for (const auto& [p, q] : {std::pair(0, 1), std::pair(0, 2), std::pair(1, 2)}) {
        if (row == p && column == q) continue;
        Mat3<Real> lopsided = Mat3<Real>::Zero();
        lopsided(row, column) = lopsided(column, row) = -1;
        lopsided(p, q) = 64 * unit_roundoff<Real>;
        CHECK(complaint_of([&] { require_symmetric("hammer", lopsided); }) == "nothing thrown");
        lopsided(p, q) = 65 * unit_roundoff<Real>;
        CHECK(complaint_of([&] { require_symmetric("hammer", lopsided); }) != "nothing thrown");
      }
}

TEST_CASE_TEMPLATE(
    "A slanted needle's slack is 4/3 of its largest moment's at most, along (1, 1, 1)", Real,
    EVERY_PRECISION) {
  const auto slack_of = [](const Vec3<Real>& line) {
    const Vec3<Real> v = line.normalized();
    const Mat3<Real> needle = Mat3<Real>::Identity() - v * v.transpose();
    return moment_slack<Real>(needle, principal_axes(needle).axes, 1)(0);
  };
  // Σ |v_i| |I_ij| |v_j| is 2 Σ v_i² v_j² over the pairs; a dozen roundings of it, and of v.
  const Real roundings = 48 * unit_roundoff<Real>;
  CHECK(std::abs(slack_of({1, 1, 1}) - Real(4) / 3) <= roundings);
  RandomGenerator dice(33);
  for (int n = 0; n < 100; ++n)
    CHECK(slack_of(random_turn<Real>(dice).col(0)) <= Real(4) / 3 + roundings);
}

TEST_CASE_TEMPLATE("The slack of a moment is how far the worst errors of the elements move it",
                   Real, EVERY_PRECISION) {
  RandomGenerator dice(32);
  const Real slack = std::sqrt(unit_roundoff<Real>);
  const Mat3<Real> moments = diagonal<Real>(1, 2, 3);
  for (int n = 0; n < 20; ++n) {
    const Mat3<Real> inertia = in_other_axes(moments, random_turn<Real>(dice));
    const PrincipalAxes<Real> principal = principal_axes(inertia);
    const Vec3<Real> allowed = moment_slack<Real>(inertia, principal.axes, slack);
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3<Real> v = principal.axes.col(axis);
      Mat3<Real> errors;  // each with the sign that makes the sum over v_i v_j grow
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          errors(i, j) = slack * std::abs(inertia(i, j)) * (v(i) * v(j) < 0 ? Real(-1) : Real(1));
      const Real moved = principal_axes(Mat3<Real>(inertia + errors)).moments(axis);
      // What is of second order: the square of the errors' norm by the gap to the next moment, of
      // which they take no more than a tenth; and two times 96 roundings of the principal axes.
      const Real second_order = errors.squaredNorm() / Real(0.9);
      CHECK(std::abs(moved - principal.moments(axis) - allowed(axis)) <=
            second_order + 2 * 96 * unit_roundoff<Real> * inertia.norm());
    }
  }
}

TEST_CASE_TEMPLATE("A zero moment is refused where it would be inverted, never turned into 0", Real,
                   EVERY_PRECISION) {
  const std::string why =
      "the first is zero as far as rounding can tell, and zero has no inverse; give the body some "
      "thickness";
  CHECK(complaint_of([] { inverse_moments("rod", Vec3<Real>(0, 1, 1)); }) ==
        "rod: the principal moments are (0, 1, 1) kg m^2; " + why);
  CHECK(complaint_of([] { inverse_moments("point", Vec3<Real>(0, 0, 0)); }) ==
        "point: the principal moments are (0, 0, 0) kg m^2; " + why);
  // A slanted rod's zero comes out as a rounding, on either side of zero.
  RandomGenerator dice(33);
  for (int n = 0; n < 50; ++n) {
    const Mat3<Real> slanted =
        in_other_axes(mass_properties(ThinRod<Real>{1}, 1).inertia, random_turn<Real>(dice));
    CHECK(complaint_of([&] { inverse_inertia("rod", slanted); }).find(why) != std::string::npos);
  }
}

TEST_CASE_TEMPLATE(
    "A needle of 1 to 100 million is inverted to the last bit where it is given as "
    "three moments",
    Real, EVERY_PRECISION) {
  const Vec3<Real> moments(Real(1e-8), 1, 1);
  CHECK(same_bits(inverse_moments("needle", moments), moments.cwiseInverse()));
}

TEST_CASE_TEMPLATE("Moments from 1e-18 to 1e18 kg m² are judged and inverted alike", Real,
                   EVERY_PRECISION) {
  RandomGenerator dice(34);
  for (int n = 0; n < 20; ++n) {
    const Mat3<Real> plain =
        in_other_axes(diagonal<Real>(1, 2, Real(2.5)), random_turn<Real>(dice));
    const Mat3<Real> inverse = inverse_inertia("body", plain);
    CHECK((plain * inverse - Mat3<Real>::Identity()).norm() <=
          // 96 roundings of the principal frame, twice, times the ratio of the moments
          2 * 96 * unit_roundoff<Real> * Real(2.5));
    for (int k = -60; k <= 60; k += 8) {  // 2^60 is 1.2e18; in float the product of three is not
      const Real factor = std::ldexp(Real(1), k);
      const Mat3<Real> scaled = factor * plain;
      CHECK(same_bits(inverse_inertia("body", scaled), inverse / factor));
      CHECK(complaint_about(in_other_axes(diagonal(factor, factor, factor * Real(2.1)),
                                          Mat3<Real>(Mat3<Real>::Identity()))) != "nothing thrown");
    }
  }
}

TEST_CASE_TEMPLATE("Moments whose inverse leaves the range are refused with the limits", Real,
                   EVERY_PRECISION) {
  const Real tiny = std::numeric_limits<Real>::denorm_min();
  CHECK(complaint_of([&] {
          inverse_moments("dust", Vec3<Real>(tiny, tiny, tiny));
        }).find("each must lie between") != std::string::npos);
}
