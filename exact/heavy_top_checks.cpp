#include <support/second_method.hpp>
#include <tumble/exact/heavy_top.hpp>

using namespace tumble;
using namespace tumble::support;
using exact::HeavyTop;

namespace {

/// A start: moments (kg m²), weight times distance (N m), tilt (rad), ω in body axes (rad/s).
struct HeavyTopCase {
  std::string name;
  double across, along, pull, tilt;
  Vec3d spin;
};

Topd start_of(const HeavyTopCase& given) {
  Topd top;
  top.inverse_moments = {1 / given.across, 1 / given.across, 1 / given.along};
  const Quaterniond around = normalized(Quaterniond{0.9, {0, 0, 0.4}});
  top.orientation =
      normalized(around * Quaterniond{std::cos(given.tilt / 2), {std::sin(given.tilt / 2), 0, 0}});
  set_angular_velocity_body(top, given.spin);
  return top;
}

Top<long double> integrated_heavy_top(const Top<long double>& start, const Vec3d& pull,
                                      long double time, int steps) {
  return integrated_top(start, time, steps, [&](const Top<long double>& now) -> Vec3<long double> {
    const Vec3<long double> pull_body =
        rotate_back(normalized(now.orientation), pull.cast<long double>());
    return Vec3<long double>(0, 0, 1).cross(pull_body);
  });
}

/// The error that HeavyTop may make of the orientation, rad, or of L relative to its size, counted
/// like that of FreeTop, after the fastest rate in play has turned by `turned` rad.
///
/// Each radian rounds 140 times: λ t + u₀ 17 (the coefficients of f have 8, a gap between its roots
/// 20, of which a root takes half), each of the two angles 60 (20 in its factor and its n, 24 in
/// Carlson's integrals, 16 in product and sum), the spin about the axis 3.
///
/// 440 come once: two angles with 30 in their quick and 48 π in their slow part, at the start
/// alone; 40 in Euler's turns and their product, 40 in the direction of L.
template <class Real>
Real rounding_of_heavy_top(Real turned) {
  return spread<Real>(440) + spread<Real>(140) * turned;
}

/// The fastest rate in play: the spin, and that of the swing.
long double rate_of(const Top<long double>& top, double pull) {
  return angular_velocity_body(top).norm() +
         std::abs(top.angular_momentum_body.z()) * top.inverse_moments.x() +
         std::sqrt(4 * pull * top.inverse_moments.x());
}

void agrees(const HeavyTopCase& given, const Vec3d& pull) {
  CAPTURE(given.name);
  const Topd start = start_of(given);
  Top<long double> witness = in_long_double(start);
  witness.orientation = normalized(witness.orientation);
  const long double rate = rate_of(witness, given.pull);
  const HeavyTop<double> exact(start, pull);
  const HeavyTop<long double> in_witness(witness, pull.cast<long double>());
  const long double size = rate / witness.inverse_moments.x();
  const int steps = 2000;
  for (const double time : {0.01, 2.0}) {
    CAPTURE(time);
    const auto truth = integrated_heavy_top(witness, pull, time, steps);
    CHECK(difference(exact.at(time), truth, size) <=
          rounding_of_heavy_top(static_cast<double>(rate) * time));
    CHECK(difference(in_witness.at(time), truth, size) <=
          rounding_of_heavy_top(rate * time) + eighth_order_error(rate, time, steps));
  }
}

}  // namespace

TEST_CASE("The heavy top agrees with Fehlberg's rule, whichever way it swings and spins") {
  for (const double spin : {20.0, 3.0, 0.0, -3.0, -20.0})
    for (const double tilt : {0.1, 0.6, 1.6, 3.0})
      for (const Vec3d& across : {Vec3d(0, 0, 0), Vec3d(0.3, -0.2, 0), Vec3d(-4, 1, 0)})
        agrees({"swing", 0.5, 0.2, 1, tilt, across + Vec3d(0, 0, spin)}, {0, 0, -1});
  // The third root of f lies above the sum of the coefficients over the leading one, unless 1 is
  // added to it; and where the pull is weak far above their product.
  agrees({"a little tilted, fast and pushed", 1, 0.2, 6.7, 0.09, {1.1, 0, 25}}, {0, 0, -6.7});
  agrees({"fast under a weak pull", 1, 0.2, 0.1, 0.1, {0.1, 0, 15}}, {0, 0, -0.1});
}

