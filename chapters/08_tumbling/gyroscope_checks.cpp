#include <support/checks.hpp>
#include <support/toy_gyroscope.hpp>

using namespace tumble;
using namespace tumble::support;

namespace {

using Exact = long double;

/// The same gyroscope in long double, to judge one that was rounded.
template <class Real>
Gyroscope<Exact> widened(const Gyroscope<Real>& g) {
  return {g.across, g.along, g.distance, g.weight};
}

/// How slow a top is: M g l I₁/(I₃ω₃)², ¼ at the least spin with which it sleeps.
template <class Real>
Real slowness(const Gyroscope<Real>& g, Same<Real> spin) {
  const Real L3 = g.along * spin;
  return pull_of(g) * g.across / (L3 * L3);
}

}  // namespace

TEST_CASE_TEMPLATE("The weight's kick is level and perpendicular to the axis, so L3 and Lz stay",
                   Real, EVERY_PRECISION) {
  const auto gyroscope = toy_gyroscope<Real>();
  for (const Real tilt : {Real(0), Real(0.3), Real(1.5), Real(3)}) {
    Top<Real> top = set_spinning<Real>(gyroscope, tilt, 200, 5);
    add_weight(top, gyroscope);
    CHECK(top.torque.z() == 0);
    const Vec3<Real> before = top.angular_momentum_body;
    kick(top, Real(0.01));
    const Real pull = pull_of(gyroscope);
    // Two turns by a quaternion, of 20 roundings each, and the arm.
    CHECK(std::abs(top.torque.norm() - pull * std::sin(tilt)) <= 48 * unit_roundoff<Real> * pull);
    CHECK(std::abs(top.angular_momentum_body.z() - before.z()) <=
          Real(0.01) * 48 * unit_roundoff<Real> * pull + 2 * unit_roundoff<Real> * before.z());
  }
}

TEST_CASE_TEMPLATE("At both steady precessions the weight turns L as fast as the axis goes round",
                   Real, EVERY_PRECISION) {
  const auto gyroscope = toy_gyroscope<Real>();
  for (const Real tilt : {Real(0.3), Real(1), Real(2), Real(2.8)})
    for (const Real spin : {Real(160), Real(-200), Real(400)}) {
      const auto [slow, fast] = steady_precessions<Real>(gyroscope, std::cos(tilt), spin);
      CHECK(std::abs(slow) < std::abs(fast));
      for (const Real rate : {slow, fast}) {
        // dL/dt of a vector that goes round the vertical is Ω × L.
        Top<Real> top = set_spinning(gyroscope, tilt, spin, rate);
        add_weight(top, gyroscope);
        const Vec3<Real> L = angular_momentum_world(top);
        const Vec3<Real> turning = Vec3<Real>(0, 0, rate).cross(L);
        // L and the torque round 30 times each, the rate 12 times.
        CHECK(distance(turning, top.torque) <=
              72 * unit_roundoff<Real> * (std::abs(rate) * L.norm() + pull_of(gyroscope)));

        // And by elliptic functions: what is left of the torque, r, swings the axis with the
        // nutation's rate n, by r/(I₁ n²) to either side.
        const auto exact = exactly_spinning(exactly(top), widened(gyroscope));
        const Exact n = 2 * M_PIl / exact.nutation_period();
        const Exact left = 72 * unit_roundoff<Real> * std::abs(rate) * L.norm();
        CHECK(exact.highest() - exact.lowest() <= 2 * left / (gyroscope.across * n * n));
      }
    }
}

