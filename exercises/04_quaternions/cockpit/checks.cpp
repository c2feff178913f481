#include <exercise/judge.hpp>
#include <tumble/rotation_vector.hpp>

using namespace tumble;
using namespace tumble::exercise;

namespace {

template <class Real>
Quaternion<Real> steered(const Quaternion<Real>& orientation, const Vec3<Same<Real>>& turn) {
  return ask<Quaternion<Real>>("steered", orientation, turn);
}

template <class Real>
Vec3<Real> nose(const Quaternion<Real>& orientation) {
  return ask<Vec3<Real>>("nose", orientation);
}

/// Three products and a rotation, each with less than 40 roundings of numbers up to 1.
template <class Real>
constexpr double roundings = 4 * 40 * unit_roundoff<Real>;

template <class Real>
constexpr Real quarter_turn = std::numbers::pi_v<Real> / 2;

}  // namespace

EXERCISE_CHECK("A roll leaves the nose where it points, whichever way that is") {
  const Vec3<Real> bank(quarter_turn<Real> / 2, 0, 0);
  for (const Vec3<Real>& way :
       {Vec3<Real>(0, Real(-0.7), 0), Vec3<Real>(0, 0, 2), Vec3<Real>(Real(0.3), Real(-0.5), 1)}) {
    const Quaternion<Real> start = quaternion_of_rotation_vector(way);
    const Vec3<Real> before = rotate(start, Vec3<Real>(1, 0, 0));
    const Quaternion<Real> rolled = steered(start, bank);
    const Vec3<Real> wing(0, 1, 0);
    require((rotate(rolled, wing) - rotate(start, wing)).norm() > Real(0.5),
            "after a roll by 45° the left wing points where it did before: nothing has rolled");
    Found("the nose after a roll by 45°", "", nose(rolled))
        .mistake(rotate(quaternion_of_rotation_vector(bank), before),
                 "it went round the world's x axis. The pilot rolls about the aeroplane's own: on "
                 "which side of the product do turns in body axes stand?")
        .must_be(before, roundings<Real>);
  }
}

EXERCISE_CHECK("Pulling the stick lifts the nose towards the pilot's head, not towards the sky") {
  const Real pull = Real(parameter("pull") * std::numbers::pi / 180);
  // On its back: rolled by half a turn, the head points to the ground.
  const Quaternion<Real> on_its_back{.real = 0, .imaginary = Vec3<Real>(1, 0, 0)};
  // Turned about y, the right-handed way, x goes down. So a pull is negative.
  const auto pulled = steered(on_its_back, Vec3<Real>(0, -pull, 0));
  Found("the nose of an aeroplane on its back after a pull by " + shown(parameter("pull")) + "°",
        "", nose(pulled))
      .mistake(Vec3<Real>(std::cos(pull), 0, std::sin(pull)),
               "it rose to the sky. For a pilot who hangs head down, a pull leads to the ground")
      .mistake(Vec3<Real>(1, 0, 0), "it has not moved")
      .must_be(Vec3<Real>(std::cos(pull), 0, -std::sin(pull)), roundings<Real>);
  // On its back a turn in body axes is the same as one in the world's axes backwards. On its side,
  // rolled to the right by a quarter, the head points to minus y.
  const auto on_its_side = quaternion_of_rotation_vector(Vec3<Real>(quarter_turn<Real>, 0, 0));
  Found("the nose of an aeroplane on its right side after such a pull", "",
        nose(steered(on_its_side, Vec3<Real>(0, -pull, 0))))
      .mistake(Vec3<Real>(std::cos(pull), 0, -std::sin(pull)),
               "it went down, about an axis of the world and backwards. The pilot turns about the "
               "aeroplane's own")
      .must_be(Vec3<Real>(std::cos(pull), -std::sin(pull), 0), roundings<Real>);
}

EXERCISE_CHECK("Roll, pull, roll back: the nose has gone sideways") {
  const Real pull = Real(parameter("pull") * std::numbers::pi / 180);
  Quaternion<Real> aeroplane;
  aeroplane = steered(aeroplane, Vec3<Real>(quarter_turn<Real>, 0, 0));
  aeroplane = steered(aeroplane, Vec3<Real>(0, -pull, 0));
  aeroplane = steered(aeroplane, Vec3<Real>(-quarter_turn<Real>, 0, 0));
  // To the right, the way of minus y: the left wing is up when the aeroplane is rolled to the
  // right.
  Found("the nose after a roll to the right, a pull and the roll back", "", nose(aeroplane))
      .mistake(Vec3<Real>(std::cos(pull), std::sin(pull), 0),
               "it went to the left. Each turn was made about the world's axes")
      .mistake(Vec3<Real>(std::cos(pull), 0, std::sin(pull)),
               "it rose, as if the roll had not been there")
      .must_be(Vec3<Real>(std::cos(pull), -std::sin(pull), 0), roundings<Real>);
}

EXERCISE_CHECK(
    "A stick pushed every way at once is one turn, about an axis of the aeroplane's own") {
  const Vec3<Real> turn(Real(0.5), Real(-0.75), 1);
  const double angle = std::sqrt(0.25 + 0.5625 + 1);
  // Rodrigues: of the nose (1, 0, 0), what lies along the axis n stays, and the rest goes round.
  const Vec3d n = turn.template cast<double>() / angle, x(1, 0, 0);
  const Vec3d along = n.x() * n,
              level = std::cos(angle) * (x - along) + std::sin(angle) * n.cross(x) + along;
  Quaternion<Real> in_three_turns;
  for (int axis = 0; axis < 3; ++axis)
    in_three_turns =
        in_three_turns * quaternion_of_rotation_vector<Real>(turn[axis] * Vec3<Real>::Unit(axis));
  const auto upright = quaternion_of_rotation_vector(Vec3<Real>(0, -quarter_turn<Real>, 0));
  Found("the nose of a level aeroplane after the turn (0.5, -0.75, 1) rad", "",
        nose(steered(Quaternion<Real>{}, turn)))
      .mistake(rotate(in_three_turns, Vec3<Real>(1, 0, 0)),
               "that is a roll, a pull and a turn to the side, one after another. A rotation "
               "vector is one turn, about the "
               "axis along which it points")
      .must_be(Vec3<Real>(level.cast<Real>()), roundings<Real>);
  // Standing on its tail, it sees the world's z where x was, and minus x where z was.
  Found("the nose of an aeroplane on its tail after the turn (0.5, -0.75, 1) rad", "",
        nose(steered(upright, turn)))
      .must_be(Vec3<Real>(Vec3d(-level.z(), level.y(), level.x()).cast<Real>()), roundings<Real>);
}
