#include <support/second_method.hpp>
#include <tumble/exact/kepler.hpp>
#include <tumble/exact/oscillator.hpp>
#include <tumble/exact/projectile.hpp>

using namespace tumble;
using namespace tumble::support;
using namespace tumble::exact;

namespace {

/// What the roundings of KeplerOrbit make of the position, relative to it, within a radian or three
/// of mean motion. The semi-axis rounds 12 times (the distance 3, 1/r and v² 4, their difference
/// doubles that and more), and 1/a comes into the mean motion one and a half times: at 3 rad the
/// anomaly is off by 4.5 of them, and 1/(1 − e) times that at the perihelion. Newton's method ends
/// within 2 of the equation's own 10; sines and sums add 20.
template <class Real>
Real rounding_of_orbit(Real eccentricity) {
  return (Real(4.5) * spread<Real>(12) + spread<Real>(12) + spread<Real>(20)) / (1 - eccentricity);
}

using State = std::array<long double, 6>;

template <class Real>
State state_of(const Particle<Real>& p) {
  return {p.position.x(), p.position.y(), p.position.z(),
          p.velocity.x(), p.velocity.y(), p.velocity.z()};
}

/// A particle by x' = v, v' = acceleration(x, v).
template <class Acceleration>
State integrated_particle(const State& start, long double time, int steps,
                          const Acceleration& acceleration) {
  return integrated(start, time, steps, [&](const State& s, State& rate, long double) {
    const Vec3<long double> a =
        acceleration(Vec3<long double>(s[0], s[1], s[2]), Vec3<long double>(s[3], s[4], s[5]));
    rate = {s[3], s[4], s[5], a[0], a[1], a[2]};
  });
}

/// How far apart two positions and two velocities are, each relative to its size.
template <class Real>
std::array<long double, 2> apart(const Particle<Real>& mine, const State& truth) {
  const State state = state_of(mine);
  std::array<long double, 2> relative = {};
  for (std::size_t half = 0; half < 2; ++half) {
    long double off = 0, size = 0;
    for (std::size_t n = 3 * half; n < 3 * half + 3; ++n) {
      off += (state[n] - truth[n]) * (state[n] - truth[n]);
      size += truth[n] * truth[n];
    }
    relative[half] = std::sqrt(off / size);
  }
  return relative;
}

}  // namespace

TEST_CASE_TEMPLATE("The thrown body agrees with Fehlberg's rule, from no drag to much", Real,
                   double, long double) {
  const auto start = make_particle<Real>(2, {1, 2, 3}, {5, 20, -4});
  for (const Real drag : {0.0, 1e-18, 1e-9, 1e-4, 0.2, 0.5, 3.0, 10.0}) {
    CAPTURE(drag);
    const Projectile<Real> exact(start, {0, Real(-9.8L), 0}, drag);
    const Vec3<long double> gravity(0, Real(-9.8L), 0);
    const long double time = 2;
    const auto truth = integrated_particle(
        state_of(start), time, 1000, [&](const Vec3<long double>&, const Vec3<long double>& v) {
          return Vec3<long double>(gravity - drag * v);
        });
    // Sums of terms up to 40 m where the result is 10 m or more: what rounds counts four times. The
    // second growth rounds 6 times, its series falls fast; with t² 8, and 3 in product and sum.
    const auto [position, velocity] = apart(exact.at(2), truth);
    const long double allowed = 4 * (8 + 3) * unit_roundoff<Real> +
                                eighth_order_error(std::max(drag, Real(0.5)), time, 1000);
    CHECK(position <= allowed);
    CHECK(velocity <= allowed * 4);
  }
}

TEST_CASE("A thrown body ends at the terminal speed, and without drag in free fall to the bit") {
  const auto start = make_particle<double>(2, {0, 0, 0}, {8, 16, 0});
  const auto late = Projectile<double>(start, {0, -9.75, 0}, 0.5).at(200);
  CHECK(late.velocity.y() == -19.5);
  CHECK(std::abs(late.position.x() - 16) <= 16 * 4 * unit_roundoff<double>);
  const auto falling = Projectile<double>(start, {0, -9.75, 0}, 0).at(2);
  CHECK(same_bits(falling.position, Vec3d(16, 12.5, 0)));
  CHECK(same_bits(falling.velocity, Vec3d(8, -3.5, 0)));
}

TEST_CASE("The two growth functions keep their digits on either side of where they change form") {
  const auto keeps_its_digits = [](double x) {
    const long double precise = second_growth<long double>(x);
    return std::abs(second_growth(x) / precise - 1) <= 8 * unit_roundoff<double>;
  };
  // Where terms of the series are left out too early, it shows where the next one is largest.
  for (int n = -1000; n <= 1000; ++n) CHECK(keeps_its_digits(n / 1000.0));
  for (const double x : {-30.0, -1.01, -0.99, -0.1, -1e-9, 0.0, 1e-9, 0.5, 1.01, 4.0}) {
    CHECK(keeps_its_digits(x));
    CHECK(std::abs((1 + x * second_growth(x)) / relative_growth<long double>(x) - 1) <=
          8 * (1 + std::abs(x)) * unit_roundoff<double>);
  }
}

