// Three numbers and a right-handed frame, for every tensor there is.
#include <support/checks.hpp>
#include <support/particle_cloud.hpp>
#include <tumble/mass_properties.hpp>
#include <tumble/principal_axes.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

// Some 12 turns with 4 roundings of each element, and as many again in the reconstruction.
template <class Real>
constexpr Real slack = 96 * unit_roundoff<Real>;

template <class Real>
void check_axes(const Mat3<Real>& inertia, const PrincipalAxes<Real>& found) {
  const auto& [moments, axes] = found;
  CHECK(moments(0) <= moments(1));
  CHECK(moments(1) <= moments(2));
  CHECK((axes.transpose() * axes - Mat3<Real>::Identity()).norm() <= slack<Real>);
  CHECK(std::abs(axes.determinant() - 1) <= slack<Real>);
  const Mat3<Real> diagonal = moments.asDiagonal();
  CHECK((in_other_axes(diagonal, axes) - inertia).norm() <= slack<Real> * inertia.norm());
}

template <class Real>
Mat3<Real> turned(const Vec3<Real>& moments, RandomGenerator& dice) {
  const Mat3<Real> diagonal = moments.asDiagonal();
  return in_other_axes(diagonal, random_turn<Real>(dice));
}

}  // namespace

TEST_CASE_TEMPLATE("The principal frame is right-handed and puts the tensor together again", Real,
                   EVERY_PRECISION) {
  RandomGenerator dice(21);
  for (int n = 0; n < 100; ++n) {
    const Mat3<Real> inertia = turned(Vec3<Real>(1, 2, Real(2.5)), dice);
    check_axes(inertia, principal_axes(inertia));
  }
}

TEST_CASE_TEMPLATE("Bodies with two or three equal moments get a right-handed frame too", Real,
                   EVERY_PRECISION) {
  RandomGenerator dice(22);
  for (int n = 0; n < 100; ++n)
    for (const Vec3<Real>& moments :
         {Vec3<Real>(1, 2, 2), Vec3<Real>(1, 1, 2), Vec3<Real>(3, 3, 3), Vec3<Real>(0, 1, 1)}) {
      const Mat3<Real> inertia = turned(moments, dice);
      check_axes(inertia, principal_axes(inertia));
    }
}

TEST_CASE_TEMPLATE(
    "A product of inertia is gone below a rounding of the smaller moment, and not above", Real,
    EVERY_PRECISION) {
  const Mat3<Real> untouched = Mat3<Real>::Identity();
  for (const auto& [p, q] : {std::pair(0, 1), std::pair(0, 2), std::pair(1, 2)}) {
    const auto axes_with = [one = p, other = q](Real roundings) {
      Mat3<Real> inertia = Vec3<Real>(1, 2, 4).asDiagonal();
      const Real product = roundings * unit_roundoff<Real> * inertia(one, one);
      inertia(one, other) = inertia(other, one) = product;
      return principal_axes(inertia).axes;
    };
    CHECK(same_bits(axes_with(1), untouched));
    CHECK_FALSE(same_bits(axes_with(Real(1.5)), untouched));
  }
}

TEST_CASE_TEMPLATE(
    "Near the end each product of inertia that is removed is that of the two before, by a "
    "difference of moments",
    Real, EVERY_PRECISION) {
  const Real small = Real(1) / 64, gap = Real(0.5);  // no two of the moments are nearer
  Mat3<Real> I, axes = Mat3<Real>::Identity();
  I << 1, small, -small,  //
      small, 2, 0,        //
      -small, 0, Real(2.5);
  const std::array<std::array<int, 2>, 3> pairs = {{{0, 1}, {0, 2}, {1, 2}}};
  Real before = 0, second_before = 0, gap_before = 1, gap_second_before = 1;
  for (std::size_t n = 0; n < 7; ++n) {
    const auto [p, q] = pairs[n % 3];
    const Real product = I(p, q), apart = I(q, q) - I(p, p);
    // A turn by the angle x/gap brings back as much of the next product. Its tangent differs from
    // that by (x/gap)², the moments move by half as much, and the next turn shortens it by as
    // little as (x/gap)²/2 of the next x. Then 16 roundings.
    if (n > 1) {
      const Real expected = std::abs(second_before * before / gap_second_before);
      CHECK(std::abs(std::abs(product) / expected - 1) <=
            2 * (second_before * second_before + before * before) / (gap * gap) +
                16 * unit_roundoff<Real>);
    }
    second_before = before;
    before = product;
    gap_second_before = gap_before;
    gap_before = apart;
    remove_product(I, axes, p, q);
  }
  CHECK(std::abs(before) < std::pow(small / gap, Real(13)));  // 1, 1, 2, 3, 5, 8, 13
}

