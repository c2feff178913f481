#include <course/random_quaternion.hpp>
#include <numbers>
#include <tumble/sine_cosine.hpp>

using namespace tumble;
using namespace tumble::course;

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
TEST_CASE_TEMPLATE("Sine and cosine are right to two units in the last place, whatever the angle",
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