TEST_CASE_TEMPLATE("The oscillator agrees with Fehlberg's rule, swinging, creeping and in between",
                   Real, double, long double) {
  const Real w = 3;
  for (const Real damping : {0.0, 0.1, 2.9, 3 - 1e-9, 3.0, 3 + 1e-9, 3.1, 10.0, 40.0})
    for (const auto& start : {OscillatorState<Real>{1, 0}, {0, 2}, {1, -4}}) {
      CAPTURE(damping);
      const auto [x, v] = Oscillator<Real>(start, w, damping).at(1.5);
      using Pair = std::array<long double, 2>;
      const Pair truth = integrated(
          Pair{start.position, start.velocity}, 1.5L, 4000,
          [&](const Pair& s, Pair& rate, long double) {
            rate = {s[1], -2.0L * damping * s[1] - static_cast<long double>(w) * w * s[0]};
          });
      // Swinging, the angle is w t = 4.5 rad at most and rounds 3.5 times, the exponent γ t 1 time;
      // sine, decay and root have 2 each, and 4 come by products and sums. Creeping has fewer.
      const long double allowed = (3.5L * 4.5L + 4.5L + 6 + 4) * unit_roundoff<Real> +
                                  eighth_order_error(w + 2 * damping, 1.5L, 4000);
      const Real size = std::abs(start.position) + std::abs(start.velocity);
      CHECK(std::abs(x - truth[0]) <= allowed * size);
      CHECK(std::abs(v - truth[1]) <= allowed * w * size * (1 + damping / w));
    }
}

TEST_CASE("Near the critical damping the oscillator in double is the one in long double") {
  for (const double off : {-1e-3, -1e-8, -1e-15, 0.0, 1e-15, 1e-8, 1e-3}) {
    const double damping = 3 + off;
    const auto [x, v] = Oscillator<double>({1, -2}, 3, damping).at(0.7);
    const auto truth = Oscillator<long double>({1, -2}, 3, damping).at(0.7);
    // The exponent is γ t = 2.1 and rounds once for each; exponential, growth and the sum v + γ x
    // have 2 each, and 4 come by products and sums, of terms of 2 m. The velocity is 3/s times
    // that.
    const double allowed = 2 * (2.1 + 6 + 4) * unit_roundoff<double>;
    CHECK(std::abs(x - truth.position) <= allowed);
    CHECK(std::abs(v - truth.velocity) <= 3 * allowed);
  }
}

TEST_CASE("A heavily damped oscillator creeps home at w²/2γ without a number overflowing") {
  const auto [x, v] = Oscillator<double>({1, 0}, 1, 1e8).at(2e8);
  CHECK(std::abs(x - std::exp(-1.0)) <= 1e-15);
  CHECK(std::abs(v + x / 2e8) <= 1e-23);
  const auto coasting = Oscillator<double>({1, 3}, 0, 0).at(2);
  CHECK(coasting.position == 7);
  CHECK(coasting.velocity == 3);
}

TEST_CASE_TEMPLATE("The orbit agrees with Fehlberg's rule, for eccentricities from 0 to 0.99", Real,
                   double, long double) {
  for (const Real eccentricity : {0.0, 1e-9, 0.2, 0.6, 0.9, 0.99}) {
    CAPTURE(eccentricity);
    // From the aphelion, a = 1 m, with a period of 2 pi s: the rule can't step through a perihelion
    // of 0.99 in equal steps, so it goes up to close to it.
    const Real distance = 1 + eccentricity;
    const Real speed = std::sqrt((1 - eccentricity) / (1 + eccentricity));
    const auto start = make_particle<Real>(1, {distance * Real(0.6L), distance * Real(0.8L), 0},
                                           {-speed * Real(0.8L), speed * Real(0.6L), 0});
    const KeplerOrbit<Real> exact(start, 1);
    CHECK(std::abs(exact.eccentricity() - eccentricity) <= 8 * unit_roundoff<Real>);
    for (const Real time : {-2.0, 1.0, 2.8}) {
      const int steps = 8000;
      const auto truth = integrated_particle(
          state_of(start), time, steps, [](const Vec3<long double>& r, const Vec3<long double>&) {
            return Vec3<long double>(-r / std::pow(r.norm(), 3.0L));
          });
      const auto [position, velocity] = apart(exact.at(time), truth);
      // The rate grows as distance^(-3/2); at t = 2.8 the planet of e = 0.99 is at 0.46 m.
      const long double nearest = std::hypot(truth[0], truth[1]);
      const long double rate = 4 / std::pow(nearest, 1.5L);
      const long double allowed =
          rounding_of_orbit(eccentricity) + eighth_order_error(rate, std::abs(time), steps);
      CHECK(position <= allowed);
      CHECK(velocity <= allowed * 4);
    }
  }
}

