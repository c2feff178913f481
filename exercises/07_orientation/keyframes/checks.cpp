#include <exercise/judge.hpp>
#include <tumble/orientation.hpp>

using namespace tumble;
using namespace tumble::exercise;

namespace {

template <class Real>
Vec3<Real> exact(const Quaternion<Real>& from, const Quaternion<Real>& to, Same<Real> h) {
  return ask<Vec3<Real>>("angular_velocity_between", from, to, h);
}

template <class Real>
Vec3<Real> first_order(const Quaternion<Real>& from, const Quaternion<Real>& to, Same<Real> h) {
  return ask<Vec3<Real>>("angular_velocity_for_first_order", from, to, h);
}

/// Two products, an exponential and a logarithm or a quotient: less than 24 roundings each, of
/// angular velocities below `size`.
template <class Real>
double roundings(double size) {
  return 4 * 24 * size * double(unit_roundoff<Real>);
}

template <class Real>
Quaternion<Real> start() {
  return quaternion_of_rotation_vector(Vec3<Real>(Real(0.5), -1, Real(0.25)));
}

template <class Real>
const Vec3<Real> axis(Real(0.48), Real(0.6), Real(-0.64));

template <class Real>
Quaternion<Real> turned_by(Same<Real> angle) {
  return quaternion_of_rotation_vector(Vec3<Real>(angle * axis<Real>)) * start<Real>();
}

}  // namespace

EXERCISE_CHECK("Stepped by the exponential, the platform arrives at the next key frame") {
  const Real h = Real(0.5);
  for (const double angle : {0.25, 1.5, 3.0}) {
    const auto from = start<Real>(), to = turned_by<Real>(Real(angle));
    const Vec3<Real> truth = Real(angle) / h * axis<Real>, found = exact(from, to, h);
    Found("the angular velocity between key frames " + shown(angle) + " rad and 0.5 s apart",
          "rad/s", found)
        .mistake(truth * h, "that is the rotation vector. Per second it is more: divide by h")
        .mistake(truth * h * h, "it was multiplied by h. A turn in less time is faster")
        .mistake(truth / 2,
                 "half of what it should be: rotation_vector_of doubles the half angle already")
        .mistake(truth * 2,
                 "twice what it should be: rotation_vector_of doubles the half angle already")
        .mistake(-truth, "it leads back: the turn that leads there is to · from*")
        .mistake(
            rotate_back(from, truth),
            "that is the angular velocity in body axes, of from* · to. In world axes the turn is "
            "to · from*")
        .mistake(Real(2 * std::sin(angle / 2)) / h * axis<Real>,
                 "the size is that of the difference of the two quaternions, a sine. The angle "
                 "itself is wanted")
        .mistake(Real(2 * std::tan(angle / 2)) / h * axis<Real>,
                 "the size is that for the first-order rule, a tangent")
        .must_be(truth, 4 * roundings<Real>(8));
    Found("the angle between the key frame and where turn_exponential arrives", "rad",
          angle_between(to, turn_exponential<Real>(from, found, h)))
        .must_be(0, 8 * roundings<Real>(4));
  }
}

EXERCISE_CHECK("It goes the shorter way, whatever the signs of the key frames") {
  const auto from = start<Real>(), to = turned_by<Real>(1);
  const Vec3<Real> truth = axis<Real>, tangent = Real(2 * std::tan(0.5)) * axis<Real>;
  const Vec3<Real> long_way = Real(1 - 2 * std::numbers::pi) * axis<Real>;
  for (const auto& [p, q] : {std::pair{from, -to}, std::pair{-from, to}, std::pair{-from, -to}}) {
    Found("the angular velocity between key frames 1 rad and 1 s apart", "rad/s", exact(p, q, 1))
        .mistake(long_way, "it goes the long way round. q and -q are one orientation")
        .must_be(truth, 2 * roundings<Real>(8));
    Found("the angular velocity for the first-order rule, 1 rad and 1 s apart,", "rad/s",
          first_order(p, q, 1))
        .mistake(-tangent,
                 "it leads back. q and -q are one orientation: is the real part's sign lost?")
        .must_be(tangent, 2 * roundings<Real>(8));
  }
}