TEST_CASE(
    "The heavy top agrees with Fehlberg's rule where it starts or passes upright or hanging") {
  const double pi = 3.14159265358979323846;
  for (const HeavyTopCase& given :
       {HeavyTopCase{"upright and pushed", 0.5, 0.2, 1, 0, {1, 0.5, 3}},
        HeavyTopCase{"upright, fast and pushed", 0.5, 0.2, 1, 0, {0.001, 0.5, 30}},
        HeavyTopCase{"nearly upright", 0.5, 0.2, 1, 1e-6, {0, 0.001, 30}},
        HeavyTopCase{"hanging and pushed", 0.5, 1, 1, pi, {3, 1, -2}},
        HeavyTopCase{"a pendulum", 0.5, 1, 1, 0.6, {1, 0, 0}},
        HeavyTopCase{"a pendulum that turns over", 0.5, 1, 1, 0.6, {5, 0, 0}},
        HeavyTopCase{"past upright by a hair", 0.5, 1, 1, 0.3, {5, 0, 1e-7}},
        HeavyTopCase{"past upright by a hand", 0.5, 1, 1, 0.3, {5, 0, 0.1}},
        HeavyTopCase{"upright and pushed about one axis", 0.5, 0.2, 1, 0, {0, 0.5, 3}},
        HeavyTopCase{"upright and pushed about the other", 0.5, 0.2, 1, 0, {0.5, 0, 3}},
        HeavyTopCase{"a whirl from below", 0.5, 1, 1, 3.1, {30, 1, -2}}})
    agrees(given, {0, 0, -given.pull});
  // Upright against a pull upwards: it hangs, without a rounding, and its tilt has no direction.
  agrees({"hanging to the bit and pushed", 0.5, 1, 1, 0, {3, 1, -2}}, {0, 0, 1});
  agrees({"a pendulum, let go at its lowest", 0.5, 1, 1, 0, {1, 0, 0}}, {0, 0, 1});
  // It begins where cn is 0, in a plane with the vertical: its direction is that of a moment later.
  for (const double tilt : {0.1, 0.6, 1.6, 3.0})
    agrees({"a pendulum, let go at rest", 0.5, 1, 1, tilt, {0, 0, 0}}, {0, 0, -1});
}

TEST_CASE("The heavy top keeps its digits at the instant when it all but stands upright") {
  // From its lowest point, with L_z all but equal to L3: the nearer they are, the nearer to
  // upright.
  const Vec3d pull(0, 0, -1);
  for (const double off : {1e-7, 1e-4, 0.0}) {
    const double tilt = 2.5, spin = 4;
    const Topd start = start_of(
        {"rises", 0.5, 1, 1, tilt, {0, spin / 0.5 * std::tan(tilt / 2) * (1 + off), spin}});
    const HeavyTop<double> exact(start, pull);
    Top<long double> witness = in_long_double(start);
    witness.orientation = normalized(witness.orientation);
    const double half = exact.nutation_period() / 2;
    for (const double time : {half * (1 - 1e-8), half, half * (1 + 1e-8)}) {
      const auto truth = integrated_heavy_top(witness, pull, time, 4000);
      CHECK(difference(exact.at(time), truth) <=
            rounding_of_heavy_top(static_cast<double>(rate_of(witness, 1)) * time));
    }
    CHECK(1 - exact.highest() <= off * off + 4 * unit_roundoff<double>);
  }
}

