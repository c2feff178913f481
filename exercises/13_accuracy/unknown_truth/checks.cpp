#include <exercise/judge.hpp>
#include <tumble/alternation.hpp>

using namespace tumble;
using namespace tumble::exercise;

namespace {

const Precondition orders[] = {
    {"better_result", 2, 1, 6}, {"error_left", 2, 1, 6}, {"shorter_by", 2, 1, 6}};

/// Where a pendulum is that was let go at 1 rad, after 4 s in so many steps by a row of chapter 13.
template <class Row, class Real>
Real pendulum(int steps) {
  Real angle = 1, rate = 0;
  for (int n = 0; n < steps; ++n)
    alternate<Row>(
        Real(4) / Real(steps), [&](Real h) { rate -= h * std::sin(angle); },
        [&](Real h) { angle += h * rate; });
  return angle;
}

/// The same by chapter 6's rule, of first order.
template <class Real>
Real pendulum_of_first_order(int steps) {
  Real angle = 1, rate = 0;
  const Real h = Real(4) / Real(steps);
  for (int n = 0; n < steps; ++n) {
    rate -= h * std::sin(angle);
    angle += h * rate;
  }
  return angle;
}

double truth() {
  static const double angle = pendulum<Suzuki, double>(4000);
  return angle;
}

}  // namespace

EXERCISE_CHECK("Three runs of a pendulum tell the order of the method that made them") {
  const auto look = [](const char* rule, Real coarse, Real middle, Real fine, double order) {
    const double first = double(coarse - middle), second = double(middle - fine);
    const double found = double(ask<Real>("observed_order", coarse, middle, fine));
    const double told = std::log2(first / second);
    Found(std::string("from three runs by ") + rule + ", the order", "", found)
        .mistake(
            first / second,
            "that is by how much the differences shrink, 2 to the power of the order. Take its "
            "logarithm")
        .mistake(std::log(first / second),
                 "a natural logarithm; the step is halved, so take that to base 2")
        .mistake(-std::log2(first / second),
                 "the ratio is turned round: larger difference over smaller")
        .mistake(double(std::log2(std::abs(coarse / middle))),
                 "the results themselves don't shrink. Their differences do")
        .must_be(told, 32 * unit_roundoff<Real>);
    // The next term of the error, smaller by h or h², is a few percent of the differences.
    require(std::abs(found - order) < 0.25,
            sentence(rule, " has the order ", order, ", and ", found, " was told"));
  };
  look("chapter 6's rule", pendulum_of_first_order<Real>(64), pendulum_of_first_order<Real>(128),
       pendulum_of_first_order<Real>(256), 1);
  look("Verlet's rule", pendulum<Verlet, Real>(16), pendulum<Verlet, Real>(32),
       pendulum<Verlet, Real>(64), 2);
  look("Suzuki's row", pendulum<Suzuki, Real>(8), pendulum<Suzuki, Real>(16),
       pendulum<Suzuki, Real>(32), 4);
}

EXERCISE_CHECK("Two results make a third with the leading error gone") {
  // First results that are so and no more: T = 3, C h^p = 1.
  for (const int order : {1, 2, 4}) {
    const double power = std::exp2(order);
    const Real coarse = 4, fine = Real(3 + 1 / power);
    Found(sentence("from 4 and ", fine, ", by a method of order ", order, ", the better result"),
          "", double(ask<Real>("better_result", coarse, fine, order)))
        .mistake(3 + 2 / power,
                 "it was led away from the truth. The finer result is nearer to it than the "
                 "coarse one: go on in that direction")
        .mistake(
            double(fine) + (double(fine) - 4) / power,
            "nearly. The difference of the two is the coarse error *less* the fine one, so divide "
            "by 2^p - 1")
        .mistake(double(fine) + (double(fine) - 4) / order,
                 "the order is an exponent: half the step has a 2^p-th of the error")
        .mistake(2 * double(fine) - 4, "that is right for order 1 alone")
        .mistake((double(fine) + 4) / 2, "a mean lies between them, and the truth does not")
        .must_be(3, 64 * unit_roundoff<Real>);
  }
  const Real coarse = pendulum<Verlet, Real>(16), fine = pendulum<Verlet, Real>(32);
  const double better = double(ask<Real>("better_result", coarse, fine, 2));
  const double before = std::abs(double(fine) - truth()), after = std::abs(better - truth());
  // What is left is smaller by h², h = 1/8.
  require(after < before / 8, sentence("by two runs of Verlet's rule the pendulum is known to ",
                                       before, " rad, and with your better result to ", after,
                                       "; it must be eight times better"));
}