EXERCISE_CHECK("Stepped by the first-order rule, it arrives too, if it is given more") {
  const Real h = Real(0.5);
  for (const double angle : {0.25, 1.5, 3.0}) {
    const auto from = start<Real>(), to = turned_by<Real>(Real(angle));
    const double size = 2 * std::tan(angle / 2) / double(h);
    const Vec3<Real> truth = Real(size) * axis<Real>, found = first_order(from, to, h);
    // Near half a turn the tangent is steep: a rounding of the angle counts 1/cos² times.
    const double steep = 1 / (std::cos(angle / 2) * std::cos(angle / 2));
    Found("the angular velocity with which the first-order rule turns by " + shown(angle) +
              " rad in 0.5 s",
          "rad/s", found)
        .mistake(Real(angle) / h * axis<Real>,
                 "that is the exponential's. With it this rule falls short, at 2 atan(ω h/2)")
        .mistake(Real(2 * std::sin(angle / 2)) / h * axis<Real>,
                 "that is the vector part alone, as of the difference of the two quaternions. The "
                 "rule normalises: divide by the real part")
        .mistake(truth / 2, "half of what it should be: the quotient is h/2 ω")
        .mistake(truth * h, "it is not per second yet: divide by h")
        .mistake(rotate_back(from, truth), "that is in body axes, of from* · to")
        .must_be(truth, roundings<Real>(8) * steep * 4);
    Found("the angle between the key frame and where turn_first_order arrives", "rad",
          angle_between(to, turn_first_order<Real>(from, found, h)))
        .must_be(0, 8 * roundings<Real>(4) * steep);
  }
}

EXERCISE_CHECK("Between key frames that are nearly the same no digit is lost") {
  // So little that its square is lost beside 1. A product rounds by 8 where its parts are near 1.
  const Real angle = Real(1024 * unit_roundoff<Real>), h = Real(0.5);
  const auto from = start<Real>(), to = turned_by<Real>(angle);
  const Vec3<Real> truth = angle / h * axis<Real>;
  const double tolerance = 4 * 8 * double(unit_roundoff<Real>) / double(h) * 2;
  const std::string flat = "an arc cosine has no digits left near zero; ask for sine and cosine";
  Found("the angular velocity between key frames " + shown(angle) + " rad apart", "rad/s",
        exact(from, to, h))
      .not_a_number("not a number: the turn is too small to divide by")
      .mistake(Vec3<Real>::Zero(), flat)
      .must_be(truth, tolerance);
  Found("the angular velocity for the first-order rule, " + shown(angle) + " rad apart,", "rad/s",
        first_order(from, to, h))
      .not_a_number("not a number: the turn is too small to divide by")
      .must_be(truth, tolerance);
  Found("the angular velocity between a key frame and itself", "rad/s", exact(from, from, h))
      .not_a_number("not a number: a turn by nothing has no axis to divide by")
      .must_be(Vec3<Real>::Zero(), tolerance);
}

EXERCISE_CHECK("Half a turn is refused by the one that cannot make it") {
  const Quaternion<Real> from, to{.real = 0, .imaginary = Vec3<Real>(0, 0, 1)};
  require(first_order(start<Real>(), turned_by<Real>(1), 1).norm() > Real(0.5),
          "a turn by 1 rad in a second is one that the first-order rule can make, and it must get "
          "more than half a rad/s");
  ask_refusal(
      "asked for half a turn, angular_velocity_for_first_order gave an answer. No ω makes the rule "
      "turn so far: it would divide by a real part of zero",
      "angular_velocity_for_first_order", from, to, Real(1));
  const auto found = exact(from, to, 1);
  // Either way round is half a turn.
  const Vec3<Real> truth(0, 0, std::copysign(std::numbers::pi_v<Real>, found.z()));
  Found("the angular velocity of half a turn about z in a second, by the exponential,", "rad/s",
        found)
      .must_be(truth, roundings<Real>(4));
}
