#include <exercise/judge.hpp>
#include <tumble/embedded_steps.hpp>

using namespace tumble;
using namespace tumble::exercise;

namespace {

const Precondition powers("step_factor", 2, 1, 8);

template <class Real>
double factor(double ratio, double before, int power) {
  return double(ask<Real>("step_factor", Real(ratio), Real(before), power));
}

/// Two powers, which each round a few times, and a product. An exponent of two roundings makes as
/// many of the logarithm, which is below 21.
template <class Real>
constexpr double rounding = 64 * unit_roundoff<Real>;

std::string after(double ratio, double before, int power) {
  return sentence("for the ratios ", ratio, " and, before it, ", before, " and the power ", power,
                  ", the factor");
}

}  // namespace

EXERCISE_CHECK(
    "An error is a part of what its step may add, and a tolerance that cannot be is refused") {
  for (const auto& [error, tolerance, step] :
       {std::array{12.0, 0.5, 3.0}, std::array{0.375, 0.25, 0.125}})
    Found(sentence("for an error of ", error, " rad in a step of ", step, " s and a tolerance of ",
                   tolerance, " rad a second, the ratio"),
          "", double(ask<Real>("error_ratio", Real(error), Real(tolerance), Real(step))))
        .mistake(error / tolerance,
                 "that takes the tolerance for what a *step* may add. It is for a second, so a "
                 "short step may add less")
        .mistake(error * step / tolerance,
                 "a longer step may add more, so its ratio is smaller: divide by the step")
        .mistake(tolerance * step / error, "that is turned round: the error over what it may be")
        .must_be(error / (tolerance * step), 8 * unit_roundoff<Real> * error / (tolerance * step));
  constexpr Real infinite = std::numeric_limits<Real>::infinity();
  for (const Real none : {Real(0), Real(-0.5), infinite, std::numeric_limits<Real>::quiet_NaN()})
    ask_refusal(sentence("with a tolerance of ", none,
                         " rad a second a ratio was told. A tolerance must be finite and greater "
                         "than 0 rad a second"),
                "error_ratio", Real(1), none, Real(0.5));
}

EXERCISE_CHECK("The larger root is what each step leaves of a deviation") {
  // Of z² = (1 - last) z + before: 0.8 and -0.5; 0 twice; 0.5 and -0.5; 0.3 and -0.8; 0.4, -1.6.
  for (const auto& [last, before] :
       {std::array{0.7, 0.4}, {1.0, 0.0}, {1.0, 0.25}, {1.5, 0.24}, {2.2, 0.64}}) {
    const double sum = 1 - last, root = std::sqrt(sum * sum / 4 + before),
                 truth = std::abs(sum) / 2 + root;
    Found(sentence("with the weights ", last, " of the last error and ", before,
                   " of the one before, what a step leaves of a deviation"),
          "", double(ask<Real>("deviation_left", Real(last), Real(before))))
        .mistake(-truth, "a root may be negative; its size is asked for")
        .mistake(root - std::abs(sum) / 2,
                 "that is one of the roots, and in the end the one of the larger size is left")
        .mistake(sum / 2 - root,
                 "that is one of the roots, and in the end the one of the larger size is left")
        .mistake(std::abs(sum) + 2 * root, "the solution of a quadratic equation is half of that")
        .mistake(last / 2 + std::sqrt(last * last / 4 + before),
                 "with the weight 1 the last error is corrected at once. What it leaves of itself "
                 "is 1 less its weight")
        .mistake((1 + last) / 2 + std::sqrt((1 + last) * (1 + last) / 4 + before),
                 "a larger error makes the step shorter: the weight of the last is subtracted")
        .mistake(std::abs(sum), "the error before is left out")
        .mistake(std::abs(sum) + before,
                 "what remains after one step; and after many, with two terms, a root decides")
        .not_a_number(
            "the root of a negative number. The error before makes the step *longer*, so its "
            "weight is added")
        .must_be(truth, 32 * unit_roundoff<Real> * std::max(truth, 1.0));
  }
}

