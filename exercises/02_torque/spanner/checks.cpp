#include <exercise/judge.hpp>
#include <tumble/torque.hpp>

using namespace tumble;
using namespace tumble::exercise;

namespace {

template <class Real>
constexpr Real right_angle = std::numbers::pi_v<Real> / 2;

template <class Real>
Real pull(Real torque, Real length, Real angle) {
  return ask<Real>("pull_needed", torque, length, angle);
}

}  // namespace

EXERCISE_CHECK("Perpendicular to a spanner of 25 cm the pull is four times the torque in N m") {
  const Real torque = Real(parameter("torque")), length = Real(0.25);
  Found("the pull for " + shown(torque) + " N m", "N", pull(torque, length, right_angle<Real>))
      .mistake(torque / 4, "that is torque times length. A longer spanner should need less")
      .mistake(torque, "that is the torque itself. How long is the spanner?")
      .mistake(torque / (length * std::sin(right_angle<Real> * std::numbers::pi_v<Real> / 180)),
               "the angle is in rad already; it was converted to rad once more")
      .must_be(4 * torque, 4 * torque * 8 * unit_roundoff<Real>);
}

EXERCISE_CHECK("At a slant it takes a stronger pull, by one over the sine of the angle") {
  const Real torque = Real(parameter("torque")), length = Real(0.25);
  const Real square = 4 * torque;
  for (const double degrees : {60.0, 30.0, 120.0}) {
    const Real angle = Real(degrees * std::numbers::pi / 180);
    const Real truth = Real(double(square) / std::sin(double(angle)));
    Found("the pull at " + shown(degrees) + "°", "N", pull(torque, length, angle))
        .mistake(square, "as at a right angle. At a slant only a part of the pull turns")
        .mistake(square * std::sin(angle),
                 "at a slant it takes less? Only a part of the pull turns, so it takes more")
        .mistake(
            square / std::cos(angle),
            "that is one over the cosine. The cosine is the part of the pull along the spanner; "
            "what turns is the part across it")
        .mistake(square * std::cos(angle),
                 "the cosine gives the part along the spanner, and such a factor belongs in the "
                 "denominator")
        .must_be(truth, truth * 8 * unit_roundoff<Real>);
  }
}

EXERCISE_CHECK("Chapter 2's torque_about confirms the pull") {
  for (const double angle : {0.2, 1.0, 1.5, 2.9}) {
    const Real torque = Real(parameter("torque")), length = Real(0.3);
    const Real force = pull(torque, length, Real(angle));
    const Vec3<Real> end(length, 0, 0);
    const Vec3<Real> pulled = force * Vec3<Real>(Real(std::cos(angle)), Real(std::sin(angle)), 0);
    const Vec3<Real> found = torque_about(Vec3<Real>::Zero().eval(), end, pulled);
    // A rounded angle near pi moves the sine by its own size over the sine.
    Found("the torque of that pull at " + shown(angle) + " rad", "N m", found.z())
        .must_be(torque, double(torque) * (8 + angle / std::sin(angle)) * 2 * unit_roundoff<Real>);
  }
}

EXERCISE_CHECK("A pull along the spanner is refused, and so is a spanner of no length") {
  require(pull<Real>(40, Real(0.25), right_angle<Real>) > 0,
          "a pull at a right angle turns a spanner, and must get an answer above 0");
  const std::string otherwise =
      "std::invalid_argument is what it should throw, with a sentence that names the value and the "
      "rule";
  ask_refusal("a pull along the spanner, at 0 rad, got an answer. No pull can do it; " + otherwise,
              "pull_needed", Real(40), Real(0.25), Real(0));
  ask_refusal("a spanner of 0 m got an answer; " + otherwise, "pull_needed", Real(40), Real(0),
              right_angle<Real>);
  for (const Real angle : {right_angle<Real>, -right_angle<Real>})
    ask_refusal(
        "a spanner of -0.25 m, pulled at " + shown(angle) + " rad, got an answer; " + otherwise,
        "pull_needed", Real(40), Real(-0.25), angle);
  ask_refusal(
      "a pull at -1 rad, to the other side of the spanner, got an answer. It loosens the bolt; " +
          otherwise,
      "pull_needed", Real(40), Real(0.25), Real(-1));
  ask_refusal(
      "a pull at 4 rad, beyond pi and so to the other side of the spanner, got an answer. It "
      "loosens the bolt; " +
          otherwise,
      "pull_needed", Real(40), Real(0.25), Real(4));
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  ask_refusal(
      "a length that is not a number got an answer: every comparison with NaN is false, so ask "
      "\"unless it is "
      "greater than 0\"; " +
          otherwise,
      "pull_needed", Real(40), nan, right_angle<Real>);
  ask_refusal("an angle that is not a number got an answer; " + otherwise, "pull_needed", Real(40),
              Real(0.25), nan);
}
