#include <array>
#include <exercise/judge.hpp>
#include <tumble/splitting.hpp>

using namespace tumble;
using namespace tumble::exercise;

namespace {

const Precondition axes[] = {{"growth_rate", 1, 0, 2}, {"wobble_rate", 1, 0, 2}};

/// Each of the six orders of three moments, so that no axis is special.
const std::array<std::array<int, 3>, 6> orders = {
    {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};

template <class Real>
Vec3<Real> moments_in(const std::array<int, 3>& order,
                      const std::array<int, 3>& ascending = {1, 2, 4}) {
  Vec3<Real> moments;
  for (int n = 0; n < 3; ++n) moments[n] = Real(ascending[std::size_t(order[std::size_t(n)])]);
  return moments;
}

template <class Real>
Real growth(const Vec3<Real>& moments, int axis, Real spin) {
  return ask<Real>("growth_rate", moments, axis, spin);
}

template <class Real>
Real wobble(const Vec3<Real>& moments, int axis, Real spin) {
  return ask<Real>("wobble_rate", moments, axis, spin);
}

template <class Real>
constexpr double roundings = 16 * unit_roundoff<Real>;

/// A book of 24 x 17 x 3 cm and 1 kg, the axes with the two closest inverse moments first. The last
/// has the smallest moment, the second the middle one.
Vec3d book() {
  const double a = 0.0576, b = 0.0289, c = 0.0009;  // squares of the edges
  return Vec3d(a + b, a + c, b + c) / 12;
}

/// The book's angular velocity after `time` seconds in small steps.
Vec3d tumbled(const Vec3d& start, double time) {
  Topd top;
  top.inverse_moments = book().cwiseInverse();
  set_angular_velocity_body(top, start);
  const int steps = 4096;
  for (int n = 0; n < steps; ++n) turn_by_splitting(top, time / steps);
  return angular_velocity_body(top);
}

const std::string not_a_root =
    "a negative number has no real root. Look at the sign before you take the root";

}  // namespace

EXERCISE_CHECK("A small wobble grows about the middle axis, and about no other") {
  const Real spin = Real(parameter("spin"));
  for (const auto& order : orders) {
    const auto moments = moments_in<Real>(order);
    for (int axis = 0; axis < 3; ++axis) {
      const Real found = growth(moments, axis, spin), round = wobble(moments, axis, spin);
      const std::string where = "about the axis with " + shown(moments[axis]) +
                                " kg m² of the moments " + shown(moments) + " ";
      require(!std::isnan(found) && !std::isnan(round),
              where + "a rate is not a number: " + not_a_root);
      if (order[std::size_t(axis)] == 1) {
        require(found > 0, where + "the growth rate is " + shown(found) +
                               ". It is the middle one: there a wobble grows");
        require(round == 0, where + "the wobble rate is " + shown(round) +
                                ". It grows there, and does not go round: 0");
      } else {
        require(found == 0, where + "the growth rate is " + shown(found) +
                                ". It is an outer one: there nothing grows. Is a sign lost?");
        require(round > 0, where + "the wobble rate is " + shown(round) +
                               ". It is an outer one: there a wobble goes round");
      }
    }
  }
  const Vec3<Real> coin(1, 1, 2);
  require(growth(coin, 0, spin) == 0 && wobble(coin, 0, spin) == 0,
          "about a diameter of a coin, with moments 1, 1 and 2, a wobble neither grows nor goes "
          "round: both rates are 0");
}

EXERCISE_CHECK("It grows at the rate that Euler's equations give") {
  const Real spin = Real(parameter("spin"));
  for (const auto& order : orders) {
    const auto moments = moments_in<Real>(order);
    const int axis = int(std::find(order.begin(), order.end(), 1) - order.begin());
    // Moments 1, 2, 4: (4 - 2)(2 - 1) / (1 · 4) = 1/2.
    const Real truth = spin * std::sqrt(Real(0.5));
    Found("the growth rate about the middle of the moments 1, 2 and 4 kg m², at " + shown(spin) +
              " rad/s,",
          "1/s", growth(moments, axis, spin))
        .mistake(spin * spin / 2, "that is its square")
        .mistake(std::sqrt(Real(0.5)), "the spin is missing. A faster spin flips faster")
        .mistake(spin * std::sqrt(Real(2)), "the moments in the denominator are missing")
        .mistake(
            spin * std::sqrt(Real(2) / 2),
            "the moment of the spin's own axis is in the denominator. The other two belong there")
        .mistake(
            spin * std::sqrt(Real(2) / 8),
            "the moment of the spin's own axis is in the denominator. The other two belong there")
        .mistake(spin / 2, "the root goes over the whole fraction")
        .must_be(truth, truth * roundings<Real>);
    // And of 2, 3, 6: (6 - 3)(3 - 2) / (2 · 6) = 1/4.
    const auto others = moments_in<Real>(order, {2, 3, 6});
    Found("the growth rate about the middle of the moments 2, 3 and 6 kg m²", "1/s",
          growth(others, axis, spin))
        .mistake(truth, "it is that of the moments 1, 2 and 4. Where do the moments come in?")
        .must_be(spin / 2, spin * roundings<Real>);
    Found("the growth rate of 1, 2 and 4 kg m² for the spin the other way round", "1/s",
          growth<Real>(moments, axis, -spin))
        .mistake(-truth, "a rate of growth is positive, whichever way the body spins")
        .must_be(truth, truth * roundings<Real>);
  }
}

EXERCISE_CHECK("A tumbling book, step by step, grows as predicted") {
  const double spin = parameter("spin");
  const Vec3d moments = book();
  const Real foretold = growth<Real>(moments.cast<Real>(), 1, Real(spin));
  require(foretold > 0, "the growth rate about the book's middle axis is " + shown(foretold));
  // The start that only grows: ω_i and ω_j in the ratio that Euler's first equation asks for.
  const int i = 2, j = 0, k = 1;
  const double square =
      (moments[j] - moments[k]) * (moments[k] - moments[i]) / (moments[i] * moments[j]);
  const double rate = spin * std::sqrt(square), tiny = 1e-5 * spin, time = 3 / rate;
  Vec3d start = Vec3d::Zero();
  start[k] = spin;
  start[i] = tiny;
  start[j] = tiny * moments[i] * rate / ((moments[j] - moments[k]) * spin);
  const double grown = tumbled(start, time)[i] / tiny;
  // What is left out is of the size of the wobble's square, (1e-5 e³)², and of the step's,
  // (3/4096)².
  const double truth = std::log(grown) / time;
  Found("the growth rate predicted for the book, which tumbled for " + shown(time) + " s,", "1/s",
        foretold)
      .must_be(Real(truth), truth * (1e-5 + roundings<Real>));
}

EXERCISE_CHECK("About the outer axes it wobbles as predicted") {
  const double spin = parameter("spin");
  const Vec3d moments = book();
  for (const int k : {0, 2}) {
    const Real foretold = wobble<Real>(moments.cast<Real>(), k, Real(spin));
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    const double truth = spin * std::sqrt((moments[k] - moments[i]) * (moments[k] - moments[j]) /
                                          (moments[i] * moments[j]));
    Found("the wobble rate about the book's axis with " + shown(moments[k]) + " kg m²", "rad/s",
          foretold)
        .mistake(
            Real(spin * std::sqrt(std::abs((moments[k] - moments[i]) * (moments[k] - moments[j])) /
                                  (moments[i] * moments[k]))),
            "the moment of the spin's own axis is in the denominator. The other two belong there")
        .mistake(Real(truth * truth), "that is its square")
        .mistake(Real(truth / (2 * std::numbers::pi)),
                 "that is the number of wobbles in a second. The rate is in rad/s")
        .must_be(Real(truth), truth * 8 * roundings<Real>);
    Found("the wobble rate for the spin the other way round", "rad/s",
          wobble<Real>(moments.cast<Real>(), k, Real(-spin)))
        .mistake(Real(-truth), "a rate is positive, whichever way the body spins")
        .must_be(Real(truth), truth * 8 * roundings<Real>);
    // After a whole wobble it is where it was, after half of one on the other side.
    const double tiny = 1e-5 * spin;
    Vec3d start = Vec3d::Zero();
    start[k] = spin;
    start[i] = tiny;
    for (const int halves : {1, 2}) {
      const double after = tumbled(start, halves * std::numbers::pi / truth)[i] / tiny;
      Found(halves == 1 ? "after half a period the wobble, as a part of the first,"
                        : "after a whole period the wobble, as a part of the first,",
            "", Real(after))
          .must_be(halves == 1 ? -1 : 1, 1e-5);
    }
  }
}