TEST_CASE("Upright and without a push the heavy top sleeps, even where that is not stable") {
  for (const double spin : {30.0, 1.0, 0.0}) {
    const Topd start = start_of({"asleep", 0.5, 0.2, 1, 0, {0, 0, spin}});
    const HeavyTop<double> exact(start, {0, 0, -1});
    const Topd later = exact.at(100);
    CHECK(std::abs(rotate(later.orientation, Vec3d(0, 0, 1)).z() - 1) <= 4 * unit_roundoff<double>);
    CHECK(same_bits(later.angular_momentum_body, start.angular_momentum_body));
    // It turns about its axis at w3, whatever the moment across.
    const Quaterniond turned =
        start.orientation *
        quaternion_about<double>({0, 0, 1}, std::remainder(100 * spin, 4 * M_PI));
    CHECK(angle_between(later.orientation, turned) <= rounding_of_heavy_top(100 * spin));
  }
}

TEST_CASE("A heavy top that sleeps keeps its tilt, upright and hanging") {
  const Topd start = start_of({"asleep", 0.5, 0.2, 1, 0, {0, 0, 3}});
  for (const double up : {1.0, -1.0}) {
    const HeavyTop<double> exact(start, {0, 0, -up});
    CHECK(exact.lowest() == up);
    CHECK(exact.highest() == up);
    CHECK(std::isinf(exact.nutation_period()));
  }
}

TEST_CASE("Any direction can be down for the heavy top") {
  const HeavyTopCase given{"sideways", 0.5, 0.2, 3, 0.6, {0.3, -0.2, 4}};
  agrees(given, {3 * 0.6, 0, 3 * 0.8});
  agrees(given, {0, 3, 0});
}

TEST_CASE("A heavy top may weigh tonnes") {
  agrees({"a carousel", 4000, 3000, 20000, 0.6, {0.3, -0.2, 4}}, {0, 0, -20000});
}

TEST_CASE("A heavy top that starts with the speed of steady precession keeps its tilt") {
  // I1 cos(tilt) W² - I3 w3 W + M g l = 0 for I1 = 0.5, I3 = 0.2, w3 = 20, M g l = 1.
  const double tilt = 0.6, a = 0.5 * std::cos(tilt), b = 0.2 * 20;
  const double root = std::sqrt(b * b - 4 * a);
  for (const double precession : {2 / (b + root), (b + root) / (2 * a)}) {
    CHECK(std::min(std::abs(precession - 0.256803667), std::abs(precession - 9.436222849)) <=
          0.5e-9);
    const Topd start =
        start_of({"steady", 0.5, 0.2, 1, tilt, {0, precession * std::sin(tilt), 20}});
    const HeavyTop<double> exact(start, {0, 0, -1});
    // The slope of f vanishes at the start by three terms of up to 50/s² that cancel. Each rounds 6
    // times, and takes twice what the start rounds, 5 times. The distance of the roots is that, by
    // the third root's distance, 20, and by 4/s².
    const double allowed = 3 * 50 * (6 + 2 * 5) / (20.0 * 4) * unit_roundoff<double>;
    CHECK(std::abs(exact.highest() - exact.lowest()) <= allowed);
    const Vec3d axis = rotate(start.orientation, Vec3d(0, 0, 1));
    for (const double time : {1.0, 10.0, 100.0}) {
      const Vec3d turned =
          rotate(quaternion_of_rotation_vector(Vec3d(0, 0, precession * time)), axis);
      CHECK((rotate(exact.at(time).orientation, Vec3d(0, 0, 1)) - turned).norm() <=
            allowed * (1 + 20 * time));
    }
  }
}

TEST_CASE("Where all roots meet to the bit a heavy top goes round steadily, and nothing is 0/0") {
  // Its axis is horizontal, L3 W = M g l = 1, and none of it rounds: the tilt has no range at all.
  Topd start{.angular_momentum_body = {1, 0, 1}, .inverse_moments = {1, 1, 2}};
  const HeavyTop<double> exact(start, {-1, 0, 0});
  CHECK(exact.lowest() == exact.highest());
  for (const double time : {-3.0, 0.5, 100.0}) {
    const Topd now = exact.at(time);
    const Vec3d axis = rotate(now.orientation, Vec3d(0, 0, 1));
    CHECK((axis - Vec3d(0, -std::sin(time), std::cos(time))).norm() <=
          rounding_of_heavy_top(4 * std::abs(time)));
    CHECK(now.angular_momentum_body.z() == 1);
  }
}