TEST_CASE_TEMPLATE(
    "A fast top goes round at M g l/(I3 w3), and the other way if spun the other way", Real,
    EVERY_PRECISION) {
  const auto gyroscope = toy_gyroscope<Real>();
  for (const Real cosine : {Real(-0.9), Real(0.2), Real(1)})
    for (const Real spin : {Real(240), Real(500), Real(2000), Real(1e5), Real(1e7)}) {
      const auto [slow, fast] = steady_precessions<Real>(gyroscope, cosine, spin);
      const Real rough = pull_of(gyroscope) / (gyroscope.along * spin),
                 x = slowness(gyroscope, spin) * cosine;
      // The root's series is 1 + x + 2 x² + 5 x³ + …, Catalan's numbers, which x < 1/16 keeps under
      // 1 + x + 4 x².
      CHECK(std::abs(x) < Real(1) / 16);
      CHECK(std::abs(slow / rough - 1 - x) <= 4 * x * x + 16 * unit_roundoff<Real>);
      const auto [back, fast_back] = steady_precessions<Real>(gyroscope, cosine, -spin);
      CHECK(back == -slow);
      CHECK(fast_back == -fast);
    }
}

TEST_CASE_TEMPLATE("Let go, a top dips as far as the elliptic solution says, and stops there", Real,
                   EVERY_PRECISION) {
  const auto gyroscope = toy_gyroscope<Real>();
  for (const Real tilt : {Real(0.4), Real(1), Real(1.6), Real(2.8)})
    for (const Real spin : {Real(0), Real(20), Real(-100), Real(200), Real(1000)}) {
      const Top<Real> start = set_spinning(gyroscope, tilt, spin);
      const auto exact = exactly_spinning(exactly(start), widened(gyroscope));
      const Real cosine = std::cos(tilt);
      const Exact ratio = spin / least_sleeping_spin(gyroscope), a = ratio * ratio,
                  root = std::hypot(a - cosine, std::sin(tilt));
      // 20 roundings of the formula, 8 of a and of the cosine that it starts from, and what they
      // do: the slopes of a − root are under 2 a/root + 2 together.
      CHECK(std::abs(lowest_cosine(gyroscope, cosine, spin) - exact.lowest()) <=
            (20 + 8 * (2 + 2 * a / root)) * unit_roundoff<Real>);
    }
}

TEST_CASE_TEMPLATE(
    "The lowest point loses no digits, neither near upright nor for the fastest spin", Real,
    EVERY_PRECISION) {
  const auto gyroscope = toy_gyroscope<Real>();
  const Real least = least_sleeping_spin(gyroscope);
  for (const int upright : {1, 4, 10, 20})
    for (const Real ratio : {Real(0.5), Real(1), Real(2), Real(100), Real(1e6)}) {
      const Real cosine = 1 - std::ldexp(Real(1.3), -upright), spin = ratio * least;
      // From the same rounded numbers in long double. The 20 roundings of the formula, and 8 of a,
      // on which the point depends by 1 − (a − cos θ)/root, which is under 2.
      CHECK(std::abs(lowest_cosine(gyroscope, cosine, spin) -
                     lowest_cosine(widened(gyroscope), Exact(cosine), Exact(spin))) <=
            (20 + 8 * 2 * std::min(ratio * ratio, Real(1))) * unit_roundoff<Real>);
    }
  // So fast that the square of a leaves the range: it doesn't sink at all.
  const Real fastest = least * std::sqrt(std::sqrt(std::numeric_limits<Real>::max())) * 16;
  CHECK(std::abs(lowest_cosine(gyroscope, Real(0.5), fastest) - Real(0.5)) <=
        4 * unit_roundoff<Real>);
}

TEST_CASE("Let go, the axis comes to rest at its highest again and again: a cusp") {
  const auto gyroscope = toy_gyroscope<Exact>();
  const Top<Exact> start = set_spinning<Exact>(gyroscope, 1, 200);
  const auto exact = exactly_spinning(start, gyroscope);
  for (int n = 1; n <= 5; ++n) {
    const Exact time = n * exact.nutation_period();
    const Top<Exact> now = exact.at(time);
    // The solution claims some tens of roundings for each radian; 200 rad/s is the fastest rate.
    const Exact rounding = 100 * (1 + 200 * time) * unit_roundoff<Exact>;
    CHECK(std::abs(axis_of(now).z() - std::cos(Exact(1))) <= rounding);
    CHECK(now.angular_momentum_body.head<2>().norm() <=
          rounding * start.angular_momentum_body.norm());
    const Top<Exact> lowest = exact.at(time - exact.nutation_period() / 2);
    CHECK(lowest.angular_momentum_body.head<2>().norm() >
          0.1L * start.angular_momentum_body.norm());
  }
}

