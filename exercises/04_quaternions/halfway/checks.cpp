#include <exercise/judge.hpp>
#include <tumble/rotation_vector.hpp>

using namespace tumble;
using namespace tumble::exercise;

namespace {

const Precondition part_of_the_way("between", 2, at_most_one);

template <class Real>
Quaternion<Real> between(const Quaternion<Real>& p, const Quaternion<Real>& q, Same<Real> part) {
  return ask<Quaternion<Real>>("between", p, q, part);
}

template <class Real>
Quaternion<Real> turned(Same<Real> x, Same<Real> y, Same<Real> z) {
  return quaternion_of_rotation_vector(Vec3<Real>(x, y, z));
}

/// Two products, an exponential and a logarithm, each with less than 24 roundings.
template <class Real>
constexpr double roundings = 4 * 24 * unit_roundoff<Real>;

/// The angle from p to the orientation `x`, as if only whole turns counted.
template <class Real>
Real angle(const Quaternion<Real>& p, const Quaternion<Real>& x) {
  return angle_between(p, x);
}

/// What the normalised straight line from p to q turns by, when they are `whole` rad apart.
template <class Real>
Real by_straight_line(Same<Real> whole, Same<Real> part) {
  const Real s = part * std::sin(whole / 2), c = 1 - part + part * std::cos(whole / 2);
  return 2 * std::atan2(s, c);
}

}  // namespace

EXERCISE_CHECK("The way begins at the one and ends at the other") {
  const auto p = turned<Real>(Real(0.4), -1, Real(0.3)), q = turned<Real>(-1, Real(0.2), 1);
  Found("the angle between p and the way's beginning", "rad", angle(p, between(p, q, 0)))
      .mistake(angle(p, q), "the way begins at q. 0 must give p, and 1 must give q")
      .mistake(angle(p, Quaternion<Real>{}), "the way begins at no turn at all. Where is p?")
      .must_be(0, roundings<Real>);
  const auto end = between(p, q, 1);
  Found("the angle between q and the way's end", "rad", angle(q, end))
      .mistake(angle(q, (conjugate(p) * q) * p),
               "p* q is the turn in body axes, and stands to the right of p. In world axes the "
               "turn is q p*, on the left")
      .mistake(angle(q, p * (q * conjugate(p))),
               "q p* is the turn in world axes, and stands to the left of p")
      .mistake(angle(q, q * conjugate(p)), "that is the turn alone, without p before it")
      .must_be(0, roundings<Real>);
  Found("the norm of the quaternion halfway", "", norm(between(p, q, Real(0.5))))
      .must_be(1, roundings<Real>);
}

EXERCISE_CHECK("It runs steadily: a part of the way is that part of the angle") {
  const auto p = turned<Real>(1, Real(-0.5), Real(0.25));
  for (const double degrees : {30.0, 120.0, 170.0}) {
    const Real whole = Real(degrees * std::numbers::pi / 180);
    const auto q = turned<Real>(whole * Real(0.48), whole * Real(0.6), whole * Real(-0.64)) * p;
    for (const double part : {0.25, 0.5, 0.875}) {
      const auto found = between(p, q, Real(part));
      const std::string where = "after " + shown(part) + " of the way between two orientations " +
                                shown(degrees) + "° apart, the angle ";
      Found(where + "from the first", "rad", angle(p, found))
          .mistake(by_straight_line<Real>(whole, Real(part)),
                   "that is where the straight line from p to q gets, normalised. It runs fast in "
                   "the middle. The angle must grow in proportion")
          .mistake(Real(1 - part) * whole,
                   "that is the angle left to q. 0 must give p, and 1 must give q")
          .mistake(Real(part) * whole / 2,
                   "half of what it should be. The quaternion holds half the angle already")
          .must_be(Real(part) * whole, 4 * roundings<Real>);
      Found(where + "to the second", "rad", angle(found, q))
          .must_be(Real(1 - part) * whole, 4 * roundings<Real>);
    }
  }
}

EXERCISE_CHECK(
    "Of the two ways round it takes the shorter, whatever the signs of the quaternions") {
  const auto p = turned<Real>(Real(0.2), Real(-0.3), Real(0.1));
  const auto q = turned<Real>(0, 0, Real(1.5)) * p;
  for (const auto& [from, to] : {std::pair{p, -q}, std::pair{-p, q}, std::pair{-p, -q}}) {
    const auto found = between(from, to, Real(0.5));
    Found("halfway between two orientations 1.5 rad apart, the angle from the first", "rad",
          angle(p, found))
        .mistake(std::numbers::pi_v<Real> - Real(0.75),
                 "it went the long way round. q and -q are one orientation: take the way that is "
                 "shorter")
        .not_a_number(
            "the result is not a number. Does something divide by the sine of an angle that is "
            "zero?")
        .must_be(Real(0.75), 4 * roundings<Real>);
    Found("halfway between two orientations 1.5 rad apart, the angle to the second", "rad",
          angle(found, q))
        .mistake(Real(2.25),
                 "it turned by as much as it should, but away from the second. With the sign of "
                 "the real part change those of the others: q and -q are one orientation")
        .must_be(Real(0.75), 4 * roundings<Real>);
  }
}

EXERCISE_CHECK("A tiny turn is cut as exactly as a large one") {
  const auto p = turned<Real>(Real(0.5), 1, Real(-0.25));
  // So small that its square is lost beside 1, and yet far more than what is rounded.
  const Real whole = Real(1024 * unit_roundoff<Real>);
  const auto q = turned<Real>(whole, 0, 0) * p;
  const auto found = between(p, q, Real(0.5));
  // Each of the products rounds components up to 1, four times each.
  const double rounded = 4 * 8 * unit_roundoff<Real>;
  Found("halfway of a turn by " + shown(whole) + " rad, the angle from the first", "rad",
        angle(p, found))
      .not_a_number(
          "the result is not a number: the axis of so small a turn was divided by zero, or an "
          "arc cosine taken of more than 1")
      .mistake(0,
               "nothing was turned. Near zero a cosine is flat: an arc cosine of it has no "
               "digits left")
      .must_be(whole / 2, rounded);
  // The same orientation twice is no turn at all, and no division by zero.
  Found("halfway between an orientation and itself, the angle from it", "rad",
        angle(p, between(p, p, Real(0.5))))
      .not_a_number("the result is not a number: a turn by nothing has no axis to divide by")
      .must_be(0, rounded);
}
