#include <boost/math/special_functions/ellint_3.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <numbers>
#include <support/checks.hpp>
#include <tumble/exact/jacobi.hpp>
#include <tumble/exact/pi.hpp>

using namespace tumble;
using namespace tumble::support;
using exact::Jacobi;

#define LONG_PRECISIONS double, long double

TEST_CASE_TEMPLATE("sn and cn are those of Boost, where the modulus can hold the parameter", Real,
                   LONG_PRECISIONS) {
  for (const Real m : {0.0, 0.1, 0.3, 0.5, 0.6, 0.8, 0.95}) {
    const Jacobi<Real> jacobi(m, 1 - m);
    for (Real u = -20; u <= 20; u += Real(0.37)) {
      Real cn, dn;
      const Real sn = boost::math::jacobi_elliptic(std::sqrt(m), u, &cn, &dn);
      const auto mine = jacobi.at(u);
      // u is reduced by whole periods, of which Carlson's integral has 8 roundings, the product and
      // the difference 2; sn, cn and dn have 14 by Landen's steps, and 2 by their ratio where they
      // are mirrored. Boost may err by as much again.
      const Real allowed = 2 * (16 + 10 * std::abs(u)) * unit_roundoff<Real>;
      CHECK(std::abs(mine.sn - sn) <= allowed);
      CHECK(std::abs(mine.cn - cn) <= allowed);
      // Boost's dn loses digits where cn is small; the definition does not.
      CHECK(std::abs(mine.dn - std::sqrt(cn * cn + (1 - m) * (sn * sn))) <= allowed);
    }
  }
}

TEST_CASE_TEMPLATE("A parameter of 0 makes sines, one of 1 makes hyperbolic functions", Real,
                   LONG_PRECISIONS) {
  const Jacobi<Real> circle(0, 1), edge(1, 0);
  CHECK(circle.quarter_period() == doctest::Approx(std::numbers::pi / 2).epsilon(1e-15));
  CHECK(std::isinf(edge.quarter_period()));
  for (const Real u : {-4.0, -1.0, 0.0, 0.001, 0.7, 1.5, 3.0, 30.0}) {
    const auto [sn, cn, dn] = circle.at(u);
    const Real allowed = 8 * (1 + std::abs(u)) * unit_roundoff<Real>;
    CHECK(std::abs(sn - std::sin(u)) <= allowed);
    CHECK(std::abs(cn - std::cos(u)) <= allowed);
    CHECK(dn == 1);
    const auto [tanh, sech, also_sech] = edge.at(u);
    CHECK(std::abs(tanh - std::tanh(u)) <= 4 * unit_roundoff<Real>);
    CHECK(std::abs(sech * std::cosh(u) - 1) <= 8 * unit_roundoff<Real>);
    CHECK(std::abs(also_sech / sech - 1) <= 8 * unit_roundoff<Real>);
  }
  for (const Real u : {Real(1e6), std::numeric_limits<Real>::max()}) {
    const auto far = edge.at(u);
    CHECK(far.sn == 1);
    CHECK(far.cn > 0);
    CHECK(far.dn > 0);
  }
}

TEST_CASE(
    "Near either end of the parameter double keeps the digits of long double, the small values "
    "too") {
  for (const double small : {1e-30, 1e-17, 1e-12, 1e-8, 1e-4, 0.3})
    for (const bool near_one : {false, true}) {
      const long double rest = 1 - static_cast<long double>(small);
      const long double m = near_one ? rest : static_cast<long double>(small),
                        m1 = near_one ? static_cast<long double>(small) : rest;
      const Jacobi<long double> truth(m, m1);
      const Jacobi<double> mine(static_cast<double>(m), static_cast<double>(m1));
      const long double K = truth.quarter_period();
      CHECK(std::abs(mine.quarter_period() / K - 1) <= 8 * unit_roundoff<double>);
      for (const double part : {-1.9, -1.0, -0.7, 1e-9, 0.3, 0.5, 0.8, 0.99, 1.2, 1.7}) {
        const double u = part * static_cast<double>(K);
        const auto [sn, cn, dn] = mine.at(u);
        const auto right = truth.at(u);
        // Eight operations, and what the rounding of K makes of a small sn or cn: their slope is 1
        // at most, so that the argument's error counts once.
        const long double allowed = 16 * unit_roundoff<double>, slip = std::abs(u) * allowed;
        CHECK(std::abs(sn - right.sn) <=
              allowed * std::abs(right.sn) + slip * std::abs(right.cn * right.dn));
        CHECK(std::abs(cn - right.cn) <=
              allowed * std::abs(right.cn) + slip * std::abs(right.sn * right.dn));
        CHECK(std::abs(dn - right.dn) <=
              allowed * right.dn + slip * m * std::abs(right.sn * right.cn));
      }
    }
}

TEST_CASE_TEMPLATE("The argument of sn and cn takes them back", Real, LONG_PRECISIONS) {
  for (const Real m1 : {1.0, 0.5, 0.05, 1e-6, 1e-14}) {
    const Jacobi<Real> jacobi(1 - m1, m1);
    for (const Real part : {-0.999, -0.4, 0.0, 1e-7, 0.2, 0.7, 0.98}) {
      const Real u = part * jacobi.quarter_period();
      const auto [sn, cn, dn] = jacobi.at(u);
      // Carlson's integral has 8 roundings, and its argument takes 6 from sn and cn for each of two
      // squares.
      CHECK(std::abs(jacobi.argument_of(3 * sn, 3 * cn) - u) <=
            (8 + 2 * 6) * jacobi.quarter_period() * unit_roundoff<Real>);
    }
  }
}

TEST_CASE_TEMPLATE(
    "The integral of the third kind is that of Boost, and goes on over whole periods", Real,
    LONG_PRECISIONS) {
  for (const Real m : {0.0, 0.1, 0.4, 0.6, 0.9})
    for (const Real n : {0.0, 0.2, 0.5, 0.97}) {
      const Jacobi<Real> jacobi(m, 1 - m);
      for (Real angle = -12; angle < 12; angle += Real(0.41)) {
        const Real within = std::remainder(angle, exact::pi<Real>);
        const Real half_turns = std::nearbyint((angle - within) / exact::pi<Real>);
        const Real u = jacobi.argument_of(std::sin(within), std::cos(within)) +
                       half_turns * jacobi.half_period();
        const Real theirs = boost::math::ellint_3(std::sqrt(m), n, angle);
        // Where n is 0.97 the integrand is 1/(1 - n) at most, and with it what a rounding of u
        // does: 8 in K or F, and 8 in the integral itself, 4 by products and sums.
        CHECK(std::abs(jacobi.third_kind(n, 1 - n, u) - theirs) <=
              (8 + 8 + 4) * (1 + std::abs(angle)) / (1 - n) / std::sqrt(1 - m) *
                  unit_roundoff<Real>);
      }
    }
}