TEST_CASE(
    "Twice the spin: a fast top goes round, nods and dips four times nearer, in proportion, to the "
    "simple formulas") {
  const auto gyroscope = toy_gyroscope<Exact>();
  const Exact tilt = 1;
  const auto off = [&](Exact spin) {
    const auto exact = exactly_spinning(set_spinning(gyroscope, tilt, spin), gyroscope);
    const Exact nodding = 2 * M_PIl / exact.nutation_period(),
                dip = std::acos(exact.lowest()) - std::acos(exact.highest());
    const Exact slow = steady_precessions(gyroscope, std::cos(tilt), spin).first;
    return std::array{slow * gyroscope.along * spin / pull_of(gyroscope) - 1,
                      nodding * gyroscope.across / (gyroscope.along * spin) - 1,
                      dip / (2 * slowness(gyroscope, spin) * std::sin(tilt)) - 1};
  };
  const std::array once = off(1000), twice = off(2000);
  // A fourth, and the next term is a fourth of a fourth with a factor of the same size: slowness.
  const Exact next = 20 * slowness(gyroscope, 1000);
  for (std::size_t k = 0; k < 3; ++k) CHECK(std::abs(once[k] / twice[k] - 4) <= 4 * next);
}

TEST_CASE_TEMPLATE(
    "Nudged, the upright top stands above its least spin, and below it falls as far as the formula "
    "says",
    Real, EVERY_PRECISION) {
  const auto gyroscope = toy_gyroscope<Real>();
  const auto wide = widened(gyroscope);
  const Real nudge = Real(1e-3);
  const auto nudged = [&](Real ratio) {
    Top<Real> top = set_spinning(gyroscope, 0, ratio * least_sleeping_spin(gyroscope));
    top.angular_momentum_body.x() = gyroscope.across * nudge;
    return exactly_spinning(exactly(top), wide);
  };
  for (const Real ratio : {Real(1.02), Real(1.1), Real(2), Real(-1.5)}) {
    // Two turns that begin as opposites, at the two steady rates: their sum is never longer than
    // the nudge by half the difference of the rates. 2 √((I₃ω₃)² − 4 M g l I₁)/2 I₁.
    const Exact L3 = wide.along * Exact(ratio) * least_sleeping_spin(wide);
    const Exact apart = std::sqrt(L3 * L3 - 4 * pull_of(wide) * wide.across) / wide.across;
    const Exact largest = 2 * nudge / apart;
    // That is for small tilts: it holds to their square, by how near the spin is to the least.
    const Exact bend = largest * largest / (std::abs(Exact(ratio)) - 1);
    CHECK(std::acos(nudged(ratio).lowest()) <=
          largest * (1 + bend) * (1 + 1000 * unit_roundoff<Real>));
  }
  for (const Real ratio : {Real(0.98), Real(0.7), Real(0.2)}) {
    const Exact cosine = 2 * Exact(ratio) * ratio - 1, beta = 2 * pull_of(wide) / wide.across;
    // The nudge's energy shifts the end by ε² (1 + z)/(β (1 − z)), and 16 roundings of the spin.
    const Exact shift = nudge * nudge * (1 + cosine) / (beta * (1 - cosine));
    CHECK(std::abs(nudged(ratio).lowest() - cosine) <= 2 * shift + 32 * unit_roundoff<Real>);
  }
}