TEST_CASE_TEMPLATE(
    "In a frame turned back by phi the product of inertia is what the formula says, and none is "
    "left",
    Real, EVERY_PRECISION) {
  RandomGenerator dice(25);
  for (int n = 0; n < 100; ++n) {
    const Mat3<Real> inertia = turned(Vec3<Real>(1, 2, Real(2.5)), dice);
    const Real phi = dice.vector<Real>().x(), sine = std::sin(phi), cosine = std::cos(phi);
    Mat3<Real> back;  // in its columns the frame's axes, turned by −φ about z
    back << cosine, sine, 0, -sine, cosine, 0, 0, 0, 1;
    const auto formula = [&](Real s) {
      return (cosine * cosine - s * s) * inertia(0, 1) +
             s * cosine * (inertia(0, 0) - inertia(1, 1));
    };
    const Mat3<Real> seen = back.transpose() * inertia * back;
    CHECK(std::abs(seen(0, 1) - formula(sine)) <= slack<Real> * inertia.norm());
    const Mat3<Real> forth = back * inertia * back.transpose();  // turned by +φ: φ changes its sign
    CHECK(std::abs(forth(0, 1) - formula(-sine)) <= slack<Real> * inertia.norm());

    Mat3<Real> removed = inertia, axes = Mat3<Real>::Identity();
    remove_product(removed, axes, 0, 1);
    CHECK(removed(0, 1) == 0);
    CHECK((axes.transpose() * inertia * axes - removed).norm() <= slack<Real> * inertia.norm());
    CHECK(axes(0, 0) >= std::sqrt(Real(0.5)) * (1 - slack<Real>));  // by 45 degrees at most
  }
}

TEST_CASE_TEMPLATE("A diagonal tensor comes out with its own numbers, to the bit, in any order",
                   Real, EVERY_PRECISION) {
  for (const Vec3<Real>& moments :
       {Vec3<Real>(Real(0.1), Real(0.2), Real(0.3)), Vec3<Real>(Real(0.3), Real(0.1), Real(0.2)),
        Vec3<Real>(Real(0.2), Real(0.3), Real(0.1)), Vec3<Real>(Real(0.3), Real(0.2), Real(0.1)),
        Vec3<Real>(Real(0.7), Real(0.7), Real(0.7)), Vec3<Real>(0, 0, 0)}) {
    const Mat3<Real> inertia = moments.asDiagonal();
    const auto [found, axes] = principal_axes(inertia);
    const Mat3<Real> diagonal = found.asDiagonal();
    CHECK(same_bits(axes * diagonal * axes.transpose(), inertia));
    CHECK(axes.determinant() == 1);
  }
}

TEST_CASE_TEMPLATE("A needle nearly along an axis keeps the relative accuracy of its small moment",
                   Real, EVERY_PRECISION) {
  // Moments (s, 1, 1) with s far below a rounding of 1, and the needle along v, nearly x. The
  // witness sums positive terms only: I = s v vᵀ + (δ − v vᵀ), and 1 − v_x² is v_y² + v_z².
  const Real s = unit_roundoff<Real> * unit_roundoff<Real>, slant = std::sqrt(s) / 4;
  const Vec3<long double> v = Vec3<long double>(1, slant, slant / 2).normalized();
  const Mat3<long double> v_v = v * v.transpose();
  const Mat3<long double> inertia =
      static_cast<long double>(s) * v_v + inertia_from_second_moments(v_v);
  // Scaled by their moments the products are at most 1/4, so a relative error in the elements grows
  // no more than twofold; a cast rounds once, each of some 4 turns 4 times. A method that only
  // knows the size of the largest moment would lose all of s.
  CHECK(std::abs(principal_axes(Mat3<Real>(inertia.template cast<Real>())).moments(0) - s) <=
        2 * (1 + 4 * 4) * unit_roundoff<Real> * s);
}

TEST_CASE_TEMPLATE("Where mirrored elements differ by roundings, their mean counts, to the bit",
                   Real, EVERY_PRECISION) {
  RandomGenerator dice(25);
  for (int n = 0; n < 20; ++n) {
    const Mat3<Real> symmetric = turned(Vec3<Real>(1, 2, Real(2.5)), dice);
    Mat3<Real> lopsided = symmetric, mean = symmetric;
    for (const auto& [p, q] : {std::pair(0, 1), std::pair(0, 2), std::pair(1, 2)}) {
      lopsided(p, q) += 16 * unit_roundoff<Real>;
      lopsided(q, p) -= 24 * unit_roundoff<Real>;
      mean(p, q) = mean(q, p) = (lopsided(p, q) + lopsided(q, p)) / 2;
    }
    const auto [moments, axes] = principal_axes(mean);
    for (const Mat3<Real>& other : {lopsided, Mat3<Real>(lopsided.transpose())}) {
      CHECK(same_bits(principal_axes(other).moments, moments));
      CHECK(same_bits(principal_axes(other).axes, axes));
    }
  }
}

TEST_CASE_TEMPLATE("Principal moments scale by powers of two without changing another bit", Real,
                   EVERY_PRECISION) {
  RandomGenerator dice(24);
  for (int n = 0; n < 20; ++n) {
    const Mat3<Real> inertia = turned(Vec3<Real>(1, 2, Real(2.5)), dice);
    const auto [moments, axes] = principal_axes(inertia);
    for (const int k : {-60, -41, 7, 41, 60}) {
      const Mat3<Real> scaled = std::ldexp(Real(1), k) * inertia;
      CHECK(same_bits(principal_axes(scaled).moments, std::ldexp(Real(1), k) * moments));
      CHECK(same_bits(principal_axes(scaled).axes, axes));
    }
  }
}