TEST_CASE_TEMPLATE("The orbit agrees with Fehlberg's rule from anywhere on it, out or in", Real,
                   double, long double) {
  for (const Real outwards : {-0.6, -1e-6, 0.3, 0.9}) {
    const auto start =
        make_particle<Real>(1, {0.5, -1, 0.25}, {outwards * Real(0.5), -outwards, 0.5});
    const KeplerOrbit<Real> exact(start, 1);
    for (const Real time : {-1.3, 0.01, 2.0}) {
      const auto truth = integrated_particle(
          state_of(start), time, 8000, [](const Vec3<long double>& r, const Vec3<long double>&) {
            return Vec3<long double>(-r / std::pow(r.norm(), 3.0L));
          });
      const auto [position, velocity] = apart(exact.at(time), truth);
      // No nearer than 0.06 m, where the rate is 1/0.06^1.5 = 70/s, for a short while.
      const long double allowed =
          rounding_of_orbit(exact.eccentricity()) + eighth_order_error(20, std::abs(time), 8000);
      CHECK(position <= allowed);
      CHECK(velocity <= allowed * 4);
    }
    // Where it was a while ago, it comes from.
    const auto back = KeplerOrbit<Real>(exact.at(Real(-1.3)), 1).at(Real(1.3));
    CHECK((back.position - start.position).norm() <=
          2 * rounding_of_orbit(exact.eccentricity()) * start.position.norm());
  }
}

TEST_CASE_TEMPLATE("The orbit keeps its energy and angular momentum, and closes", Real, double,
                   long double) {
  for (const Real eccentricity : {0.0, 0.5, 0.99}) {
    const Real speed = std::sqrt((1 + eccentricity) / (1 - eccentricity));
    const auto start = make_particle<Real>(1, {1 - eccentricity, 0, 0}, {0, 0, speed});
    const KeplerOrbit<Real> exact(start, 1);
    const Real slack = rounding_of_orbit(eccentricity);
    CHECK(std::abs(exact.period() / 2 / exact::pi<Real> - 1) <= slack);
    for (int n = 0; n < 400; ++n) {
      const auto now = exact.at(Real(0.0317) * Real(n));
      const Real energy = now.velocity.squaredNorm() / 2 - 1 / now.position.norm();
      CHECK(std::abs(energy + Real(0.5)) <= slack / now.position.norm());
      CHECK(std::abs(now.position.cross(now.velocity).norm() -
                     start.position.cross(start.velocity).norm()) <= slack);
    }
    const auto round = exact.at(exact.period());
    // The perihelion passes at this speed, a rounding of the time too late.
    CHECK((round.position - start.position).norm() <= 20 * speed * slack);
  }
}

TEST_CASE("Under four times the attraction an orbit is run through twice as fast, to the bit") {
  const auto start = make_particle<double>(1, {0.5, -1, 0.25}, {0.15, -0.3, 0.5});
  auto quick = start;
  quick.velocity *= 2;
  const KeplerOrbit<double> slow_orbit(start, 1), quick_orbit(quick, 4);
  CHECK(quick_orbit.period() == slow_orbit.period() / 2);
  CHECK(quick_orbit.eccentricity() == slow_orbit.eccentricity());
  for (const double time : {-3.0, 0.7, 50.0}) {
    const auto here = slow_orbit.at(time), there = quick_orbit.at(time / 2);
    CHECK(same_bits(there.position, here.position));
    CHECK(same_bits(there.velocity, Vec3d(2 * here.velocity)));
  }
}

TEST_CASE_TEMPLATE("A comet on an orbit of eccentricity 0.9999 is where halving finds it", Real,
                   double, long double) {
  // From the perihelion, with a = 1 m and n = 1/s: the anomaly and the time begin at 0 there.
  const Real e = Real(0.9999L), speed = std::sqrt((1 + e) / (1 - e));
  const KeplerOrbit<Real> exact(make_particle<Real>(1, {1 - e, 0, 0}, {0, speed, 0}), 1);
  for (int n = 1; n < 300; ++n) {
    const Real time = Real(3.1) * Real(n) * Real(n) * Real(n) / Real(300 * 300 * 300);
    long double low = 0, high = 4;  // E - e sin E grows with E
    for (int halving = 0; halving < 70; ++halving) {
      const long double E = (low + high) / 2;
      (E - e * std::sin(E) > time ? high : low) = E;
    }
    const Vec3<long double> truth(std::cos(low) - e,
                                  std::sqrt((1.0L - e) * (1.0L + e)) * std::sin(low), 0);
    // The anomaly is off by that many roundings, and the comet by no more than twice as many m.
    CHECK((exact.at(time).position.template cast<long double>() - truth).norm() <=
          2 * rounding_of_orbit(e));
  }
}

