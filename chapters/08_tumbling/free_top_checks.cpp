#include <support/body_bounds.hpp>
#include <support/checks.hpp>
#include <support/rules.hpp>

using namespace tumble;
using namespace tumble::support;
using exact::FreeTop;

namespace {

using Exact = long double;

/// The second method: Runge and Kutta's fourth-order rule on Euler's equations and q' = ½ q ω. It
/// knows nothing of elliptic functions.
Top<Exact> stepped_by_runge_kutta(Top<Exact> top, Exact time, int steps) {
  struct Rate {
    Vec3<Exact> angular_momentum;
    Quaternion<Exact> q;
  };
  const Exact h = time / steps;
  const auto rate = [](const Top<Exact>& at) -> Rate {
    const Vec3<Exact> half = angular_velocity_body(at) / 2;
    return {gyroscopic_torque(at), at.orientation * pure(half)};
  };
  const auto moved = [](Top<Exact> at, Exact by, const Rate& r) {
    at.angular_momentum_body += by * r.angular_momentum;
    at.orientation = at.orientation + by * r.q;
    return at;
  };
  for (int n = 0; n < steps; ++n) {
    const Rate first = rate(top), second = rate(moved(top, h / 2, first)),
               third = rate(moved(top, h / 2, second)), fourth = rate(moved(top, h, third));
    top = moved(moved(moved(moved(top, h / 6, first), h / 3, second), h / 3, third), h / 6, fourth);
  }
  top.orientation = normalized(top.orientation);
  return top;
}

Top<Exact> top_with(const Vec3<Exact>& moments, const Vec3<Exact>& spin) {
  Top<Exact> top;
  top.orientation = normalized(Quaternion<Exact>{1, {2, -3, 4}});
  top.inverse_moments = moments.cwiseInverse();
  set_angular_velocity_body(top, spin);
  return top;
}

Vec3<Exact> angular_velocity_body_at(const FreeTop<Exact>& exact, Exact time) {
  return angular_velocity_body(exact.at(time));
}

/// What the fourth-order rule leaves: (ω h)⁴ ω t for the fastest rate in play.
Exact runge_kutta_bound(Exact rate, Exact time, int steps) {
  return std::pow(rate * time / steps, 4.0L) * rate * time;
}

}  // namespace

