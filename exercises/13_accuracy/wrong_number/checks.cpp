#include <exercise/judge.hpp>
#include <tumble/compositions.hpp>
#include <tumble/runge_kutta.hpp>

using namespace tumble;
using namespace tumble::exercise;

namespace {

const Vec3d start(0.6, 1.2, -0.9);

/// By the chapter's row of eighth order.
Vec3d truth(double time) {
  Topd top;
  top.inverse_moments = {1, 0.5, 1.0 / 3};
  top.angular_momentum_body = start;
  const int steps = 400;
  for (int n = 0; n < steps; ++n) turn_by_row<KahanLiEighth>(top, time / steps);
  return top.angular_momentum_body;
}

/// A table whose sums are wrong needs no other check.
template <class Real>
void require_sums() {
  const Real off = ask<Real>("astray");
  require(
      off <= 16 * unit_roundoff<Real>,
      "the weights must make up 1, and each row of coefficients its node, else even a steady turn "
      "goes astray: "
      "here one of these sums is off by " +
          shown(off) + ". They were right before");
}

/// The table whose third row has so many thirds, and all else as the student got it.
template <int first, int second>
struct WithThirdRow {
  static constexpr Tableau<4> rule = {
      .nodes = {0, 1 / 3.0L, 2 / 3.0L, 1},
      .weights = {1 / 8.0L, 3 / 8.0L, 3 / 8.0L, 1 / 8.0L},
      .coefficients = {{{}, {1 / 3.0L}, {first / 3.0L, second / 3.0L}, {1, -1, 1}}}};
};

/// Whether a step by the student's table does what one by that table does. Its sum of chains alone
/// can't say so: others have the same.
template <int first, int second, class Real>
bool is_table() {
  const Real h = Real(0.5);
  Top<Real> top;
  top.inverse_moments = {1, Real(0.5), Real(1) / 3};
  top.angular_momentum_body = start.cast<Real>();
  turn_by_runge_kutta<WithThirdRow<first, second>, Real>(top, h);
  const auto found = ask<Vec3<Real>>("momentum_after", Vec3<Real>(start.cast<Real>()), h, 1);
  return farthest(found, top.angular_momentum_body) <= 64 * unit_roundoff<Real>;
}

/// What is wrong with the student's table, if it is one of those that are often found.
template <class Real>
std::string table_said() {
  if (is_table<1, 1, Real>())
    return "that is the table as you got it. The weights and nodes are right; look at what leads a "
           "stage";
  if (is_table<3, -1, Real>()) return "it is the right pair of numbers, the wrong way round";
  if (is_table<2, 0, Real>())
    return "the third stage follows the first alone now, as if the second had not been made";
  if (is_table<0, 2, Real>())
    return "the third stage follows the second alone now. That is how the classical rule does it, "
           "with other nodes";
  return "";
}

/// How far the top's angular momentum (kg m²/s) is off after the same 4 s in 8 and in 16 steps.
struct Errors {
  double coarse, fine;
  double ratio() const { return coarse / fine; }
};

template <class Real>
Errors errors() {
  const double time = 4;
  static const Vec3d where = truth(time);
  const auto error = [&](int steps) {
    const auto found = ask<Vec3<Real>>("momentum_after", Vec3<Real>(start.cast<Real>()),
                                       Real(time / steps), steps);
    return (found.template cast<double>() - where).norm();
  };
  return {error(8), error(16)};
}

}  // namespace

EXERCISE_CHECK(
    "Stages that depend on other stages have their proper weight: the sum of chains is 1/6") {
  require_sums<Real>();
  const double sum = double(ask<Real>("sum_of_chains"));
  Found chains("the sum of weight times coefficient times node", "", sum);
  if (const std::string said = table_said<Real>(); !said.empty()) chains.mistake(sum, said);
  chains.must_be(1.0 / 6, 4 * unit_roundoff<Real>);
  // Between 4 of second order and 8 of third, which the sum makes it.
  require(errors<Real>().ratio() > 6,
          "the sum is said to be right, and still the rule that turns the top is of second order: "
          "half the step divides its error by " +
              shown(errors<Real>().ratio()) + ". What has to be right is the table that turns it");
}

EXERCISE_CHECK("With half the step the error of a tumbling top is a sixteenth") {
  require_sums<Real>();
  const auto [coarse, fine] = errors<Real>();
  const std::string runs = "in 8 steps the error is " + shown(coarse) +
                           " kg m²/s and in 16 steps " + shown(fine) +
                           ". Half the step divides it by " + shown(coarse / fine) + "; ";
  require(
      coarse / fine > 6,
      runs + "that is a rule of second order, which pays for four evaluations and is worth two");
  require(coarse / fine > 11,
          runs +
              "that is a rule of third order. Another row than the wrong one can make the sum of "
              "chains right, too: was yours right before? Put it back, and change the other");
  // The next order makes some part more or less of it at such steps.
  require(coarse / fine < 40, runs + "a rule of fourth order divides it by 16");
}
