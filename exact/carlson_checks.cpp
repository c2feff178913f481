#include <boost/math/special_functions/ellint_rf.hpp>
#include <boost/math/special_functions/ellint_rj.hpp>
#include <random>
#include <support/checks.hpp>
#include <tumble/exact/carlson.hpp>

using namespace tumble;
using namespace tumble::support;
using exact::carlson_rf, exact::carlson_rj;

namespace {

/// What the integrals may be off by, relative: four units in the last place.
template <class Real>
constexpr Real claimed = 8 * unit_roundoff<Real>;

}  // namespace

TEST_CASE_TEMPLATE("Carlson's integrals have the values that he printed", Real, float, double,
                   long double) {
  // "Numerical computation of real or complex elliptic integrals", section 3: to 14 digits.
  const auto agrees = [](Real mine, long double printed) {
    CHECK(std::abs(mine / printed - 1) <= claimed<Real> + 0.5e-13L);
  };
  agrees(carlson_rf<Real>(1, 2, 0), 1.3110287771461L);
  agrees(carlson_rf<Real>(Real(0.5), 1, 0), 1.8540746773014L);
  agrees(carlson_rf<Real>(2, 3, 4), 0.58408284167715L);
  agrees(carlson_rj<Real>(0, 1, 2, 3), 0.77688623778582L);
  agrees(carlson_rj<Real>(2, 3, 4, 5), 0.14297579667157L);
}

TEST_CASE_TEMPLATE("Carlson's integrals are those of Boost over twenty decades", Real, float,
                   double) {
  std::mt19937_64 generator(24);
  std::uniform_real_distribution<double> decades(-20, 3), part(0, 1);
  const auto drawn = [&] {
    return static_cast<Real>(std::pow(10, decades(generator) * part(generator)));
  };
  for (int trial = 0; trial < 5000; ++trial) {
    const Real x = trial % 5 == 0 ? Real(0) : drawn(), y = drawn(), p = drawn();
    const long double wide_x = x, wide_y = y, wide_p = p;
    CAPTURE(x);
    CAPTURE(y);
    CAPTURE(p);
    const long double rf = boost::math::ellint_rf(wide_x, wide_y, 1.0L),
                      rj = boost::math::ellint_rj(wide_x, wide_y, 1.0L, wide_p);
    CHECK(std::abs(carlson_rf<Real>(x, y, 1) / rf - 1) <= claimed<Real>);
    CHECK(std::abs(carlson_rj<Real>(x, y, 1, p) / rj - 1) <= claimed<Real>);
  }
}

TEST_CASE("Of equal arguments Carlson's integrals are powers of them") {
  for (const double x : {1e-30, 0.1, 1.0, 7.0, 1e30}) {
    CHECK(std::abs(carlson_rf<double>(x, x, x) * std::sqrt(x) - 1) <= claimed<double>);
    CHECK(std::abs(carlson_rj<double>(x, x, x, x) * (x * std::sqrt(x)) - 1) <= claimed<double>);
  }
}

TEST_CASE("Carlson's series leave out nothing below the sixth power of the differences") {
  if (std::numeric_limits<long double>::digits < 64)
    return;                               // then roundings hide what is left out
  const auto first = [](long double h) {  // the differences from a mean of 1 add up to 0
    const long double X = h, Y = 2 * h, Z = -3 * h;
    const exact::CarlsonSeries<long double> series{.two = X * Y - Z * Z, .three = X * Y * Z};
    return series.of_first_kind() - carlson_rf<long double>(1 - X, 1 - Y, 1 - Z);
  };
  const auto third = [](long double h) {
    const long double X = h, Y = 2 * h, Z = -7 * h, P = 2 * h;  // P counts twice
    const long double product = X * Y * Z, two = X * Y + X * Z + Y * Z - 3 * P * P;
    const exact::CarlsonSeries<long double> series{
        .two = two,
        .three = product + 2 * two * P + 4 * P * P * P,
        .four = (2 * product + two * P + 3 * P * P * P) * P,
        .five = product * P * P};
    return series.of_third_kind() - carlson_rj<long double>(1 - X, 1 - Y, 1 - Z, 1 - P);
  };
  // With the other sign of all differences odd powers change theirs, so both kinds can be seen by
  // themselves. Of the even ones the sixth is the first to be left out, of the odd ones the
  // seventh: halved differences leave a 64th and a 128th, where a wrong coefficient of the fourth
  // or the fifth power would leave a 16th or a 32nd. The bounds lie half way, by factors.
  const auto left_out = [](const auto& error, long double h, int sign) {
    return std::abs(error(h) + static_cast<long double>(sign) * error(-h));
  };
  const auto falls = [&](const auto& error, long double h) {
    CHECK(left_out(error, h, 1) > 32 * left_out(error, h / 2, 1));
    CHECK(left_out(error, h, -1) > 64 * left_out(error, h / 2, -1));
  };
  falls(first, 1.0L / 64);
  falls(third, 1.0L / 512);
}

TEST_CASE_TEMPLATE("A series is taken where its sixth power is half a roundoff, and no later", Real,
                   EVERY_PRECISION) {
  // The exponent 1/6 is rounded, which changes the power by -ln(least) roundings; pow() is out by a
  // unit in the last place, which is two roundings, six times over; then come five products, a
  // quotient and a difference.
  const Real least = unit_roundoff<Real> / 2, limit = exact::small_enough<Real>();
  const Real power = limit * limit * limit * limit * limit * limit;
  CHECK(std::abs(power / least - 1) <= (19 - std::log(least)) * unit_roundoff<Real>);
}
