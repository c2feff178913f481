#include <exercise/judge.hpp>
#include <tumble/orientation.hpp>

using namespace tumble;
using namespace tumble::exercise;

namespace {

template <class Real>
using Readings = std::vector<Vec3<Real>>;

template <class Real>
Quaternion<Real> faced(const Quaternion<Real>& from, const Readings<Real>& readings,
                       Same<Real> interval) {
  return ask<Quaternion<Real>>("faced", from, readings, interval);
}

/// A step rounds 23 times in a component, see chapter 7; an angle counts them twice.
template <class Real>
double roundings(std::size_t steps) {
  return 2 * 2 * 23 * double(steps + 2) * double(unit_roundoff<Real>);
}

template <class Real>
Quaternion<Real> tilted() {
  return quaternion_of_rotation_vector(Vec3<Real>(Real(0.5), -1, Real(0.25)));
}

}  // namespace

EXERCISE_CHECK("A phone that turns steadily faces where its rate times the time says") {
  const Real rate = Real(parameter("rate")), interval = Real(0.0625);
  const std::size_t intervals = 8;
  const Vec3<Real> spin(0, 0, rate);
  const Real angle = rate * interval * intervals;
  const Quaternion<Real> start;
  const auto found = faced(start, Readings<Real>(intervals + 1, spin), interval);
  Found("the angle after 8 intervals of 0.0625 s at " + shown(rate) + " rad/s", "rad",
        angle_between(start, found))
      .mistake(angle + rate * interval,
               "one interval too many. Nine readings have eight intervals between them")
      .mistake(angle - rate * interval, "one interval is missing")
      .mistake(angle / 2,
               "half of what it should be. The quaternion's half is in turn_exponential already")
      .mistake(intervals * 2 * std::atan(rate * interval / 2),
               "that is the first-order rule's angle. The exponential is exact here")
      .mistake(0, "it has not turned")
      .must_be(angle, roundings<Real>(intervals));
  const auto points = [](Real by) { return Vec3<Real>(std::cos(by), std::sin(by), 0); };
  Found("after 8 intervals, the direction of its x axis", "", rotate(found, points(0)))
      .mistake(points(-angle), "it turns backwards: about +z, x goes towards y")
      .must_be(points(angle), roundings<Real>(intervals));
  const auto at_once = faced(tilted<Real>(), Readings<Real>(1, spin), interval);
  Found("the angle turned at the first reading, when no time has passed", "rad",
        angle_between(tilted<Real>(), at_once))
      .mistake(rate * interval, "a single reading has no interval after it")
      .must_be(0, roundings<Real>(0));
}

EXERCISE_CHECK("The readings are about the phone's own axes") {
  const Real rate = Real(parameter("rate")), interval = Real(0.0625);
  const std::size_t intervals = 8;
  const auto start = tilted<Real>();
  const Vec3<Real> spin(0, 0, rate), screen(0, 0, 1);
  const auto found = faced(start, Readings<Real>(intervals + 1, spin), interval);
  require(angle_between(start, found) > rate * interval,
          sentence("after 8 intervals of 0.0625 s at ", rate, " rad/s the phone has turned by ",
                   angle_between(start, found), " rad. Is there a turn for each interval?"));
  Quaternion<Real> about_world =
      quaternion_of_rotation_vector<Real>(Vec3<Real>(0, 0, rate * interval * intervals)) * start;
  Found("the direction of a tilted phone's screen after a turn about its own z", "",
        rotate(found, screen))
      .mistake(rotate(about_world, screen),
               "the phone was turned about the world's z. A gyroscope moves along with the phone: "
               "body axes stand on the right")
      .must_be(rotate(start, screen), roundings<Real>(intervals));
}

EXERCISE_CHECK("While the rate grows evenly about one axis, the angle is exact") {
  const Real rate = Real(parameter("rate")), interval = Real(0.125);
  const std::size_t intervals = 4;
  Readings<Real> readings;
  for (std::size_t n = 0; n <= intervals; ++n)
    readings.push_back(Vec3<Real>(0, rate * Real(n) / intervals + rate, 0));
  // From the rate w to 2 w in half a second: three quarters of w.
  const Real truth = rate * Real(0.75), step = rate * interval / 2;
  const auto found = faced({}, readings, interval);
  Found("the angle of a phone that speeds up from " + shown(rate) + " to " + shown(2 * rate) +
            " rad/s in 0.5 s",
        "rad", angle_between(Quaternion<Real>{}, found))
      .mistake(truth - step,
               "too little: each turn took the reading at "
               "the interval's beginning. You also know the one at its end")
      .mistake(truth + step,
               "too much: each turn took the reading at the "
               "interval's end. You also know the one at its beginning")
      .mistake(2 * truth, "twice the angle: the two readings were added. Take their mean")
      .must_be(truth, roundings<Real>(intervals));
  const auto points = [](Real by) { return Vec3<Real>(std::sin(by), 0, std::cos(by)); };
  Found("after 0.5 s, the direction of its screen", "", rotate(found, points(0)))
      .mistake(points(-truth), "it turns backwards: about +y, z goes towards x")
      .must_be(points(truth), roundings<Real>(intervals));
}

EXERCISE_CHECK("Half the interval, a quarter of the error") {
  // Turned in the world about z at the rate a, and in itself about z at the rate b, with a tilt
  // between: q = e^(a t k/2) p e^(b t k/2), and ω in body axes is b k + q* (a k) q.
  const double a = 2, b = -3, time = 1;
  const auto p = quaternion_of_rotation_vector(Vec3d(0.8, 0, 0));
  const auto orientation = [&](double t) {
    return quaternion_of_rotation_vector(Vec3d(0, 0, a * t)) * p *
           quaternion_of_rotation_vector(Vec3d(0, 0, b * t));
  };
  const auto cast = [](const Quaterniond& q) {
    return Quaternion<Real>{Real(q.real), q.imaginary.cast<Real>()};
  };
  const auto miss = [&](int intervals) {
    Readings<Real> readings;
    for (int n = 0; n <= intervals; ++n) {
      const Vec3d rate =
          Vec3d(0, 0, b) + rotate_back(orientation(time * n / intervals), Vec3d(0, 0, a));
      readings.push_back(rate.cast<Real>());
    }
    const auto found = faced(cast(orientation(0)), readings, Real(time / intervals));
    return double(angle_between(cast(orientation(time)), found));
  };
  may_be_off() = 0.02;  // another rule of second order differs by as much as this one's error
  const double coarse = miss(8), fine = miss(16);
  require(std::isfinite(coarse) && coarse < 0.5,
          "with eight intervals the phone faces " + shown(coarse) +
              " rad away from the truth. Are the turns made in body axes, one after the other?");
  // The next order, two higher, is some (rate times interval)²/12 of the error: below a twentieth.
  // Roundings in float are a thousandth of it.
  Found("the error with 8 intervals, divided by that with 16,", "", coarse / fine)
      .mistake(2,
               "half the interval, half the error: first order. The mean of two readings is a "
               "better angular velocity for the interval than either")
      .must_be(4, 0.2);
}