TEST_CASE(
    "However a sleeping top is nudged, its energy bounds its tilt for ever, at the least spin "
    "itself too") {
  const auto gyroscope = toy_gyroscope<Exact>();
  const Exact I = gyroscope.across, pull = pull_of(gyroscope);
  for (const Exact ratio : {1.0L, 1.02L, -1.1L, 2.0L})
    for (const Exact tilt : {0.0L, 0.01L, 0.7L})
      for (const Exact nudge : {1e-3L, 1.0L, -20.0L})  // rad/s
        for (const int axis : {0, 1}) {
          const Exact spin = ratio * least_sleeping_spin(gyroscope), L3 = gyroscope.along * spin;
          Top<Exact> top = set_spinning(gyroscope, tilt, spin);
          top.angular_momentum_body[axis] += I * nudge;
          const Exact Lz = angular_momentum_world(top).z(),
                      energy = kinetic_energy(top) + pull * axis_of(top).z(),
                      asleep = L3 * spin / 2 + pull;
          const Exact V = energy - asleep - L3 / (2 * I) * (Lz - L3);
          // The larger root x = 1 − cos θ of L₃²/8I₁ x² + (L₃²/4I₁ − M g l) x = V.
          const Exact flat = L3 * L3 / (8 * I), steep = std::max(2 * flat - pull, Exact(0));
          const Exact bound = (std::sqrt(steep * steep + 4 * flat * V) - steep) / (2 * flat);
          // V and the exact solution are sums of some tens of terms of the size of L₃ ω, that of
          // `asleep`; at the least spin x is the root of what is left.
          const Exact rounding = 100 * unit_roundoff<Exact> * asleep / flat,
                      allowed = steep > 0 ? rounding * flat / steep : std::sqrt(rounding);
          const Exact fallen = 1 - exactly_spinning(top, gyroscope).lowest();
          CHECK(fallen <= bound + allowed);
          // An upright top takes it all, but for the square of a small tilt.
          if (tilt == 0 && nudge < 0.01L) CHECK(fallen >= bound * (1 - 2 * bound) - allowed);
        }
}

TEST_CASE("Tilting an upright top takes energy from its least spin on, and yields some below it") {
  const auto gyroscope = toy_gyroscope<Exact>();
  const Exact I = gyroscope.across, pull = pull_of(gyroscope);
  for (const Exact ratio : {2.0L, 1.001L, 1.0L, 0.999L, 0.5L, 0.0L})
    for (const Exact tilt : {0.01L, 0.001L}) {
      const Exact spin = ratio * least_sleeping_spin(gyroscope), L3 = gyroscope.along * spin;
      // With L₃ and L_z of the upright one, and no more energy than that takes.
      const Top<Exact> top = set_spinning(gyroscope, tilt, spin, L3 / (I * (1 + std::cos(tilt))));
      CHECK(std::abs(angular_momentum_world(top).z() - L3) <= 40 * unit_roundoff<Exact> * L3);
      const Exact upright = L3 * spin / 2 + pull,
                  taken = kinetic_energy(top) + pull * axis_of(top).z() - upright;
      CHECK((taken > 0) == (ratio >= 1));
      // Its series goes on with θ⁴ (M g l/24 + L₃²/48I₁), and then with θ⁶.
      const Exact square = tilt * tilt, series = (L3 * L3 / (4 * I) - pull) / 2 * square +
                                                 (pull / 24 + L3 * L3 / (48 * I)) * square * square;
      CHECK(std::abs(taken - series) <=
            upright * (square * square * square + 100 * unit_roundoff<Exact>));
    }
}

TEST_CASE("Half the step: kick and drift come twice as near to the exact top") {
  const auto gyroscope = toy_gyroscope<Exact>();
  const Top<Exact> start = set_spinning<Exact>(gyroscope, 1, 200);
  const auto exact = exactly_spinning(start, gyroscope);
  const auto off = [&](int steps) {
    Top<Exact> top = start;
    for (int n = 0; n < steps; ++n) step(top, gyroscope, drift<Exact>, Exact(1) / steps);
    return (axis_of(top) - axis_of(exact.at(1))).norm();
  };
  CHECK(std::abs(off(4000) / off(8000) - 2) <= 0.05L);
}