TEST_CASE("The exact free top agrees with a Runge-Kutta run, whatever the signs and the axes") {
  const std::array<std::array<int, 3>, 6> orders = {
      {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};
  const Vec3<Exact> moments(1, 2, 3);
  const Exact time = 3;
  const int steps = 1000;
  for (const auto& spin : {Vec3<Exact>(1, 2, 0.5L), Vec3<Exact>(0.2L, 0.1L, 3)})
    for (const auto& [a, b, c] : orders)
      for (int signs = 0; signs < 8; ++signs) {
        const Vec3<Exact> sign((signs & 1) != 0 ? -1 : 1, (signs & 2) != 0 ? -1 : 1,
                               (signs & 4) != 0 ? -1 : 1);
        const Top<Exact> start =
            top_with({moments[a], moments[b], moments[c]},
                     Vec3<Exact>(spin[a], spin[b], spin[c]).cwiseProduct(sign));
        const FreeTop exact(start);
        const Top<Exact> stepped = stepped_by_runge_kutta(start, time, steps);
        const Exact bound = runge_kutta_bound(3.1L, time, steps);
        CHECK((angular_velocity_body_at(exact, time) - angular_velocity_body(stepped)).norm() <=
              3.1L * bound);
        CHECK(angle_between(exact.at(time).orientation, stepped.orientation) <= bound);
      }
}

TEST_CASE("The exact free top agrees with a Runge-Kutta run on the problems A to D") {
  for (const TumblingProblem& problem : tumbling_problems) {
    CAPTURE(problem.letter);
    const Top<Exact> start = top_of<Exact>(problem);
    const Exact time = 0.5L, rate = 2 * angular_velocity_body(start).norm();
    const int steps = 20'000;
    const FreeTop exact(start);
    const Top<Exact> stepped = stepped_by_runge_kutta(start, time, steps);
    const Exact bound = runge_kutta_bound(rate, time, steps);
    CHECK((angular_velocity_body_at(exact, time) - angular_velocity_body(stepped)).norm() <=
          rate * bound);
    CHECK(angle_between(exact.at(time).orientation, stepped.orientation) <= bound);
    CHECK(bound < 1e-5L);
  }
}

TEST_CASE("The exact free top returns after the periods that tables give") {
  const Vec3<Exact> moments(1, 2, 3);
  const FreeTop nearly_steady(top_with(moments, {0.01L, 1, 0})),
      ordinary(top_with(moments, {1, 2, 0.5L}));
  CHECK(std::abs(nearly_steady.period() - 41.5092195293L) <= 0.5e-10L);
  CHECK(std::abs(ordinary.period() - 9.011153382704L) <= 0.5e-12L);
  CHECK(std::abs(ordinary.parameter() - 0.95L) <= 1e-17L);
  // Forty roundings of the argument and of the amplitude.
  const Exact bound = 40 * 9 * unit_roundoff<Exact>;
  CHECK((angular_velocity_body_at(ordinary, ordinary.period()) - Vec3<Exact>(1, 2, 0.5L)).norm() <=
        bound);
  CHECK((angular_velocity_body_at(ordinary, ordinary.period() / 2) - Vec3<Exact>(1, -2, -0.5L))
            .norm() <= bound);
}

TEST_CASE(
    "A symmetric top's spin goes round its axis at (I3 - I1) w3 / I1, and the axis round L at L / "
    "I1") {
  const Exact first = 2, third = 3, w3 = 4, time = 1.7L;
  const Top<Exact> start = top_with({first, first, third}, {0.5L, 0, w3});
  const FreeTop exact(start);
  const Exact round = (third - first) * w3 / first * time;
  const Vec3<Exact> expected(0.5L * std::cos(round), 0.5L * std::sin(round), w3);
  const Exact bound = 1000 * unit_roundoff<Exact>;  // a few hundred operations on numbers up to 4
  CHECK((angular_velocity_body_at(exact, time) - expected).norm() <= bound);

  const Vec3<Exact> L = angular_momentum_world(start);
  const Vec3<Exact> turn = time * L / first;
  const Vec3<Exact> axis = rotate(start.orientation, Vec3<Exact>(0, 0, 1));
  CHECK((rotate(exact.at(time).orientation, Vec3<Exact>(0, 0, 1)) -
         rotate(quaternion_of_rotation_vector(turn), axis))
            .norm() <= bound);
}

TEST_CASE("Where L x w is zero the exact top turns steadily") {
  for (const auto& start : {top_with({2, 2, 2}, {1, 2, 3}), top_with({1, 2, 3}, {0, 5, 0})}) {
    const FreeTop exact(start);
    const Vec3<Exact> turn = 1.5L * angular_velocity_world(start);
    CHECK(same_bits(angular_velocity_body_at(exact, 1.5L), angular_velocity_body(start)));
    CHECK(angle_between(exact.at(1.5L).orientation,
                        quaternion_of_rotation_vector(turn) * start.orientation) <=
          100 * unit_roundoff<Exact>);
  }
}

TEST_CASE("The tip of L goes round axis 1 or axis 3 of the body, never across, and comes back") {
  std::mt19937_64 generator(86);
  for (int trial = 0; trial < 100; ++trial) {
    const Top<Exact> start = exactly(random_brick<double>(generator).top);
    const Vec3<Exact> moments = moments_of(start), &L = start.angular_momentum_body;
    std::array<int, 3> axis = {0, 1, 2};
    std::sort(axis.begin(), axis.end(), [&](int a, int b) { return moments[a] < moments[b]; });
    const auto square = L.squaredNorm(), middle = 2 * kinetic_energy(start) * moments[axis[1]];
    if (std::abs(middle / square - 1) < 1e-6L) continue;  // too near the border to call it
    const int around = middle > square ? axis[0] : axis[2];
    const FreeTop exact(start);
    const Exact period = exact.period();
    bool crossed = false;
    int flips = 0;
    for (int n = 0; n < 1000; ++n) {
      const auto now = angular_velocity_body_at(exact, period * n / 1000);
      const auto next = angular_velocity_body_at(exact, period * (n + 1) / 1000);
      crossed = crossed || (now[around] > 0) != (L[around] > 0);
      flips += (now[axis[1]] > 0) != (next[axis[1]] > 0) ? 1 : 0;
    }
    CHECK(!crossed);
    CHECK(flips == 2);
    const Vec3<Exact> begin = angular_velocity_body_at(exact, 0);
    // long double rounds at 5e-20; so near the border the functions magnify up to a millionfold.
    CHECK((angular_velocity_body_at(exact, period) - begin).norm() <= 1e-12L * begin.norm());
  }
}