TEST_CASE("An oscillator 64 times as slow does the same in 64 times the time, to the bit") {
  for (const double damping : {0.1, 3.0, 3.1, 10.0}) {
    const OscillatorState<double> start = {1, -4}, slow = {1, -4 / 64.0};
    const auto now = Oscillator<double>(start, 3, damping).at(1.5);
    const auto late = Oscillator<double>(slow, 3 / 64.0, damping / 64).at(64 * 1.5);
    CHECK(late.position == now.position);
    CHECK(64 * late.velocity == now.velocity);
  }
}

TEST_CASE(
    "At the perihelion an orbit runs 1/(1 - e) of its mean motion, seen from the star far more") {
  for (const double e : {0.0, 0.5, 0.8}) {
    const double speed = std::sqrt((1 + e) / (1 - e)), time = 1e-5;  // n = 1, a = 1
    const KeplerOrbit<double> orbit(make_particle<double>(1, {1 - e, 0, 0}, {0, speed, 0}), 1);
    const auto ahead = orbit.at(time), behind = orbit.at(-time);
    // On the circle around the ellipse, and as the star sees it.
    const double anomaly = (ahead.position.y() - behind.position.y()) / std::sqrt(1 - e * e);
    const double seen = std::atan2(ahead.position.y(), ahead.position.x()) -
                        std::atan2(behind.position.y(), behind.position.x());
    // The differences leave out t² times a rate squared, at most 15², and a rounding by t.
    CHECK(std::abs(anomaly / (2 * time) * (1 - e) - 1) <= 1e-7);
    const double expected = std::sqrt((1 + e) / ((1 - e) * (1 - e) * (1 - e)));
    CHECK(std::abs(seen / (2 * time) / expected - 1) <= 1e-7);
    if (e == 0.8) CHECK(std::abs(expected - 15) <= 1e-12);
  }
}

TEST_CASE("What has no exact solution here is refused with the reason") {
  const auto start = make_particle<double>(1, {1, 0, 0}, {0, 2, 0});
  CHECK(complaint_of([&] { KeplerOrbit<double>(start, 1); }) ==
        "velocity is (0, 2, 0) m/s; its size must be less than the escape velocity "
        "1.4142135623730951 m/s; open orbits have no solution here");
  // As fast as the escape velocity, to the bit: a parabola.
  const auto parabola = make_particle<double>(1, {2, 0, 0}, {0, 1, 0});
  CHECK(complaint_of([&] { KeplerOrbit<double>(parabola, 1); }) ==
        "velocity is (0, 1, 0) m/s; its size must be less than the escape velocity 1 m/s; open "
        "orbits have no solution here");
  CHECK(complaint_of([&] { KeplerOrbit<double>(start, 0); }) ==
        "attraction is 0 m^3/s^2; it must be greater than 0");
  CHECK(complaint_of([&] { KeplerOrbit<double>(start, INFINITY); }) ==
        "attraction is inf m^3/s^2; it must be finite");
  auto lost = start;
  lost.position.y() = INFINITY;
  CHECK(complaint_of([&] { KeplerOrbit<double>(lost, 1); }) ==
        "position is (1, inf, 0) m; every component must be finite");
  lost = start;
  lost.velocity.z() = NAN;
  CHECK(complaint_of([&] { KeplerOrbit<double>(lost, 1); }) ==
        "velocity is (0, 2, nan) m/s; every component must be finite");
  CHECK(complaint_of([&] {
          Projectile<double>(start, {0, -INFINITY, 0}, 1);
        }) == "gravity is (0, -inf, 0) m/s^2; every component must be finite");
  const auto falling = make_particle<double>(1, {1, 0, 0}, {-0.5, 0, 0});
  CHECK(complaint_of([&] { KeplerOrbit<double>(falling, 1); }) ==
        "position is (1, 0, 0) m; the velocity (-0.5, 0, 0) m/s must not point to the centre or "
        "away from it");
  CHECK(complaint_of([&] {
          Projectile<double>(start, {0, 0, 0}, -1);
        }) == "drag is -1 1/s; it must be 0 or more");
  CHECK(complaint_of([&] {
          Oscillator<double>({1, 0}, -1, 0);
        }) == "rate is -1 rad/s; it must be 0 or more");
  CHECK(complaint_of([&] {
          Oscillator<double>({1, 0}, 1, -0.5);
        }) == "damping is -0.5 1/s; it must be 0 or more");
  CHECK(complaint_of([&] {
          Oscillator<double>({1, 0}, 1, NAN);
        }) == "damping is nan 1/s; it must be finite");
}
