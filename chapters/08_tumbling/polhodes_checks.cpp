#include <support/checks.hpp>
#include <support/polhodes.hpp>
#include <support/rules.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

using Exact = long double;

/// Moments 1, 2 and 3, spun at 1 rad/s about the middle axis and `wobble` about the first.
Top<Exact> wobbling(Exact wobble) {
  Top<Exact> top{.inverse_moments = Vec3<Exact>(1, 0.5L, 1 / 3.0L)};
  set_angular_velocity_body(top, Vec3<Exact>(wobble, 1, 0));
  return top;
}

/// How fast it grows, κ: √(1 · 1/3).
const Exact kappa = std::sqrt(1 / 3.0L);

/// When ω₂ first passes zero, s: by Runge and Kutta's fourth-order rule on Euler's equations, and a
/// straight line between the two states on either side. It knows no elliptic integral.
Exact flip_of(Exact wobble, Exact h) {
  const auto rate = [](const Vec3<Exact>& w) -> Vec3<Exact> {
    return {-w[1] * w[2], w[2] * w[0], -w[0] * w[1] / 3};
  };
  Vec3<Exact> w(wobble, 1, 0);
  for (int n = 0;; ++n) {
    const Vec3<Exact> first = rate(w), second = rate(w + h / 2 * first),
                      third = rate(w + h / 2 * second), fourth = rate(w + h * third);
    const Vec3<Exact> next = w + h / 6 * (first + 2 * second + 2 * third + fourth);
    if (next[1] <= 0) return h * (n + w[1] / (w[1] - next[1]));
    w = next;
  }
}

}  // namespace

TEST_CASE("The exact time between flips is what a Runge-Kutta run needs, whatever the wobble") {
  const Exact h = 0.005L;
  for (Exact wobble = 1; wobble > 1e-9L; wobble /= 10) {
    CAPTURE(static_cast<double>(wobble));
    const Exact period = exact::FreeTop<Exact>(wobbling(wobble)).period();
    // A start with nothing about the third axis is half way between two flips. No rate exceeds
    // 2 rad/s. What the rule errs by shifts the flip by as much; and the straight line misses by
    // the curve's height, h² ω₂''/8, against the slope ω₃ω₁. Near the flip ω₂ is an odd function of
    // the time, so that ω₂'' there is under 2 ω₂'h, and the shift under h³.
    const Exact rate = 2, bound = std::pow(rate * h, 4.0L) * rate * period + h * h * h;
    CHECK(std::abs(flip_of(wobble, h) - period / 4) <= bound);
  }
}

TEST_CASE("Each tenth of the wobble adds (2 ln 10)/κ to the time between flips") {
  Exact before = 0;
  for (int tenths = 0; tenths <= 16; ++tenths) {
    const Exact wobble = std::pow(10.0L, -tenths);
    const Exact between = exact::FreeTop<Exact>(wobbling(wobble)).period() / 2;
    // 1 - m and the rate each differ from their limits by a few times the square of the wobble, the
    // larger of the two ten times as large. 100 roundings of each time.
    if (tenths > 1)
      CHECK(std::abs(between - before - 2 * std::log(10.0L) / kappa) <=
            between * (4 * 100 * wobble * wobble + 100 * unit_roundoff<Exact>));
    before = between;
  }
}

TEST_CASE("A polhode lies on its sphere and on its ellipsoid, and goes round its axis") {
  const Vec3d inverse(1, 0.5, 1 / 3.0);
  const auto energy = [&](const Vec3d& L) { return L.dot(inverse.cwiseProduct(L)); };
  // A sum of squares that are 1 or less, each rounded thrice or so, with two roots before.
  const double allowed = 16 * unit_roundoff<double>;
  for (const int around : {0, 2})
    for (const double part : {0.01, 0.5, 0.99}) {
      const double level = inverse[around] + part * (inverse[1] - inverse[around]);
      for (const Vec3d& L : polhode(inverse, level, around, 50)) {
        CHECK(std::abs(L.norm() - 1) <= allowed);
        CHECK(std::abs(energy(L) - level) <= allowed);
        CHECK(L[around] > 0);
      }
    }
  for (const double sign : {1.0, -1.0})
    for (const Vec3d& L : separatrix(inverse, sign, 50)) {
      CHECK(std::abs(L.norm() - 1) <= allowed);
      CHECK(std::abs(energy(L) - inverse[1]) <= allowed);
    }
}

TEST_CASE("The exact motion runs along the polhode through its start, and all the way round") {
  for (const Exact wobble : {0.05L, 0.3L, 2.0L}) {
    const Top<Exact> start = wobbling(wobble);
    const exact::FreeTop<Exact> exact(start);
    const Exact size = start.angular_momentum_body.norm();
    const double level = static_cast<double>(2 * kinetic_energy(start) / (size * size));
    const auto loop = polhode({1, 0.5, 1 / 3.0}, level, 0, 2000);
    // The nearest of the loop's points is half a portion away at most, 2 pi/2000/2 of an ellipse
    // whose half axes, and whose slope on the sphere, are under 2.
    std::vector<bool> visited(16);
    for (int n = 0; n < 400; ++n) {
      const Vec3<Exact> now = exact.at(exact.period() * n / 400).angular_momentum_body / size;
      double nearest = 2;
      std::size_t where = 0;
      for (std::size_t k = 0; k < loop.size(); ++k) {
        const double apart = (loop[k] - now.cast<double>()).norm();
        if (apart < nearest) where = k;
        nearest = std::min(nearest, apart);
      }
      CHECK(nearest <= 2 * 2 * 3.15 / 2000);
      visited[where * 16 / loop.size()] = true;
    }
    CHECK(std::count(visited.begin(), visited.end(), true) == 16);
  }
}