EXERCISE_CHECK(
    "On a smooth stretch steps settle at 0.58 of the longest, and each leaves four fifths of a "
    "deviation") {
  for (const int power : {4, 7, 1}) {
    const std::string with = sentence("with the power ", power, ", ");
    Found(with + "where both errors are what is allowed, the factor", "", factor<Real>(1, 1, power))
        .mistake(1, "there is no reserve, so that any error that grows has its step rejected")
        .must_be(0.85, rounding<Real>);
    // A ratio's exponent times the power, from two ratios so near each other that no limit counts.
    const double k = power, ratio = 0.75, apart = std::log(1 / ratio);
    const double both = factor<Real>(ratio, ratio, power);
    const double last = k / apart * std::log(factor<Real>(ratio * ratio, ratio, power) / both),
                 before = k / apart * std::log(both / factor<Real>(ratio, ratio * ratio, power));
    const double within = 2 * k / apart * rounding<Real>;
    Found(with + "the weight of the last error", "", last)
        .mistake(-0.7, "a larger error must make the step shorter")
        .mistake(0.7 * k, "the ratio falls as h to this power, so take that root of it")
        .mistake(0.7 * k * k,
                 "the ratio falls as h to this power: take that root, and not that power")
        .mistake(1, "that goes to the longest step at once, and hunts at the limit of stability")
        .mistake(0.4, "that is the weight of the error before")
        .mistake(0.3, "that is the difference of both weights, as if both errors were the last")
        .mistake(0.35, "a square root of the ratio. It isn't a square here")
        .must_be(0.7, within);
    Found(with + "the weight of the error before", "", before)
        .mistake(0,
                 "it doesn't count. Where the error grows, a controller that sees one cannot know")
        .mistake(-0.4,
                 "a larger error before makes the next step *longer*: the last one is then smaller "
                 "than it was, and falls")
        .mistake(0.4 * k, "the ratio falls as h to this power, so take that root of it")
        .mistake(0.4 * k * k,
                 "the ratio falls as h to this power: take that root, and not that power")
        .mistake(0.7, "that is the weight of the last error")
        .must_be(0.4, within);

    // Where a step of length 1 may just be made.
    const auto settled = [&](double h) {
      double error_before = std::pow(h, k);
      for (int n = 0; n < 200; ++n) {
        const double error = std::pow(h, k);
        h *= factor<Real>(error, error_before, power);
        error_before = error;
      }
      return h;
    };
    // Each step rounds, and is put right by 0.7 - 0.4 of it.
    for (const double begin : {0.25, 0.875})
      Found(with + sentence("where a step of 1 s may just be made, after 200 steps from ", begin,
                            " s on, the step"),
            "s", settled(begin))
          .must_be(std::pow(0.85, 1 / 0.3), rounding<Real> / 0.3);

    // A deviation that belongs to the root 0.8 alone, and then one of -0.5.
    const double level = std::pow(0.85, k / 0.3);
    for (const double root : {0.8, -0.5}) {
      const double deviation = 0.25, error = level * std::exp(root * deviation);
      const double next = factor<Real>(error, level * std::exp(deviation), power);
      Found(with + sentence("of a deviation that shrinks as the powers of ", root,
                            ", what a step leaves"),
            "", (std::log(error / level) + k * std::log(next)) / (root * deviation))
          .must_be(root, k * 2 * rounding<Real> / (std::abs(root) * deviation));
    }
  }
}

