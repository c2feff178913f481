#include <exercise/judge.hpp>
#include <tumble/compositions.hpp>

using namespace tumble;
using namespace tumble::exercise;

namespace {

const Precondition pairs_of_steps[] = {
    {"weights", 0, 1, 9}, {"error_for_the_same_work", 0, 1, 9}, {"momentum_after", 3, 1, 9}};

std::string with(int pairs) {
  return "with " + counted(pairs, "pair") + ", ";
}

template <class Real>
std::vector<Real> weights(int pairs) {
  auto found = ask<std::vector<Real>>("weights", pairs);
  const auto count = static_cast<std::size_t>(2 * pairs + 1);
  require(found.size() == count,
          sentence(with(pairs), "there are ", found.size(), " weights; there must be ", count,
                   ", the middle one and so many on each side"));
  return found;
}

/// Weights are below 2 in size; each is rounded a few times, so that their sum is off by no more.
template <class Real>
double tolerance(int pairs) {
  return 2 * (2 * pairs + 1) * 8 * double(unit_roundoff<Real>);
}

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

template <class Real>
Vec3<Real> momentum_after(Real time_step, int steps, int pairs) {
  return ask<Vec3<Real>>("momentum_after", Vec3<Real>(start.cast<Real>()), time_step, steps, pairs);
}

/// Who turns the top by another rule has composed none: momentum_after must be what the student's
/// weights make of it. A step of the splitting turns four times and rotates L, below 2, with it, 40
/// roundings each.
template <class Real>
void require_composed(Real time_step, int steps, int pairs) {
  Top<Real> top;
  top.inverse_moments = {1, Real(1) / 2, Real(1) / 3};
  top.angular_momentum_body = start.cast<Real>();
  const auto parts = weights<Real>(pairs);
  for (int n = 0; n < steps; ++n)
    for (const Real part : parts) turn_by_splitting<Real>(top, part * time_step);
  Found(with(pairs) + "momentum_after", "kg m²/s", momentum_after(time_step, steps, pairs))
      .must_be(top.angular_momentum_body,
               2 * 4 * 40 * steps * double(parts.size()) * double(unit_roundoff<Real>));
}

}  // namespace

EXERCISE_CHECK("The steps add up to the whole and read the same backwards") {
  for (const int pairs : {1, 2, 3, 4, 8}) {
    const auto parts = weights<Real>(pairs);
    double sum = 0;
    for (const Real part : parts) sum += double(part);
    Found(with(pairs) + "the weights' sum", "", sum)
        .mistake(0, "after such a step no time has passed. The parts make up 1")
        .must_be(1, tolerance<Real>(pairs));
    for (std::size_t i = 0; i < parts.size(); ++i)
      require(parts[i] == parts[parts.size() - 1 - i],
              sentence(with(pairs), "weight ", i + 1, " is ", parts[i],
                       ", and as many from the end stands ", parts[parts.size() - 1 - i],
                       ". The backward step belongs in the middle: else the rule is not symmetric "
                       "in time, and has errors of even powers too"));
  }
}

EXERCISE_CHECK("Their cubes add up to zero, for every number of pairs") {
  for (const int pairs : {1, 2, 3, 4, 8}) {
    const auto parts = weights<Real>(pairs);
    const double m2 = 2 * pairs;
    double cubes = 0, sum = 0;
    for (const Real part : parts) {
      cubes += std::pow(double(part), 3);
      sum += double(part);
    }
    require(
        std::abs(sum - 1) < 0.5,
        with(pairs) + "the weights sum to " + shown(sum) +
            ". Cubes of no steps at all, and of a step back for each ahead, add up to zero too");
    const auto cubes_with = [&](double outer) {
      return m2 * std::pow(outer, 3) + std::pow(1 - m2 * outer, 3);
    };
    Found(with(pairs) + "the sum of the weights' cubes", "", cubes)
        .mistake(cubes_with(1 / (m2 + std::cbrt(m2))),
                 "all weights lead forward, and then no cubes cancel. The root has the other sign: "
                 "1/(2m - ∛(2m))")
        .mistake(cubes_with(1 / (2 - std::cbrt(2.0))),
                 "the weights are those of one pair. There are 2m outer ones, in the count and "
                 "below the "
                 "root")
        .mistake(
            cubes_with(1 / (m2 - std::cbrt(2.0))),
            "the root is that of one pair. There are 2m outer steps: take the third root of 2m")
        .mistake(cubes_with(1 / (m2 - std::sqrt(m2))),
                 "that is a square root; cubes want the third")
        .mistake(cubes_with(1 / (m2 + 1)),
                 "all steps are equal. Then it is the splitting with a shorter step")
        .must_be(0, 3 * 4 * tolerance<Real>(pairs));
  }
}

