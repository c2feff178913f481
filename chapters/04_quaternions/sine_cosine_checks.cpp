#include <numbers>
#include <support/random_quaternion.hpp>
#include <tumble/sine_cosine.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

/// The distance of `value` from `exact` in units of the last place that `Real` has there.
template <class Real>
long double units_off(Real value, long double exact) {
  int exponent = 0;
  std::frexp(exact, &exponent);
  exponent = std::max(exponent, std::numeric_limits<Real>::min_exponent);
  return std::abs(value - exact) / std::ldexp(1.0L, exponent - std::numeric_limits<Real>::digits);
}

/// The larger distance of the two from the standard library's, computed in long double.
template <class Real>
long double units_off(Real angle) {
  const SineCosine<Real> ours = sine_cosine(angle);
  const long double exact = angle;
  return std::max(units_off(ours.sine, std::sin(exact)), units_off(ours.cosine, std::cos(exact)));
}

}  // namespace

// Half a unit for rounding the reduced angle, half for the last sum, and what the products before
// it leave; 1.5 is the largest seen in millions of angles.
TEST_CASE_TEMPLATE(
    "Sine and cosine of random angles up to the limit are right to two units in the last place",
    Real, EVERY_PRECISION) {
  std::mt19937_64 generator(1);
  const Real limit = SineCosineConstants<Real>::limit;
  for (const Real size : {Real(1), Real(4), Real(100), limit}) {
    CAPTURE(size);
    long double worst = 0;
    for (int trial = 0; trial < 20'000; ++trial)
      worst = std::max(worst, units_off(size * random_number<Real>(generator)));
    CHECK(worst <= 2);
  }
}

// The digits that cancel there are made up from the third and fourth piece of π/2: 2.2 is the
// largest seen, in float.
TEST_CASE_TEMPLATE(
    "Next to multiples of a quarter turn sine and cosine are right to two and a half units", Real,
    EVERY_PRECISION) {
  const long double quarter_turn = std::numbers::pi_v<long double> / 2;
  const int most = static_cast<int>(SineCosineConstants<Real>::limit / 2);
  long double worst = 0;
  for (int turns = 1; turns < most; turns += 1 + turns / 500) {
    const Real angle = static_cast<Real>(turns * quarter_turn);
    for (const Real beside :
         {std::nextafter(angle, Real(0)), angle, std::nextafter(angle, 2 * angle)})
      worst = std::max({worst, units_off(beside), units_off(-beside)});
  }
  CHECK(worst <= 2.5L);
}

TEST_CASE_TEMPLATE("A tiny angle, down to the smallest that can be stored, is its own sine", Real,
                   EVERY_PRECISION) {
  const Real root = std::sqrt(std::numeric_limits<Real>::epsilon());
  for (Real angle = root / 2; angle > 0; angle /= 16) {
    CHECK(sine_cosine(angle).sine == angle);
    CHECK(sine_cosine(-angle).sine == -angle);
    CHECK(sine_over_angle(sine_cosine(angle).sine, angle) == 1);
  }
  for (const Real angle : {Real(0), -Real(0), root / 4}) CHECK(sine_cosine(angle).cosine == 1);
  CHECK(sine_cosine(Real(0)).sine == 0);
  CHECK(sine_over_angle(Real(0), Real(0)) == 1);
}

TEST_CASE_TEMPLATE(
    "Where an angle's square begins to be seen beside 1, both are right to two units", Real,
    EVERY_PRECISION) {
  const Real root = std::sqrt(std::numeric_limits<Real>::epsilon());
  long double worst = 0;
  for (Real angle = root / 16; angle < 16 * root; angle *= Real(1.0625))
    worst = std::max({worst, units_off(angle), units_off(-angle)});
  CHECK(worst <= 2);
}

TEST_CASE_TEMPLATE("Turned the other way the sine changes its sign and nothing else, to the bit",
                   Real, EVERY_PRECISION) {
  std::mt19937_64 generator(3);
  for (int trial = 0; trial < 1000; ++trial) {
    const Real angle = 100 * random_number<Real>(generator);
    CHECK(sine_cosine(-angle).sine == -sine_cosine(angle).sine);
    CHECK(sine_cosine(-angle).cosine == sine_cosine(angle).cosine);
  }
}

TEST_CASE_TEMPLATE("An angle beyond the stated limit gives NaN, never a wrong number", Real,
                   EVERY_PRECISION) {
  const Real limit = SineCosineConstants<Real>::limit;
  CHECK(limit == (std::is_same_v<Real, float> ? 1536 : 1572864));
  CHECK(units_off(limit) <= 2);
  CHECK(units_off(-limit) <= 2);
  using Limits = std::numeric_limits<Real>;
  for (const Real angle :
       {std::nextafter(limit, 2 * limit), Limits::max(), Limits::infinity(), Limits::quiet_NaN()})
    for (const Real signed_angle : {angle, -angle}) {
      CHECK(std::isnan(sine_cosine(signed_angle).sine));
      CHECK(std::isnan(sine_cosine(signed_angle).cosine));
    }
}

TEST_CASE_TEMPLATE("Each coefficient of both series is 1/n! rounded once, whatever long double is",
                   Real, EVERY_PRECISION) {
  using Constants = SineCosineConstants<Real>;
  for (const int first : {0, 1}) {
    const auto& series = first == 0 ? Constants::cosine_series : Constants::sine_series;
    std::uint64_t factorial = 1;
    for (int term = 0; term < Constants::terms; ++term) {
      const Real coefficient = series[static_cast<std::size_t>(term)];
      const Real sign = term % 2 == 0 ? Real(1) : Real(-1);
      // n! times half a unit in the coefficient's last place; fma() subtracts 1 without a rounding.
      const Real half_a_unit =
          std::ldexp(Real(1), std::ilogb(coefficient) - std::numeric_limits<Real>::digits);
      const Real n = static_cast<Real>(factorial);
      CHECK(static_cast<std::uint64_t>(n) == factorial);
      CHECK(std::abs(std::fma(sign * coefficient, n, Real(-1))) <= n * half_a_unit);
      const std::uint64_t next =
          2 * static_cast<std::uint64_t>(term) + static_cast<std::uint64_t>(first) + 1;
      factorial *= next * (next + 1);
    }
  }
}