EXERCISE_CHECK("At the limit of stability the steps of a damped particle stay level") {
  const auto damper = [](Particled& particle, double) {
    particle.force = -1000 * particle.velocity;
  };
  for (const double begin : {0.5, 1.2}) {  // of the longest that is stable
    const double longest = 3.3066e-3;  // where a step of the pair keeps the size of exp(-1000 t)
    EmbeddedSteps<DormandPrince54, Particled, decltype(damper), double> steps(
        make_particle<double>(1, {0, 0, 0}, {1e-3, 0, 0}), damper, 0.0, {1e-3, 1e-3});
    double h = begin * longest, before = 1, least = 1, most = 0;
    int rejected = 0;
    for (int n = 0; n < 200; ++n) {
      if (n == 100) rejected = 0;
      if (n >= 100) least = std::min(least, h), most = std::max(most, h);
      const double ratio = std::sqrt(steps.attempt(h));
      const double next = factor<Real>(ratio, before, steps.power);
      require(
          std::isfinite(next) && next > 0,
          after(ratio, before, steps.power) + sentence(" is ", next, "; no step has that length"));
      h *= next;
      if (ratio <= 1) {
        steps.accept();
        before = ratio;
      } else {
        ++rejected;
      }
    }
    const std::string steps_of = sentence(
        "of the second hundred steps of a particle of 1 kg with a damper of 1000 N s/m, ", rejected,
        " are rejected, and they last from ", least * 1e3, " ms to ", most * 1e3, " ms. ");
    require(rejected < 100,
            steps_of + "None is accepted: after a step that was rejected the next must be shorter");
    require(most > 0.9 * longest, steps_of +
                                      "As far as the error goes they could be longer, up to the "
                                      "limit of stability at 3.3 ms");
    require(rejected == 0 && most < 1.01 * least,
            steps_of +
                "The controller hunts: it makes the step so long that it is unstable, and too "
                "short in turn. It must see that the error *grows*, from the one before");
    require(most < 1.1 * longest, steps_of + "From 3.3 ms on a step is unstable");
  }
}

EXERCISE_CHECK(
    "No step grows to more than six times its length, and a rejected one is made shorter by its "
    "own error alone") {
  const auto look = [](double ratio, double before, int power) {
    return Found<double>(after(ratio, before, power), "", factor<Real>(ratio, before, power));
  };
  const auto by_both = [](double ratio, double before, double k) {
    return 0.85 * std::pow(ratio, -0.7 / k) * std::pow(before, 0.4 / k);
  };
  const auto by_one = [](double ratio, double k) { return 0.85 * std::pow(ratio, -1 / k); };
  const double infinite = std::numeric_limits<double>::infinity(), none = std::nan("");

  look(1e-6, 1e-2, 1)
      .mistake(by_both(1e-6, 1e-2, 1), "no step is to become more than six times as long")
      .must_be(6, rounding<Real>);
  look(1, 0.5, 4)
      .mistake(0.85, "a ratio of 1 is just what is allowed, so that step was accepted")
      .must_be(by_both(1, 0.5, 4), rounding<Real>);
  look(1, 1e-6, 1)
      .mistake(by_both(1, 1e-6, 1), "it was accepted, so a fifth of it is the least")
      .mistake(0.1, "a tenth is the least after a step that was *rejected*; this one was not")
      .must_be(0.2, rounding<Real>);

  for (const double before : {0.5, 0.001}) {
    for (const double ratio : {3.0, 1.125})
      look(ratio, before, 4)
          .mistake(by_both(ratio, before, 4),
                   "with more than 1 a step was rejected, and then the error before says nothing: "
                   "take the whole root of its own ratio")
          .mistake(by_one(ratio, 4) / 0.85, "the reserve is missing, and the step may fail again")
          .mistake(0.85, "1/power is a division of whole numbers, and 0")
          .mistake(0.85 * std::pow(ratio, -0.7 / 4),
                   "after a rejected step its own error weighs 1, not 0.7")
          .must_be(by_one(ratio, 4), rounding<Real>);
    look(1e6, before, 4)
        .mistake(by_one(1e6, 4), "no step is to become shorter than a tenth")
        .mistake(0.2, "a fifth is the least after a step that was *accepted*; this one was not")
        .must_be(0.1, rounding<Real>);
  }
  look(infinite, 0.5, 4)
      .mistake(0, "no step is to become shorter than a tenth")
      .must_be(0.1, rounding<Real>);
  look(none, 0.5, 4)
      .not_a_number(
          "where the error is NaN the step was rejected, and must become a tenth. Comparisons with "
          "NaN are false")
      .must_be(0.1, rounding<Real>);

  look(0.5, 0, 8)
      .mistake(0.2, "the ratio before is 0. It counts as 1e-9 at least, as the last one does")
      .must_be(by_both(0.5, 1e-9, 8), rounding<Real>);
  look(0, 0.5, 8)
      .mistake(6, "the last ratio is 0. It counts as 1e-9 at least")
      .must_be(by_both(1e-9, 0.5, 8), rounding<Real>);
  look(0, 0, 4).must_be(by_both(1e-9, 1e-9, 4), rounding<Real>);
}