TEST_CASE_TEMPLATE("The heavy top's energy and both its momenta stay, for as long as one likes",
                   Real, double, long double) {
  const Topd given = start_of({"swing", 0.5, 0.2, 1, 0.6, {0.3, -0.2, 3}});
  Top<Real> start;
  start.orientation = normalized(
      Quaternion<Real>{given.orientation.real, given.orientation.imaginary.template cast<Real>()});
  start.angular_momentum_body = given.angular_momentum_body.template cast<Real>();
  start.inverse_moments = given.inverse_moments.template cast<Real>();
  const HeavyTop<Real> exact(start, {0, 0, -1});
  const auto energy = [](const Top<Real>& top) {
    return kinetic_energy(top) + rotate(top.orientation, Vec3<Real>(0, 0, 1)).z();
  };
  const Real size = start.angular_momentum_body.norm();
  for (int n = -1000; n < 1000; n += 7) {
    const Top<Real> now = exact.at(Real(0.713) * Real(n));
    CHECK(now.angular_momentum_body.z() == start.angular_momentum_body.z());
    CHECK(std::abs(angular_momentum_world(now).z() - angular_momentum_world(start).z()) <=
          size * rounding_of_heavy_top<Real>(0));
    CHECK(std::abs(energy(now) - energy(start)) <=
          2 * energy(start) * rounding_of_heavy_top<Real>(0));  // it is perpendicular to L
  }
}

TEST_CASE("A heavy top without a pull, or with three moments, is refused") {
  const Topd start = start_of({"swing", 0.5, 0.2, 1, 0.6, {0.3, -0.2, 3}});
  CHECK(complaint_of([&] {
          HeavyTop<double>(start, {0, 0, 0});
        }) == "pull is (0, 0, 0) N m; it must not be zero; without it the top is free");
  CHECK(complaint_of([&] {
          HeavyTop<double>(start, {0, 0, NAN});
        }) == "pull is (0, 0, nan) N m; every component must be finite");
  for (int axis = 0; axis < 3; ++axis) {
    Topd locked = start;
    locked.inverse_moments[axis] = 0;
    CHECK(complaint_of([&] {
            HeavyTop<double>(locked, {0, 0, -1});
          }).find("inverse moments of a heavy top is (") == 0);
  }
  Topd needle = start;  // locked across its axis, both ways alike
  needle.inverse_moments = {0, 0, 5};
  CHECK(complaint_of([&] {
          HeavyTop<double>(needle, {0, 0, -1});
        }).find("inverse moments of a heavy top is (0, 0, 5) 1/(kg m^2)") == 0);
  Topd uneven = start;
  uneven.inverse_moments = {1, 2, 3};
  CHECK(complaint_of([&] {
          HeavyTop<double>(uneven, {0, 0, -1});
        }) ==
        "inverse moments of a heavy top is (1, 2, 3) 1/(kg m^2); the first two must be equal, and "
        "all greater than 0");
}

TEST_CASE(
    "After a nutation period the heavy top's tilt is back, and in half of it at the other end") {
  for (const double spin : {20.0, 3.0, 0.5}) {
    const Topd start = start_of({"let go", 0.5, 0.2, 1, 0.6, {0, 0, spin}});
    const HeavyTop<double> exact(start, {0, 0, -1});
    const auto height = [&](double time) {
      return rotate(exact.at(time).orientation, Vec3d(0, 0, 1)).z();
    };
    // Let go at rest it starts at its highest. Near its ends the height changes by the square of
    // the time, so what the period rounds does not show.
    const double allowed = rounding_of_heavy_top<double>(30 * exact.nutation_period());
    CHECK(std::abs(height(0) - exact.highest()) <= allowed);
    CHECK(std::abs(height(exact.nutation_period()) - exact.highest()) <= allowed);
    CHECK(std::abs(height(exact.nutation_period() / 2) - exact.lowest()) <= allowed);
    CHECK(exact.highest() - exact.lowest() > 1e-3);
  }
}