TEST_CASE_TEMPLATE("A top is held up for ten seconds in float as in double", Real,
                   EVERY_PRECISION) {
  const auto gyroscope = toy_gyroscope<Real>();
  const int steps = 2400;
  Top<Real> top = set_spinning<Real>(gyroscope, 1, 200);
  const Exact energy_at_start =
      kinetic_energy(exactly(top)) + Exact(pull_of(gyroscope)) * axis_of(exactly(top)).z();
  const Exact Lz = angular_momentum_world(exactly(top)).z(), L3 = top.angular_momentum_body.z();
  const auto exact = exactly_spinning(exactly(top), widened(gyroscope));
  Exact lowest = 1, highest = -1;
  for (int n = 0; n < steps; ++n) {
    step(top, gyroscope, drift<Real>, Real(1) / 240);
    lowest = std::min<Exact>(lowest, axis_of(top).z());
    highest = std::max<Exact>(highest, axis_of(top).z());
  }
  const Exact L = exactly(top).angular_momentum_body.norm();
  // Each step rounds L 60 times, by the torque and the turns: one as likely up as down.
  const Exact rounding = 60 * std::sqrt(Exact(steps)) * unit_roundoff<Real>;
  CHECK(std::abs(angular_momentum_world(exactly(top)).z() - Lz) <= rounding * L);
  CHECK(std::abs(top.angular_momentum_body.z() - L3) <= rounding * L);
  // The step moves along an exact motion of an energy that is off by half a kick times the drift's
  // rate, h τ ω/2: here that bends the cosines by h ω, ω the axis's fastest rate, times the dip.
  const Exact dip = exact.highest() - exact.lowest(),
              bend = Exact(1) / 240 * (Exact(L) / gyroscope.across) * dip;
  CHECK(lowest >= exact.lowest() - bend - rounding);
  CHECK(highest <= exact.highest() + bend + rounding);
  const Exact energy =
      kinetic_energy(exactly(top)) + Exact(pull_of(gyroscope)) * axis_of(exactly(top)).z();
  CHECK(std::abs(energy - energy_at_start) <= pull_of(gyroscope) * bend + rounding * L * 200);
}

TEST_CASE("Without the gyroscopic term a fast top goes round at M g l/(I1 w3), and hardly nods") {
  const auto gyroscope = toy_gyroscope<double>();
  const double tilt = 1, seconds = 0.5;
  const auto off = [&](double spin) {
    Topd top = set_spinning(gyroscope, tilt, spin);
    const int steps = static_cast<int>(seconds * spin * 100);
    double dip = 0, across = 0;
    for (int n = 0; n < steps; ++n) {
      step(top, gyroscope, turn_steadily<double>, seconds / steps);
      dip = std::max(dip, std::abs(tilt_of(top) - tilt));
      across = std::max(across, top.angular_momentum_body.head<2>().norm());
    }
    const double expected = pull_of(gyroscope) / (gyroscope.across * spin) * seconds,
                 diameter = 2 * pull_of(gyroscope) * std::sin(tilt) / spin;
    return std::array{std::abs(azimuth_of(top) - expected) / expected, dip,
                      std::abs(across / diameter - 1)};
  };
  // In the body the kicks go round with ω₃, so that L across the axis goes round too, with the
  // radius M g l sin θ/ω₃. That is a tilt of M g l sin θ/(I₁ ω₃²), which wobbles the axis by as
  // much, and by that part of a radian the direction.
  for (const double spin : {400.0, 1600.0}) {
    const auto [direction, dip, across] = off(spin);
    const double wobble = pull_of(gyroscope) / (gyroscope.across * spin * spin);
    CHECK(dip <= 4 * wobble);
    CHECK(across <= 4 * wobble + 0.01);  // a step is a hundredth of a radian of the spin
    CHECK(direction <= 4 / (spin * seconds) + 4 * wobble);
  }
}

TEST_CASE_TEMPLATE(
    "Without weight a top stays where it is let go, and goes round at L / I1 or not at all", Real,
    EVERY_PRECISION) {
  auto gyroscope = toy_gyroscope<Real>();
  gyroscope.weight = 0;
  CHECK(lowest_cosine<Real>(gyroscope, Real(0.5), 100) == Real(0.5));
  CHECK(lowest_cosine<Real>(gyroscope, Real(0.5), 0) == Real(0.5));
  CHECK(least_sleeping_spin(gyroscope) == 0);
  const auto [slow, fast] = steady_precessions<Real>(gyroscope, Real(0.5), 100);
  CHECK(slow == 0);
  CHECK(std::abs(fast / (gyroscope.along * 100 / (gyroscope.across * Real(0.5))) - 1) <=
        8 * unit_roundoff<Real>);
  CHECK(steady_precessions<Real>(gyroscope, Real(0.5), 0) == std::pair(Real(0), Real(0)));
}