EXERCISE_CHECK("The error that is left is estimated to a quarter, without the truth") {
  const auto look = [](const char* rule, Real coarse, Real fine, int order) {
    const double error = std::abs(double(fine) - truth());
    const double apart = std::abs(double(coarse) - double(fine)), power = std::exp2(order);
    const double estimate = apart / (power - 1);
    const double found = double(ask<Real>("error_left", coarse, fine, order));

    Found(std::string("by two runs with ") + rule + ", the error of the finer one", "rad", found)
        .mistake(estimate * power, "that is the error of the coarser one")
        .mistake(-estimate, "an error bar has no sign; take its size")
        .mistake(apart,
                 "that is how far the results are apart. Most of it is the error of the coarse one")
        // Both results are rounded, and so is what is made of them.
        .must_be(estimate, 8 * unit_roundoff<Real> * std::abs(double(fine)));
    require(std::abs(found - error) < error / 4,
            sentence("by ", rule, " the error is ", error, " rad, and ", found, " was estimated"));
  };
  look("Verlet's rule", pendulum<Verlet, Real>(32), pendulum<Verlet, Real>(64), 2);
  look("Suzuki's row", pendulum<Suzuki, Real>(8), pendulum<Suzuki, Real>(16), 4);
}

EXERCISE_CHECK("A step that is shorter by the factor found has the error that was asked for") {
  for (const int order : {1, 2, 4})
    for (const auto& [error, tolerance] : {std::pair(12.0, 0.046875), {40.5, 0.5}}) {
      const double ratio = error / tolerance, factor = std::pow(ratio, 1.0 / order);
      Found(
          sentence("to make an error of ", error, " one of ", tolerance, ", by a method of order ",
                   order, ", the step must be shorter by a factor that"),
          "", double(ask<Real>("shorter_by", Real(error), Real(tolerance), order)))
          .mistake(std::pow(ratio, order),
                   "the error falls faster than the step, not the step faster than the "
                   "error: take the root")
          .mistake(
              ratio,
              "that is right for order 1 alone: the error falls as the step to the power of the "
              "order")
          .mistake(
              1 / factor,
              "that is the new step, as a part of the old one; it is by how much it is shorter")
          .mistake(ratio / order, "the order is an exponent")
          .must_be(factor, 64 * unit_roundoff<Real> * factor);
    }
}

EXERCISE_CHECK(
    "Where only roundings differ, or the differences don't shrink, there is no order to tell") {
  const auto look = [](Real coarse, Real middle, Real fine, const std::string& why) {
    ask_refusal(sentence("from ", coarse, ", ", middle, " and ", fine, " an order was told. ", why),
                "observed_order", coarse, middle, fine);
  };
  const Real one_rounding = std::numeric_limits<Real>::epsilon();
  look(1, 2, 2, "The last two are equal: there is no ratio to zero");
  look(1 + 16 * one_rounding, 1 + one_rounding, 1,
       "The last two differ by a rounding, so the ratio is noise: ask for more than 4 epsilon");
  look(1024 * (1 + 16 * one_rounding), 1024 * (1 + one_rounding), 1024,
       "The last two differ by a rounding of a thousand, so the ratio is noise: ask for more than "
       "4 epsilon times the last");
  look(1 + 16 * one_rounding, 1 + 4 * one_rounding, 1,
       "The last two differ by 4 epsilon, and more than that is asked for");
  look(1, 2, Real(1.5), "The results go up and down: a ratio below zero has no logarithm");
  look(1, Real(1.125), Real(1.5),
       "The differences grow: the steps are too long for an order to show");
  look(3, 2, 1, "The differences are equal: they must shrink for an order to show");
  Found("differences of 10 and 5 epsilon are more than 4: the order", "",
        double(ask<Real>("observed_order", 1 + 15 * one_rounding, 1 + 5 * one_rounding, Real(1))))
      .must_be(1, 64 * unit_roundoff<Real>);
  const double order =
      double(ask<Real>("observed_order", 1 + 64 * one_rounding, 1 + 16 * one_rounding, Real(1)));
  Found("differences of 48 and 16 epsilon can be told from roundings: the order", "", order)
      .must_be(std::log2(3.0), 64 * unit_roundoff<Real>);
  const Real small = Real(0x1p-20);
  const double of_small = double(ask<Real>("observed_order", (1 + 64 * one_rounding) * small,
                                           (1 + 16 * one_rounding) * small, small));
  Found("from a millionth of three such results, the order", "", of_small)
      .must_be(std::log2(3.0), 64 * unit_roundoff<Real>);
  // As of a method at a kink of its motion.
  Found("from differences of 1.5 and 1, the order", "",
        double(ask<Real>("observed_order", Real(3.5), Real(2), Real(1))))
      .must_be(std::log2(1.5), 64 * unit_roundoff<Real>);
}
