#include <exercise/judge.hpp>
#include <tumble/rigid_body.hpp>

using namespace tumble;
using namespace tumble::exercise;

namespace {

const Precondition unit_direction("felt_mass", 2, of_length_one);

/// The lengths and masses below give the inverse of the felt mass no more than 64 roundings, which
/// come from two rotations.
template <class Real>
constexpr double roundings = 128 * unit_roundoff<Real>;

/// A rod along x, 1 m long. About its own line it resists somehow; no blow below asks for it.
template <class Real>
RigidBody<Real> rod(Same<Real> mass) {
  RigidBody<Real> body;
  body.centre = make_particle<Real>(mass);
  body.top.inverse_moments = Vec3<Real>(12 / mass, 12 / mass, 1 / (mass * Real(0.0625)));
  // The body's own line is its z, turned to the world's x.
  body.top.orientation =
      quaternion_of_rotation_vector(Vec3<Real>(0, std::numbers::pi_v<Real> / 2, 0));
  return body;
}

/// Those of two rods, the first with a student's own number: a number by itself fits one alone.
template <class Real>
std::array<Real, 2> two_masses() {
  const Real mass = Real(parameter("rod_mass"));
  return {mass, 2 * mass};
}

template <class Real>
RigidBody<Real> brick(const Vec3<Same<Real>>& position, const Vec3<Same<Real>>& turn) {
  RigidBody<Real> body;
  body.centre = make_particle<Real>(2, position);
  body.top.inverse_moments = Vec3<Real>(Real(0.25), Real(0.5), 2);
  body.top.orientation = quaternion_of_rotation_vector<Real>(turn);
  return body;
}

template <class Real>
Real felt(const RigidBody<Real>& body, const Vec3<Same<Real>>& point,
          const Vec3<Same<Real>>& direction) {
  return ask<Real>("felt_mass", body, point, direction);
}

}  // namespace

EXERCISE_CHECK("Struck through its centre a body feels as heavy as it is") {
  const Vec3<Real> along(1, 0, 0), end(Real(0.5), 0, 0), centre(0, 0, 0), up(0, 0, 1);
  for (const Real mass : two_masses<Real>())
    for (const auto& [point, way] : {std::pair{centre, up}, std::pair{end, along}})
      Found("the mass felt by a blow whose line goes through the centre of a rod of " +
                shown(mass) + " kg",
            "kg", felt(rod<Real>(mass), point, way))
          .mistake(1 / mass, "that is the inverse mass. Invert once more, at the end")
          .mistake(mass / 4,
                   "the body does not turn when the blow goes through its centre. The lever arm is "
                   "r × n, not r")
          .must_be(mass, mass * roundings<Real>);
}

EXERCISE_CHECK("Struck at its end a free rod feels like a quarter of itself") {
  const Vec3<Real> end(Real(0.5), 0, 0);
  for (const Real mass : two_masses<Real>())
    for (const Vec3<Real>& across : {Vec3<Real>(0, 0, 1), Vec3<Real>(0, Real(-0.6), Real(0.8))})
      Found("the mass felt at the end of a rod of " + shown(mass) + " kg, 1 m long,", "kg",
            felt(rod<Real>(mass), end, across))
          .mistake(mass, "the rod also yields by turning")
          .mistake(mass / 3,
                   "a third is the rod on a hinge, or turning alone. It also moves as a "
                   "whole")
          .mistake(mass + mass / 3,
                   "heavier than the whole rod: the masses of moving and of turning were added. "
                   "Add how easily each of them yields, and invert the sum")
          .mistake(1 / (1 / mass + mass / 12 / 4),
                   "the tensor stands where its inverse belongs: a rod that is harder to turn must "
                   "feel heavier")
          .mistake(1 / (1 / mass + 6 / mass), "the lever arm counts with its square")
          .mistake(
              -mass / 2,
              "it is negative: the turn takes away what it should add. The velocity of the turn "
              "is ω × r, with r last")
          .must_be(mass / 4, mass * roundings<Real>);
}

EXERCISE_CHECK(
    "A blow of felt mass times speed gives the point that speed, however the body lies") {
  const Vec3<Real> turn(Real(0.5), -1, Real(0.25)), arm(1, Real(-0.5), 2);
  const Vec3<Real> direction(Real(0.48), Real(0.6), Real(-0.64)), origin(0, 0, 0);
  const Vec3<Real> slanted = turn, unturned(0, 0, 0);
  for (const Vec3<Real>& position : {Vec3<Real>(0, 0, 0), Vec3<Real>(16, -8, 4)})
    for (const Vec3<Real>& way : {unturned, slanted}) {
      auto body = brick<Real>(position, way);
      const Vec3<Real> point = position + arm;
      const Real found = felt(body, point, direction);
      // What the formula would say in other frames, for whoever took one of them.
      const auto formula = [&](const Vec3<Real>& r, const Mat3<Real>& inverse) {
        const Vec3<Real> lever = r.cross(direction);
        return 1 / (body.centre.inverse_mass + lever.dot(inverse * lever));
      };
      const Mat3<Real> in_body = body.top.inverse_moments.asDiagonal();
      const Mat3<Real> R = matrix_of(body.top.orientation), in_world = R * in_body * R.transpose();
      const Mat3<Real> other_way = R.transpose() * in_body * R;
      Found("the mass felt by a slanted blow on a brick of 2 kg", "kg", found)
          .mistake(formula(arm, in_body),
                   "right only as long as the brick is not turned: the inverse moments are those "
                   "about the body's axes, the lever arm is in the world's")
          .mistake(formula(arm, other_way),
                   "the tensor was turned the other way: R I⁻¹ Rᵀ takes in world axes and gives "
                   "world axes")
          .mistake(formula(point, in_world),
                   "right only at the origin: the lever arm begins at the centre of mass")
          .must_be(formula(arm, in_world), 16 * roundings<Real>);
      apply_impulse_at<Real>(body, found * 3 * direction, point);
      Found("the speed of the point along a blow of felt mass times 3 m/s", "m/s",
            velocity_at<Real>(body, point).dot(direction))
          .must_be(3, 64 * roundings<Real>);
    }
}

EXERCISE_CHECK(
    "A wall feels infinitely heavy, and a wheel on a fixed axle resists by its turn alone") {
  RigidBody<Real> wall;
  const Vec3<Real> rim(0, Real(0.5), 0), up(0, 0, 1), along(1, 0, 0);
  const Real found = felt(wall, rim, up);
  require(
      !std::isnan(found),
      "what a wall feels like is not a number. Is something divided by its inverse mass, 0, or by "
      "its inverse moments?");
  require(std::isinf(found) && found > 0, "a wall, whose inverses are all 0, feels like " +
                                              shown(found) + " kg; it must feel infinitely heavy");
  RigidBody<Real> wheel;
  wheel.top.inverse_moments = Vec3<Real>(4, 0, 0);
  Found("the mass felt at the rim of a wheel on a fixed axle, 0.25 kg m² and 0.5 m,", "kg",
        felt(wheel, rim, up))
      .not_a_number("not a number: is something divided by the axle's inverse mass, 0?")
      .mistake(0, "the mass was computed as 1 / inverse_mass and then used")
      .must_be(1, roundings<Real>);
  require(std::isinf(felt(wheel, rim, along)),
          "struck along its axle, a wheel on a fixed axle must feel infinitely heavy");
}