TEST_CASE_TEMPLATE(
    "Level, a top has one steady rate, and none without spin; at the least spin two are one", Real,
    EVERY_PRECISION) {
  const Gyroscope<Real> plain{1, 2, 1, 1};  // whole numbers: nothing rounds
  CHECK(steady_precessions<Real>(plain, 0, 4).first == Real(0.125));
  CHECK(std::isinf(steady_precessions<Real>(plain, 0, 4).second));
  CHECK(complaint_of([&] { steady_precessions<Real>(plain, 0, 0); }) ==
        "spin is 0 rad/s; it is too slow for the axis to go round steadily");
  CHECK(least_sleeping_spin(plain) == 1);
  CHECK(steady_precessions<Real>(plain, 1, 1) == std::pair(Real(1), Real(1)));
  CHECK(complaint_of([&] { steady_precessions<Real>(plain, 1, Real(0.75)); }) ==
        "spin is 0.75 rad/s; it is too slow for the axis to go round steadily");
}

TEST_CASE_TEMPLATE("The weight's torque comes on top of what acts already", Real, EVERY_PRECISION) {
  const auto gyroscope = toy_gyroscope<Real>();
  Top<Real> top = set_spinning<Real>(gyroscope, 1, 200);
  add_weight(top, gyroscope);
  const Vec3<Real> once = top.torque;
  add_weight(top, gyroscope);
  CHECK(same_bits(top.torque, 2 * once));
}

TEST_CASE_TEMPLATE("A gyroscope is made about its tip, and a body that can't be one is refused",
                   Real, EVERY_PRECISION) {
  const auto gyroscope = toy_gyroscope<Real>();
  const Real m = Real(0.15), r = Real(0.03), h = Real(0.01), l = Real(0.04);
  CHECK(std::abs(gyroscope.along / (m * r * r / 2) - 1) <= 16 * unit_roundoff<Real>);
  CHECK(std::abs(gyroscope.across / (m * (3 * r * r + h * h) / 12 + m * l * l) - 1) <=
        24 * unit_roundoff<Real>);
  const MassProperties<Real> disc = mass_properties(Cylinder<Real>{r, h}, m);
  CHECK(complaint_of([&] {
          on_its_tip(disc, Real(0), Real(9.81));
        }).find("distance of the tip is 0 m") == 0);
  CHECK(complaint_of([&] { on_its_tip(disc, l, Real(-1)); }).find("gravity is -1 m/s^2") == 0);
  CHECK(complaint_of([&] {
          on_its_tip(disc, std::numeric_limits<Real>::infinity(), Real(9.81));
        }) == "distance of the tip is inf m; it must be finite");
  CHECK(complaint_of([&] { on_its_tip(mass_properties(ThinRod<Real>{1}, 1), l, Real(9.81)); }) ==
        "moment about the axis is 0 kg m^2; it must be greater than 0");
  MassProperties<Real> impossible = disc;
  impossible.inertia(2, 2) = -1;
  CHECK(complaint_of([&] { on_its_tip(impossible, l, Real(9.81)); }) ==
        "moment about the axis is -1 kg m^2; it must be greater than 0");
  // By however little: four roundings of a moment about the tip are enough.
  const Real little = 8 * unit_roundoff<Real> * gyroscope.across;
  for (const auto& [row, column] :
       {std::pair(0, 0), std::pair(1, 1), std::pair(0, 1), std::pair(1, 2), std::pair(0, 2)}) {
    MassProperties<Real> uneven = disc;
    uneven.inertia(row, column) += little;
    CHECK(complaint_of([&] {
            on_its_tip(uneven, l, Real(9.81));
          }).find("inertia about the tip is (") == 0);
  }
  CHECK(complaint_of([&] { steady_precessions<Real>(gyroscope, 1, 100); }) ==
        "spin is 100 rad/s; it is too slow for the axis to go round steadily");
}