EXERCISE_CHECK("Two pairs are Suzuki's row of the chapter, and four need no root") {
  const auto parts = weights<Real>(2);
  for (std::size_t i = 0; i < parts.size(); ++i)
    Found(sentence("with two pairs, Suzuki's row, weight ", i + 1), "", double(parts[i]))
        .must_be(double(Suzuki::row.drifts[i]), 8 * unit_roundoff<Real>);
  const auto simple = weights<Real>(4);
  Found("with four pairs, where the third root of 2m is 2, an outer weight", "", double(simple[0]))
      .must_be(1.0 / 6, 4 * unit_roundoff<Real>);
  Found("with four pairs, where the third root of 2m is 2, the middle weight", "",
        double(simple[4]))
      .must_be(-1.0 / 3, 16 * unit_roundoff<Real>);
}

EXERCISE_CHECK("A tumbling top is turned to fourth order") {
  const double time = 4;
  static const Vec3d where = truth(time);
  for (const int pairs : {1, 2, 4}) {
    const auto error = [&](int steps) {
      const auto found = momentum_after(Real(time / steps), steps, pairs);
      return (found.template cast<double>() - where).norm();
    };
    const int steps = pairs == 1 ? 8 : 4;  // so long that rounding does not count
    const double coarse = error(steps), fine = error(2 * steps);
    const std::string runs = sentence(with(pairs), "the error is ", coarse, " kg m²/s in ", steps,
                                      " steps and ", fine, " in twice as many. ");
    require(fine < 0.25,
            runs +
                "The top is not where it should be. Is each step of the splitting made with "
                "its weight times the time step?");
    require(coarse / fine > 6, runs + "Half the step divides it by " + shown(coarse / fine) +
                                   ", as a rule of second order does. Do the weights reach the "
                                   "steps, with cubes that cancel?");
    // The sixth order makes a third more or less of it at such steps.
    require(coarse / fine > 10 && coarse / fine < 32, runs + "Half the step divides it by " +
                                                          shown(coarse / fine) +
                                                          "; a rule of fourth order, by 16");
    require_composed(Real(time / steps), steps, pairs);
  }
}

EXERCISE_CHECK("For the same work two pairs err less than one, and four less than two") {
  for (const int pairs : {1, 2, 4, 8}) {
    const double m2 = 2 * pairs, n = m2 + 1;
    const double outer = 1 / (m2 - std::cbrt(m2)), middle = 1 - m2 * outer;
    const double sum = m2 * std::pow(outer, 5) + std::pow(middle, 5),
                 truth = std::abs(sum) * std::pow(n, 4);
    double sizes = 0;
    for (const double part : {outer, middle}) sizes += std::pow(std::abs(part), 5);
    Found(with(pairs) + "the error for the same work", "",
          double(ask<Real>("error_for_the_same_work", pairs)))
        .mistake(sum * std::pow(n, 4), "its size is asked for; the sum is negative")
        .mistake(std::abs(sum),
                 "that counts the error of a step and not its price. With n splittings in each, "
                 "the steps must be n times as long: n⁴")
        .mistake(std::abs(sum) * std::pow(n, 5),
                 "n⁵ is the error of one step. In a long motion there are n times fewer of them")
        .mistake(std::abs(sum) * n,
                 "n times as long a step has n⁴ times the error, by fourth order")
        .mistake(sizes * std::pow(n, 4), "each of the outer weights counts, all 2m of them")
        .must_be(truth, m2 * sizes * std::pow(n, 4) * 256 * unit_roundoff<Real>);
  }
}
